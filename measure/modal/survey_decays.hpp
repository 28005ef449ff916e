#pragma once

#include <cstddef>
#include <vector>

#include "measure/modal/modal_survey.hpp"
#include "measure/modal/survey_records.hpp"

namespace secular {

/// The poles that the free decays of one band show and support: fills the diagram and the dropped poles. `slower`:
/// what stands in slower bands, moves here as well and is fitted along among the others.
void find_poles(ModalSurvey& survey, const SurveyRecords& records, const std::vector<StableMode>& slower);

/// What follows where a --window does not fit: an error, or a warning and the values of one fit.
enum class WindowMisfit { refused, warned };

/// Frequency and damping of the survey's modes against amplitude, window by window. Where there were no impacts the
/// modes are those of the diagram, begun here. What is wrong with a mode becomes its remark. Throws InputError for
/// a
/// --window that does not fit and is refused.
void follow_decays(ModalSurvey& survey, SurveyRecords& records, WindowMisfit misfit = WindowMisfit::refused);

/// Fills the survey's spectrum: of its decays, at the rate of its band.
void store_spectrum(ModalSurvey& survey, SurveyRecords& records);

}  // namespace secular

#pragma once

#include <cstddef>
#include <vector>

#include "measure/modal/modal_survey.hpp"
#include "measure/modal/survey_records.hpp"

namespace secular {

/// The poles that the free decays of one band show and support: fills the diagram and the dropped poles. `slower`:
/// what stands in slower bands, moves here as well and is fitted along among the others.
void find_poles(ModalSurvey& survey, const SurveyRecords& records, const std::vector<StableMode>& slower);

/// Frequency and damping of the survey's modes against amplitude, window by window, and the spectrum. Where there
/// were no impacts the modes are those of the diagram, begun here. `slower`: so many modes come before, in
/// warnings. Throws InputError for a --window that does not fit.
void follow_decays(ModalSurvey& survey, SurveyRecords& records, std::size_t slower);

}  // namespace secular

#pragma once

#include <Eigen/Core>
#include <vector>

#include "measure/modal/modal_survey.hpp"
#include "measure/modal/survey_records.hpp"

namespace secular {

/// Of a survey; no upper limit where the highest frequency is zero.
struct SurveyBand {
  double lowest_hz = 0, highest_hz = 0;
};

/// Bands of a survey from `lowest_hz` to `highest_hz` (zero: no limit), slowest first. A realization takes some
/// thousand rows from where motion begins: of a long record that is sampled fast these are a few turns of its slow
/// modes, beside which all others are stronger. So what is longer than most_decay_rows is looked at again at a
/// fourth of the rate, for modes up to 0.8 of half of that, and so on, until all of it is. Neighbours overlap by a
/// twentieth. `rows`, `rate_hz`: of the longest decay at the rate of the fastest band.
std::vector<SurveyBand> survey_bands(Eigen::Index rows, double rate_hz, double lowest_hz, double highest_hz);

/// What free decays say of a survey, band by band; beside impacts, frequency and damping of their modes against
/// amplitude. `records`: of the survey's whole band. Throws InputError for a --window that does not fit.
void survey_decays(ModalSurvey& survey, SurveyRecords& records);

}  // namespace secular

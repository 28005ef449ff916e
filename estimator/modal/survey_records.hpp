#pragma once

#include <Eigen/Core>
#include <vector>

#include "estimator/modal/frequency_response.hpp"
#include "estimator/modal/modal_survey.hpp"

namespace secular {

/// One free decay, filtered down to the band, from where the structure swings freely.
struct SurveyDecay {
  std::size_t record = 0;
  double start_s = 0;       ///< record time of the first row
  Eigen::MatrixXd samples;  ///< rows x responses
  double sample_rate_hz = 0;
};

struct SurveyImpacts {
  std::string group;
  std::vector<ImpactBlock> blocks;
};

struct SurveyRecords {
  std::vector<SurveyDecay> decays;
  std::vector<SurveyImpacts> impacts;
  double impact_rate_hz = 0;
};

/// Reads the records that the options choose. Fills channels, form, unit and warnings of the survey. Throws
/// InputError.
SurveyRecords survey_records(ModalSurvey& survey);

}  // namespace secular

#pragma once

#include <string>

#include "measure/modal/modal_survey.hpp"
#include "measure/observe/observation_set.hpp"

namespace secular {

/// The job `modal`: a survey of the records and the band that `window` leaves, see modal_survey(). `options`: all
/// the rest. Throws InputError and NumericalFailure.
ModalSurvey run_modal(const Campaign& campaign, const Window& window, ModalSurveyOptions options);

/// "CHANNEL": blows of a group strike where this response is; "-CHANNEL": against it.
DrivingPoint driving_point_of(const std::string& text);

}  // namespace secular

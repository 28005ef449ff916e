#pragma once

#include <string>

#include "measure/modal/modal_survey.hpp"

namespace secular::app {

/// report.html of a survey; `command` is the line that made it.
std::string modal_report(const ModalSurvey& survey, const std::string& command);

}  // namespace secular::app

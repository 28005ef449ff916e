#pragma once

#include <string>
#include <vector>

#include "measure/modal/modal_survey.hpp"
#include "report/figure.hpp"

namespace secular {

/// The figures of the report: stabilisation, shapes, amplitude_MODE, response_GROUP.
std::vector<report::NamedFigure> modal_figures(const ModalSurvey& survey);

/// report.html of a survey; `command` is the line that made it.
std::string modal_report(const ModalSurvey& survey, const std::string& command);

}  // namespace secular

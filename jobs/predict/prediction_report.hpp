#pragma once

#include <string>
#include <vector>

#include "jobs/predict/prediction.hpp"
#include "report/figure.hpp"

namespace secular {

/// The figures of a run of `predict`: response and phases; or plane and amplitude of curves in two parameters; or a
/// backbone for every mode.
std::vector<report::NamedFigure> prediction_figures(const Prediction& prediction);

/// The self-contained HTML report of a run of `predict` with its figures; `command` is how it was started.
std::string prediction_report(const Prediction& prediction, const std::vector<report::NamedFigure>& figures,
                              const std::string& command);

}  // namespace secular

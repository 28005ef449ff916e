#pragma once

#include <string>
#include <vector>

#include "app/predict/prediction.hpp"
#include "report/figure.hpp"

namespace secular::app {

struct PredictionFigure {
  std::string name;  ///< of its file, without .svg
  report::Figure figure;
  std::string caption;
};

/// The figures of a run of `predict`: response and phases; or plane and amplitude of curves in two parameters; or a
/// backbone for every mode.
std::vector<PredictionFigure> prediction_figures(const Prediction& prediction);

/// The self-contained HTML report of a run of `predict` with its figures; `command` is how it was started.
std::string prediction_report(const Prediction& prediction, const std::vector<PredictionFigure>& figures,
                              const std::string& command);

}  // namespace secular::app

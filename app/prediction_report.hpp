#pragma once

#include <string>

#include "app/prediction.hpp"

namespace secular::app {

/// The self-contained HTML report of a run of `predict`; `command` is how it was started.
std::string prediction_report(const Prediction& prediction, const std::string& command);

}  // namespace secular::app

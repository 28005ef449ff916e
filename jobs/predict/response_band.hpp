#pragma once

#include <cstddef>
#include <optional>

#include "jobs/predict/prediction.hpp"
#include "report/figure.hpp"

namespace secular {

/// What the band of a figure is, for its legend.
inline constexpr const char* band_name = "two sd of the parameters' error bars";

/// The strip of two standard deviations on both sides of the response curves of one mode, across the curve
/// (CurveSpread), which holds where curves turn back, too. Peak amplitudes over printed values of the varied
/// parameter. Nothing where no point has an error bar.
std::optional<report::Series> response_band(const Prediction& prediction, std::size_t mode);

}  // namespace secular

#pragma once

#include "motion/response/response_curve.hpp"

namespace secular {

/// Largest amplitudes |B| of `mode` over the parameter of `response`, and where they go with a second parameter.
struct PeakRequest {
  ResponseRequest response;
  Eigen::Index second = 0;
  double second_lower = 0, second_upper = 1;
  std::size_t mode = 0;
  double scale = 1;  ///< typical amplitude
};

/// The curve of peaks through `start` in both parameters, traced both ways: f = 0 and d |B|^2 / d p = 0 along the
/// branch f = 0 in the first one.
ResponseCurve peak_curve(const ResponseField& field, const PeakRequest& request, const ResponsePoint& start);

}  // namespace secular

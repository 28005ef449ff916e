#pragma once

#include <Eigen/Core>
#include <complex>
#include <vector>

namespace secular::testing_support {

/// Tables 2.3 to 2.5 as printed: what Eqs. (2.15) to (2.20) start from.
struct TwoMassTables {
  Eigen::Matrix3d shapes;             ///< real means of Table 2.5, Eq. (2.16)
  Eigen::Vector3d masses;             ///< averages of Table 2.3, kg
  Eigen::Vector3d frequency_hz;       ///< intercepts of Table 2.4: damped natural frequencies
  Eigen::Vector3d damping_factor_hz;  ///< intercepts of Table 2.4
};

inline TwoMassTables two_mass_tables() {
  TwoMassTables t;
  t.shapes << 0.8391, -0.5329, 0.0076, 0.5305, 0.8460, -0.0120, -0.1207, 0.0169, 0.9999;
  t.masses << 0.523, 0.548, 0.523;
  t.frequency_hz << 12.419, 33.319, 39.305;
  t.damping_factor_hz << -0.0456, -0.0472, -0.0858;
  return t;
}

}  // namespace secular::testing_support

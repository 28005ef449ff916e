#pragma once

#include <Eigen/Core>
#include <numbers>
#include <string_view>

#include "estimator/model/by_name.hpp"
#include "generated/registry.hpp"

// The first mode of the thesis's structure in principal parametric resonance, with the numbers of Table 5.4.
namespace secular::testing_support::table_5_4 {

inline const CompiledModel& model() {
  return *generated::find_compiled_model("two_mass_mode1");
}
inline const CompiledCase& resonance() {
  return case_named(model(), "principal_parametric");
}

inline Eigen::Index symbol(std::string_view name) {
  return static_cast<Eigen::Index>(symbol_named(model(), name));
}

inline const double omega0 = 2 * std::numbers::pi * 12.39;
inline constexpr double mu1 = 0.222, mu2 = 4.06, mu3 = 36.87, alpha_e = -10.62e6, eta_e = 1.922;

/// With cubic damping.
inline Eigen::VectorXd parameters() {
  Eigen::VectorXd p = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(model().symbols.size()));
  p(symbol("omega0")) = omega0;
  p(symbol("mu1")) = mu1;
  p(symbol("mu3")) = mu3;
  p(symbol("alpha3")) = 8 * alpha_e / 3;
  p(symbol("eta2")) = 4 * eta_e;
  return p;
}

}  // namespace secular::testing_support::table_5_4

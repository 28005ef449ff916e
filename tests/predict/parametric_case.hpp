#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string_view>

#include "generated/registry.hpp"
#include "motion/response/response_curve.hpp"

/// The principal parametric resonance of the thesis's Table 5.4, of which everything is known in closed form.
namespace secular::testing_support {

inline const CompiledModel& two_mass() {
  return *generated::find_compiled_model("two_mass_mode1");
}

inline Eigen::Index place(const CompiledModel& model, std::string_view name) {
  const auto names = ResponseField::parameter_names(model);
  return std::find(names.begin(), names.end(), name) - names.begin();
}

// Thesis Table 5.4: frequency-response equation (alpha_e a^2 - omega0 sigma/2)^2 + D^2 = (eta_e F)^2 with
// D = omega0 mu1 + kappa a^2.
struct Parametric {
  double omega0 = 2 * std::numbers::pi * 12.39, mu1 = 0.222, mu3 = 36.87, alpha_e = -10.62e6, eta_e = 1.922,
         F = 22.55;

  double kappa() const { return 3.0 / 8 * std::pow(omega0, 3) * mu3; }
  double relation(double a, double Omega, double force) const {
    const double sigma = Omega - 2 * omega0;
    return (std::pow(alpha_e * a * a - omega0 * sigma / 2, 2) + std::pow(omega0 * mu1 + kappa() * a * a, 2)) /
           std::pow(eta_e * force, 2);
  }
  double threshold_detuning(double force) const {
    return 2 / omega0 * std::sqrt(std::pow(eta_e * force, 2) - std::pow(omega0 * mu1, 2));
  }
  Eigen::VectorXd parameters() const {
    const CompiledModel& model = two_mass();
    Eigen::VectorXd p =
        Eigen::VectorXd::Zero(static_cast<Eigen::Index>(ResponseField::parameter_names(model).size()));
    p(place(model, "omega0")) = omega0;
    p(place(model, "mu1")) = mu1;
    p(place(model, "mu3")) = mu3;
    p(place(model, "alpha3")) = 8 * alpha_e / 3;
    p(place(model, "eta2")) = 4 * eta_e;
    p(place(model, "Omega")) = 2 * omega0;
    p(place(model, "F")) = F;
    return p;
  }
  ResponseRequest request() const {
    ResponseRequest r;
    r.parameters = parameters();
    r.parameter = place(two_mass(), "Omega");
    r.lower = 2 * omega0 - 3;
    r.upper = 2 * omega0 + 2;
    return r;
  }
};

}  // namespace secular::testing_support

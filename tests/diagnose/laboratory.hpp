#pragma once

#include <string>
#include <utility>

#include "diagnose/evidence/condition_rows.hpp"
#include "generated/registry.hpp"
#include "tests/diagnose/symbol_of.hpp"

namespace secular::testing_support {

inline constexpr double natural = 80, damping = 0.4, direct = -0.02;

/// One accelerometer on one mode, the base's acceleration measured.
inline SensorModel one_accelerometer() {
  SensorModel sensors;
  sensors.responses = {1};
  sensors.excitations = {0};
  sensors.response_names = {"v"};
  sensors.excitation_names = {"base"};
  sensors.shapes = sensors.filter = Eigen::MatrixXd::Ones(1, 1);
  sensors.derivatives = sensors.excitation_derivatives = 2;
  return sensors;
}

/// One mode of the two-mass structure, and dwells on it at primary resonance.
struct Laboratory {
  const CompiledModel& compiled = *generated::find_compiled_model("two_mass_mode1");
  SensorModel sensors = one_accelerometer();
  FaultTable faults{compiled, sensors};
  ConditionModel model{MotionBalance(compiled, {}), sensors, faults};

  std::size_t symbol(const std::string& name) const { return testing_support::symbol_of(compiled, name); }
  Eigen::VectorXd unknowns(std::initializer_list<std::pair<const char*, double>> more) const {
    Eigen::VectorXd values =
        Eigen::VectorXd::Zero(static_cast<Eigen::Index>(compiled.symbols.size() + faults.size()));
    const auto set = [&](const std::string& name, double value) {
      values(static_cast<Eigen::Index>(symbol(name))) = value;
    };
    set("omega0", natural);
    set("mu1", damping);
    set("eta1", direct);
    for (const auto& [name, value] : more) set(name, value);
    const auto first = static_cast<Eigen::Index>(compiled.symbols.size());
    values(first + static_cast<Eigen::Index>(faults.extra_frequency())) = natural;
    values(first + static_cast<Eigen::Index>(faults.extra_damping())) = 0.01;
    return values;
  }

  /// A dwell at primary resonance whose measured lines are those of `amplitude` (half of the peak displacement).
  Condition dwell(double frequency, double force, std::complex<double> amplitude) const {
    Condition c;
    c.torus = std::make_shared<const Torus>(1, 5, 64);
    c.rate = {std::complex<double>(0, frequency), std::complex<double>(0)};
    c.masters = {{0, 1}};
    c.fundamental = 1;
    c.lines = {1, 2, 3};
    c.response = Eigen::MatrixXcd::Zero(1, 3);
    c.response(0, 0) = -frequency * frequency * amplitude;
    c.response_sd = Eigen::MatrixXd::Constant(1, 3, 1e-3);
    c.excitation_lines = {1};
    c.excitation = Eigen::MatrixXcd::Constant(1, 1, force / 2);
    c.excitation_sd = Eigen::MatrixXd::Constant(1, 1, 1e-4);
    return c;
  }
};

}  // namespace secular::testing_support

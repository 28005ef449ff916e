#pragma once

#include <string>
#include <utility>
#include <vector>

#include "diagnose/evidence/condition_rows.hpp"
#include "estimator/model/by_name.hpp"
#include "generated/registry.hpp"

namespace secular::testing_support {

inline constexpr double natural = 80, damping = 0.4, direct = -0.02;

/// One sensor on one mode, without an excitation.
inline SensorModel one_sensor(const std::string& name, int derivatives = 0) {
  SensorModel sensors;
  sensors.responses = {0};
  sensors.response_names = {name};
  sensors.shapes = sensors.filter = Eigen::MatrixXd::Ones(1, 1);
  sensors.derivatives = derivatives;
  return sensors;
}

/// One accelerometer on one mode, the base's acceleration measured.
inline SensorModel one_accelerometer() {
  SensorModel sensors = one_sensor("v", 2);
  sensors.responses = {1};
  sensors.excitations = {0};
  sensors.excitation_names = {"base"};
  sensors.excitation_derivatives = 2;
  return sensors;
}

/// Unknowns of a model of one mode: these symbols, all others and the faults zero; a mode beyond the model, if
/// there were one, at the same frequency.
inline Eigen::VectorXd unknowns_of(const CompiledModel& model, const FaultTable& faults,
                                   const std::vector<std::pair<const char*, double>>& symbols) {
  const auto first = static_cast<Eigen::Index>(model.symbols.size());
  Eigen::VectorXd values = Eigen::VectorXd::Zero(first + static_cast<Eigen::Index>(faults.size()));
  for (const auto& [name, value] : symbols) values(static_cast<Eigen::Index>(symbol_named(model, name))) = value;
  values(first + static_cast<Eigen::Index>(faults.extra_frequency())) = values(0);
  values(first + static_cast<Eigen::Index>(faults.extra_damping())) = 0.01;
  return values;
}

/// One mode of the two-mass structure, and dwells on it at primary resonance.
struct Laboratory {
  const CompiledModel& compiled = *generated::find_compiled_model("two_mass_mode1");
  SensorModel sensors = one_accelerometer();
  FaultTable faults{compiled, sensors};
  ConditionModel model{MotionBalance(compiled, {}), sensors, faults};

  std::size_t symbol(const std::string& name) const { return symbol_named(compiled, name); }
  Eigen::VectorXd unknowns(std::initializer_list<std::pair<const char*, double>> more) const {
    std::vector<std::pair<const char*, double>> symbols{{"omega0", natural}, {"mu1", damping}, {"eta1", direct}};
    symbols.insert(symbols.end(), more.begin(), more.end());
    return unknowns_of(compiled, faults, symbols);
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

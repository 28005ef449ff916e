#include "codegen/cpp/monomial_code.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <vector>

#include "codegen/expression/cpp_expression.hpp"

namespace secular {

std::string MonomialCode::product(const CanonicalPowers& powers, bool& real) {
  std::vector<std::string> factors;
  real = true;
  const auto add = [&](const std::string& name, int power, bool is_real) {
    if (power > 0) real = real && is_real;
    if (power > 3)
      factors.push_back(fmt::format("fixed_power<{}>({})", power, name));
    else
      for (int i = 0; i < power; ++i) factors.push_back(name);
  };
  for (std::size_t k = 0; k < model_.coordinates.size(); ++k) {
    const std::string name = "A_" + model_.coordinates[k];
    const int pairs = std::min(powers.amplitude[k], powers.conjugate[k]);
    // A/|A| is a direction of length one: safe at zero, exact in any power.
    const int turned = powers.amplitude[k] - pairs, returned = powers.conjugate[k] - pairs;
    const int directions = std::min(std::max(turned, returned), std::max(0, -powers.modulus[k]));
    const int forward = turned > returned ? turned - directions : 0;
    const int backward = returned > turned ? returned - directions : 0;
    const int modulus = powers.modulus[k] + directions;
    if (forward) amplitude_.insert(k);
    if (backward) conjugate_.insert(k);
    if (pairs) norm_.insert(k);
    if (modulus > 0) modulus_.insert(k);
    if (modulus < 0) inverse_modulus_.insert(k);
    if (directions) direction_.insert(k);
    add("norm_" + name, pairs, true);
    add("abs_" + name, std::max(0, modulus), true);
    add("inverse_abs_" + name, std::max(0, -modulus), true);
    add(turned > returned ? "unit_" + name : "conjugate(unit_" + name + ")", directions, false);
    add(name, forward, false);
    add("conj_" + name, backward, false);
  }
  for (std::size_t j = 0; j < model_.excitations.size(); ++j) {
    const std::string name = safe_identifier(model_.excitations[j]);
    const int net = powers.phase[model_.coordinates.size() + j], total = powers.forcing[j];
    const int pairs = (total - std::abs(net)) / 2;
    if (pairs) forcing_norm_.insert(j);
    if (net > 0) forcing_.insert(j);
    if (net < 0) forcing_conjugate_.insert(j);
    add("norm_" + name, pairs, true);
    add(net > 0 ? name : "conj_" + name, std::abs(net), false);
  }
  return fmt::format("{}", fmt::join(factors, " * "));
}

bool MonomialCode::uses_amplitude(std::size_t mode) const {
  const auto all = {&amplitude_, &conjugate_, &norm_, &modulus_, &inverse_modulus_, &direction_};
  return std::any_of(all.begin(), all.end(), [&](const auto* set) { return set->count(mode) != 0; });
}

bool MonomialCode::uses_forcing(std::size_t excitation) const {
  return forcing_.count(excitation) || forcing_norm_.count(excitation) || forcing_conjugate_.count(excitation);
}

bool MonomialCode::uses_any() const {
  return !signals().empty();
}

std::vector<MonomialCode::Signal> MonomialCode::signals() const {
  std::vector<Signal> list;
  const auto add = [&](bool needed, const char* type, const std::string& name, const std::string& value) {
    if (needed) list.push_back({type, name, value});
  };
  for (std::size_t k = 0; k < model_.coordinates.size(); ++k) {
    const std::string name = "A_" + model_.coordinates[k];
    const bool inverse = inverse_modulus_.count(k) || direction_.count(k);
    add(uses_amplitude(k), "Complex", name, fmt::format("amplitude[{}]", k));
    add(conjugate_.count(k), "Complex", "conj_" + name, "conjugate(" + name + ")");
    add(norm_.count(k), "Number", "norm_" + name, "norm_of(" + name + ")");
    add(modulus_.count(k) || inverse, "Number", "abs_" + name, "modulus_of(" + name + ")");
    add(inverse, "Number", "inverse_abs_" + name, "inverse_or_zero(abs_" + name + ")");
    add(direction_.count(k), "Complex", "unit_" + name, fmt::format("inverse_abs_{0} * {0}", name));
  }
  for (std::size_t j = 0; j < model_.excitations.size(); ++j) {
    const std::string name = safe_identifier(model_.excitations[j]);
    add(uses_forcing(j), "Complex", name, fmt::format("forcing[{}]", j));
    add(forcing_conjugate_.count(j), "Complex", "conj_" + name, "conjugate(" + name + ")");
    add(forcing_norm_.count(j), "Number", "norm_" + name, "norm_of(" + name + ")");
  }
  return list;
}

std::vector<std::string> MonomialCode::names() const {
  std::vector<std::string> result;
  for (const Signal& signal : signals()) result.push_back(signal.name);
  return result;
}

void MonomialCode::declare(CodeText& code) const {
  std::vector<std::string> given;
  for (const Signal& signal : signals()) {
    const bool from_array = signal.value.back() == ']';
    if (from_array) given.push_back(fmt::format("{}({})", signal.name, signal.value));
    code.line(from_array ? fmt::format("const {} {};", signal.type, signal.name)
                         : fmt::format("const {} {} = {};", signal.type, signal.name, signal.value));
  }
  code.list(
      "Signals(const Complex* amplitude, [[maybe_unused]] const Complex* "
      "forcing)" +
          std::string(given.empty() ? "" : " : "),
      given, " {}");
}

}  // namespace secular

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
  products_ += std::max(0, static_cast<int>(factors.size()) - 1);
  return fmt::format("{}", fmt::join(factors, " * "));
}

bool MonomialCode::uses_amplitude(std::size_t mode) const {
  const auto all = {&amplitude_, &conjugate_, &norm_, &modulus_, &inverse_modulus_, &direction_};
  return std::any_of(all.begin(), all.end(), [&](const auto* set) { return set->count(mode) != 0; });
}

bool MonomialCode::uses_forcing(std::size_t excitation) const {
  return forcing_.count(excitation) || forcing_norm_.count(excitation) || forcing_conjugate_.count(excitation);
}

void MonomialCode::declare(CodeText& code, const std::string& index) const {
  const auto load = [&](const char* array, std::size_t number) {
    return index.empty() ? fmt::format("load_complex({}, {})", array, number)
                         : fmt::format("load_complex({}_{}, {})", array, number, index);
  };
  for (std::size_t k = 0; k < model_.coordinates.size(); ++k) {
    if (!uses_amplitude(k)) continue;
    const std::string name = "A_" + model_.coordinates[k];
    const bool inverse = inverse_modulus_.count(k) || direction_.count(k);
    code.line(fmt::format("const Complex {} = {};", name, load("amplitude", k)));
    if (conjugate_.count(k)) code.line(fmt::format("const Complex conj_{0} = conjugate({0});", name));
    if (norm_.count(k)) code.line(fmt::format("const Scalar norm_{0} = norm_of({0});", name));
    if (modulus_.count(k) || inverse) code.line(fmt::format("const Scalar abs_{0} = modulus_of({0});", name));
    if (inverse) code.line(fmt::format("const Scalar inverse_abs_{0} = inverse_or_zero(abs_{0});", name));
    if (direction_.count(k)) code.line(fmt::format("const Complex unit_{0} = inverse_abs_{0} * {0};", name));
  }
  for (std::size_t j = 0; j < model_.excitations.size(); ++j) {
    if (!uses_forcing(j)) continue;
    const std::string name = safe_identifier(model_.excitations[j]);
    code.line(fmt::format("const Complex {} = {};", name, load("forcing", j)));
    if (forcing_conjugate_.count(j)) code.line(fmt::format("const Complex conj_{0} = conjugate({0});", name));
    if (forcing_norm_.count(j)) code.line(fmt::format("const Scalar norm_{0} = norm_of({0});", name));
  }
}

}  // namespace secular

#include "codegen/frequency_response.hpp"

#include <fmt/format.h>

#include <array>
#include <cstdlib>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "codegen/cpp_expression.hpp"
#include "codegen/polar_form.hpp"

namespace secular {
namespace {

// w_k - omega_k as text.
std::string frame_offset(const CanonicalModel& model, const CanonicalCase& c, std::size_t mode) {
  std::string text;
  for (std::size_t i = 0; i < c.observed_frequency[mode].size(); ++i) {
    CanonicalRatio r = c.observed_frequency[mode][i];
    if (i == mode) r.numerator -= r.denominator;
    if (r.numerator == 0) continue;
    text += fmt::format("{}{}{}{}", r.numerator < 0 ? (text.empty() ? "-" : " - ") : (text.empty() ? "" : " + "),
                        std::abs(r.numerator) == 1 ? "" : std::to_string(std::abs(r.numerator)) + "*",
                        model.frequency_name(i), r.denominator == 1 ? "" : "/" + std::to_string(r.denominator));
  }
  return text;
}

// Sum of coefficient * rest with signs drawn out.
class TextSum {
 public:
  explicit TextSum(const SymbolOrder& order) : order_(order) {}
  void add(const RationalFunction& coefficient, const std::string& rest) {
    if (coefficient.is_zero()) return;
    const bool negative =
        coefficient.numerator.size() == 1 && coefficient.numerator.front().coefficient.front() == '-';
    const RationalFunction magnitude = negative ? scaled(coefficient, -1, 1) : coefficient;
    std::string text = formula_text(magnitude, order_);
    if (!rest.empty() && magnitude.is_one())
      text = rest;
    else if (!rest.empty())
      text = (magnitude.numerator.size() > 1 && magnitude.denominator.front().coefficient == "1" &&
                      magnitude.denominator_is_number()
                  ? "(" + text + ")"
                  : text) +
             "*" + rest;
    add_text(text, negative);
  }
  void add_text(const std::string& text, bool negative) {
    sum_ += (sum_.empty() ? (negative ? "-" : "") : (negative ? " - " : " + ")) + text;
  }
  std::string text() const { return sum_.empty() ? "0" : sum_; }
  bool empty() const { return sum_.empty(); }

 private:
  const SymbolOrder& order_;
  std::string sum_;
};

void multiply(std::string& product, const std::string& base, int power) {
  if (power != 0) product += (product.empty() ? "" : "*") + base + (power == 1 ? "" : "^" + std::to_string(power));
}

// Real and imaginary part of a monomial in A = (x + i y)/2, as integer polynomials in x_k, y_k times a common
// factor.
struct CartesianMonomial {
  std::array<std::map<std::vector<int>, long>, 2> part;  // [real, imaginary]: powers x_0, y_0, x_1, ... -> integer
  std::string common;                                    // norms, moduli, forcing
  int halves = 0;                                        // times 2^-halves
};

CartesianMonomial cartesian(const CanonicalModel& model, const CanonicalPowers& powers) {
  CartesianMonomial result;
  const std::size_t modes = model.coordinates.size();
  std::map<std::vector<int>, std::pair<long, long>> polynomial{{std::vector<int>(2 * modes, 0), {1, 0}}};
  for (std::size_t k = 0; k < modes; ++k) {
    const int pairs = std::min(powers.amplitude[k], powers.conjugate[k]);
    const std::string& v = model.coordinates[k];
    multiply(result.common, fmt::format("(x_{0}^2 + y_{0}^2)", v), pairs);
    multiply(result.common, fmt::format("sqrt(x_{0}^2 + y_{0}^2)", v), powers.modulus[k]);
    result.halves += powers.amplitude[k] + powers.conjugate[k] + powers.modulus[k];
    const int forward = powers.amplitude[k] - pairs, backward = powers.conjugate[k] - pairs;
    for (int n = 0; n < forward + backward; ++n) {
      const long sign = n < forward ? 1 : -1;
      std::map<std::vector<int>, std::pair<long, long>> product;
      for (const auto& [exponents, value] : polynomial) {
        std::vector<int> with_x = exponents, with_y = exponents;
        ++with_x[2 * k];
        ++with_y[2 * k + 1];
        auto& x = product[with_x];
        x = {x.first + value.first, x.second + value.second};
        auto& y = product[with_y];  // times +-i
        y = {y.first - sign * value.second, y.second + sign * value.first};
      }
      polynomial = std::move(product);
    }
  }
  for (std::size_t j = 0; j < model.excitations.size(); ++j)
    multiply(result.common, model.excitations[j], powers.forcing[j]);
  for (const auto& [exponents, value] : polynomial) {
    if (value.first != 0) result.part[0][exponents] = value.first;
    if (value.second != 0) result.part[1][exponents] = value.second;
  }
  return result;
}

std::string cartesian_rest(const CanonicalModel& model, const CartesianMonomial& m,
                           const std::vector<int>& exponents) {
  std::string rest = m.common;
  for (std::size_t k = 0; k < model.coordinates.size(); ++k) {
    multiply(rest, "x_" + model.coordinates[k], exponents[2 * k]);
    multiply(rest, "y_" + model.coordinates[k], exponents[2 * k + 1]);
  }
  return rest;
}

}  // namespace

std::string cartesian_text(const CanonicalModel& model, const CanonicalCase& c) {
  std::string text = "\nCartesian form, B = (x + i*y)/2 in the observed frame\n";
  for (std::size_t k = 0; k < model.coordinates.size(); ++k) {
    TextSum dx(model.order), dy(model.order);
    const std::string offset = frame_offset(model, c, k);
    if (!offset.empty()) {
      dx.add_text("(" + offset + ")*y_" + model.coordinates[k], false);
      dy.add_text("(" + offset + ")*x_" + model.coordinates[k], true);
    }
    for (const CanonicalTerm& term : c.slow_derivative[k]) {
      const CartesianMonomial m = cartesian(model, term.powers);
      // d(x + i y)/dt = 2 (real + i imaginary) * monomial
      const long up = m.halves < 1 ? 1L << (1 - m.halves) : 1, down = m.halves > 1 ? 1L << (m.halves - 1) : 1;
      for (const auto& [exponents, value] : m.part[0]) {
        dx.add(scaled(term.real, value * up, down), cartesian_rest(model, m, exponents));
        dy.add(scaled(term.imaginary, value * up, down), cartesian_rest(model, m, exponents));
      }
      for (const auto& [exponents, value] : m.part[1]) {
        dx.add(scaled(term.imaginary, -value * up, down), cartesian_rest(model, m, exponents));
        dy.add(scaled(term.real, value * up, down), cartesian_rest(model, m, exponents));
      }
    }
    text += fmt::format("  dx_{0}/dt = {1}\n  dy_{0}/dt = {2}\n", model.coordinates[k], dx.text(), dy.text());
  }
  return text;
}

std::string frequency_response_text(const CanonicalModel& model, const CanonicalCase& c) {
  std::string text = "\nSteady states\n";
  if (model.coordinates.size() != 1)
    return text +
           "  Several modes: the phases cannot be eliminated in closed form; solve dB/dt = 0 for all modes.\n";
  const std::string& v = model.coordinates.front();
  // Terms that turn with the phase, by angle; the rest is S.
  using Angle = std::pair<std::vector<int>, std::vector<int>>;
  std::set<Angle> angles;
  for (const CanonicalTerm& term : c.slow_derivative[0]) {
    const std::vector<int> beta{term.powers.amplitude[0] - term.powers.conjugate[0] - 1};
    if (beta[0] != 0) angles.insert({beta, term.powers.slow_phase});
  }
  TextSum still_real(model.order), still_imaginary(model.order), turning_real(model.order),
      turning_imaginary(model.order);
  for (const CanonicalTerm& term : c.slow_derivative[0]) {
    const CanonicalPowers& p = term.powers;
    const int degree = p.amplitude[0] + p.conjugate[0] + p.modulus[0];
    std::string rest;
    multiply(rest, "a_" + v, degree);
    for (std::size_t j = 0; j < model.excitations.size(); ++j) multiply(rest, model.excitations[j], p.forcing[j]);
    const long up = degree < 1 ? 1L << (1 - degree) : 1, down = degree > 1 ? 1L << (degree - 1) : 1;
    const bool turns = p.amplitude[0] - p.conjugate[0] - 1 != 0;
    (turns ? turning_real : still_real).add(scaled(term.real, up, down), rest);
    (turns ? turning_imaginary : still_imaginary).add(scaled(term.imaginary, up, down), rest);
  }
  const std::string offset = frame_offset(model, c, 0);
  if (angles.empty()) {
    text += fmt::format("  decay law:  da_{0}/dt = {1}\n  backbone:   a_{0}*(w - {2}) = {3}\n", v,
                        still_real.text(), model.natural_frequencies[0], still_imaginary.text());
    return text;
  }
  if (angles.size() > 1)
    return text + "  Terms with several phase angles: the phase cannot be eliminated in closed form.\n";
  const auto squared = [](const TextSum& sum) { return sum.empty() ? std::string() : "(" + sum.text() + ")^2"; };
  std::string right = squared(turning_real);
  if (!turning_imaginary.empty()) right += (right.empty() ? "" : " + ") + squared(turning_imaginary);
  text += fmt::format("  frequency response ({}):\n    ({})^2 + ({}{})^2 = {}\n",
                      "phase eliminated by squaring and adding", still_real.text(), still_imaginary.text(),
                      offset.empty() ? "" : " - a_" + v + "*(" + offset + ")", right);
  return text;
}

}  // namespace secular

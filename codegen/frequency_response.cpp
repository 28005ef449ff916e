#include "codegen/frequency_response.hpp"

#include <fmt/format.h>

#include <cstdlib>
#include <vector>

#include "codegen/cartesian_form.hpp"
#include "codegen/cpp_expression.hpp"
#include "codegen/polar_form.hpp"
#include "codegen/steady_state.hpp"

namespace secular {
namespace {

// w_k - omega_k as text.
std::string frame_offset_text(const CanonicalModel& model, const CanonicalCase& c, std::size_t mode) {
  std::string text;
  const std::vector<CanonicalRatio> offset = frame_offset(c, mode);
  for (std::size_t i = 0; i < offset.size(); ++i) {
    const CanonicalRatio& r = offset[i];
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

std::string cartesian_factors(const CanonicalModel& model, const CartesianTerm& term) {
  std::string product;
  for (std::size_t k = 0; k < model.coordinates.size(); ++k) {
    multiply(product, fmt::format("(x_{0}^2 + y_{0}^2)", model.coordinates[k]), term.norm_squared[k]);
    multiply(product, fmt::format("sqrt(x_{0}^2 + y_{0}^2)", model.coordinates[k]), term.norm[k]);
  }
  for (std::size_t j = 0; j < model.excitations.size(); ++j)
    multiply(product, model.excitations[j], term.forcing[j]);
  for (std::size_t k = 0; k < model.coordinates.size(); ++k) {
    multiply(product, "x_" + model.coordinates[k], term.x[k]);
    multiply(product, "y_" + model.coordinates[k], term.y[k]);
  }
  return product;
}

TextSum steady_sum(const CanonicalModel& model, const std::vector<SteadyTerm>& terms) {
  TextSum sum(model.order);
  for (const SteadyTerm& term : terms) {
    std::string rest;
    multiply(rest, "a_" + model.coordinates.front(), term.degree);
    for (std::size_t j = 0; j < model.excitations.size(); ++j)
      multiply(rest, model.excitations[j], term.forcing[j]);
    sum.add(term.coefficient, rest);
  }
  return sum;
}

}  // namespace

std::string cartesian_text(const CanonicalModel& model, const CanonicalCase& c) {
  std::string text = "\nCartesian form, B = (x + i*y)/2 in the observed frame\n";
  for (std::size_t k = 0; k < model.coordinates.size(); ++k) {
    TextSum dx(model.order), dy(model.order);
    const std::string offset = frame_offset_text(model, c, k);
    if (!offset.empty()) {
      dx.add_text("(" + offset + ")*y_" + model.coordinates[k], false);
      dy.add_text("(" + offset + ")*x_" + model.coordinates[k], true);
    }
    const CartesianEquations equations = cartesian_equations(model, c, k);
    for (const CartesianTerm& term : equations.x_rate) dx.add(term.coefficient, cartesian_factors(model, term));
    for (const CartesianTerm& term : equations.y_rate) dy.add(term.coefficient, cartesian_factors(model, term));
    text += fmt::format("  dx_{0}/dt = {1}\n  dy_{0}/dt = {2}\n", model.coordinates[k], dx.text(), dy.text());
  }
  return text;
}

std::string frequency_response_text(const CanonicalModel& model, const CanonicalCase& c) {
  std::string text = "\nSteady states\n";
  const SteadyState steady = steady_state(model, c);
  if (steady.kind == SteadyState::Kind::several_modes)
    return text +
           "  Several modes: the phases cannot be eliminated in closed form; solve dB/dt = 0 for all modes.\n";
  if (steady.kind == SteadyState::Kind::several_angles)
    return text + "  Terms with several phase angles: the phase cannot be eliminated in closed form.\n";
  const std::string& v = model.coordinates.front();
  const std::string still_real = steady_sum(model, steady.still_real).text(),
                    still_imaginary = steady_sum(model, steady.still_imaginary).text();
  if (steady.kind == SteadyState::Kind::free)
    return text + fmt::format("  decay law:  da_{0}/dt = {1}\n  backbone:   a_{0}*(w - {2}) = {3}\n", v, still_real,
                              model.natural_frequencies[0], still_imaginary);
  const auto squared = [&](const std::vector<SteadyTerm>& terms) {
    return terms.empty() ? std::string() : "(" + steady_sum(model, terms).text() + ")^2";
  };
  std::string right = squared(steady.turning_real);
  if (!steady.turning_imaginary.empty()) right += (right.empty() ? "" : " + ") + squared(steady.turning_imaginary);
  const std::string offset = frame_offset_text(model, c, 0);
  text += fmt::format("  frequency response ({}):\n    ({})^2 + ({}{})^2 = {}\n",
                      "phase eliminated by squaring and adding", still_real, still_imaginary,
                      offset.empty() ? "" : " - a_" + v + "*(" + offset + ")", right);
  return text;
}

}  // namespace secular

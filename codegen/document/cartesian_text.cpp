#include "codegen/document/cartesian_text.hpp"

#include <fmt/format.h>

#include <cstdlib>
#include <vector>

#include "codegen/canonical/cartesian_form.hpp"
#include "codegen/canonical/polar_form.hpp"
#include "codegen/expression/cpp_expression.hpp"

namespace secular {
namespace {

// w_k - omega_k as text.
std::string frame_offset_text(const CanonicalModel& model, const CanonicalCase& c, std::size_t mode) {
  return frequency_text(model, frame_offset(c, mode));
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
      text = (reads_as_sum(magnitude) ? "(" + text + ")" : text) + "*" + rest;
    add_text(text, negative);
  }
  void add_text(const std::string& text, bool negative) {
    sum_ += (sum_.empty() ? (negative ? "-" : "") : (negative ? " - " : " + ")) + text;
  }
  std::string text() const { return sum_.empty() ? "0" : sum_; }

 private:
  const SymbolOrder& order_;
  std::string sum_;
};

std::string cartesian_factors(const CanonicalModel& model, const CartesianTerm& term) {
  std::string product;
  for (std::size_t k = 0; k < model.coordinates.size(); ++k) {
    append_power(product, fmt::format("(x_{0}^2 + y_{0}^2)", model.coordinates[k]), term.norm_squared[k]);
    append_power(product, fmt::format("sqrt(x_{0}^2 + y_{0}^2)", model.coordinates[k]), term.norm[k]);
  }
  for (std::size_t j = 0; j < model.excitations.size(); ++j)
    append_power(product, model.excitations[j], term.forcing[j]);
  for (std::size_t k = 0; k < model.coordinates.size(); ++k) {
    append_power(product, "x_" + model.coordinates[k], term.x[k]);
    append_power(product, "y_" + model.coordinates[k], term.y[k]);
  }
  return product;
}

}  // namespace

std::string frequency_text(const CanonicalModel& model, const std::vector<CanonicalRatio>& factors) {
  std::string text;
  for (std::size_t i = 0; i < factors.size(); ++i) {
    const CanonicalRatio& r = factors[i];
    if (r.numerator == 0) continue;
    text += fmt::format("{}{}{}{}", r.numerator < 0 ? (text.empty() ? "-" : " - ") : (text.empty() ? "" : " + "),
                        std::abs(r.numerator) == 1 ? "" : std::to_string(std::abs(r.numerator)) + "*",
                        model.frequency_name(i), r.denominator == 1 ? "" : "/" + std::to_string(r.denominator));
  }
  return text;
}

void append_power(std::string& product, const std::string& base, int power) {
  if (power != 0) product += (product.empty() ? "" : "*") + base + (power == 1 ? "" : "^" + std::to_string(power));
}

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

}  // namespace secular

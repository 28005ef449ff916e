#include "thesis/verify/table_arithmetic.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

#include "perturb/formula_value.hpp"
#include "thesis/verify/evaluation.hpp"

namespace secular::verify {

RoundedNumber rounded_number(const std::string& digits) {
  const double value = std::strtod(digits.c_str(), nullptr);
  const std::size_t exponent_at = digits.find_first_of("eE");
  const std::string mantissa = digits.substr(0, exponent_at);
  const std::size_t point = mantissa.find('.');
  const double decimals = point == std::string::npos ? 0.0 : static_cast<double>(mantissa.size() - point - 1);
  const double power =
      exponent_at == std::string::npos ? 0.0 : std::strtod(digits.c_str() + exponent_at + 1, nullptr);
  const double half_unit = 0.5 * std::pow(10.0, power - decimals);
  return {value - half_unit, value + half_unit};
}

namespace {

ArithmeticCheck checked(const PrintedArithmetic& arithmetic) {
  const Expression formula = parse_expression(arithmetic.formula);
  ArithmeticCheck check;
  check.printed = rounded_number(arithmetic.printed);
  check.expected = {std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
  // Formulas are monotonic in every entry over its rounding, so corners bound them.
  const std::size_t corners = std::size_t{1} << arithmetic.from.size();
  for (std::size_t corner = 0; corner < corners; ++corner) {
    const GiNaC::ex value = formula_value(formula, arithmetic.formula, [&](const Expression& e) -> GiNaC::ex {
      std::size_t index = 0;
      for (const auto& [name, digits] : arithmetic.from) {
        const RoundedNumber number = rounded_number(digits);
        if (name == e.text) return (corner >> index) & 1 ? number.high : number.low;
        ++index;
      }
      fail_at(arithmetic.formula, e.place, "'" + e.text + "' has no value", "list it in `from`");
    });
    const double number = GiNaC::ex_to<GiNaC::numeric>(value.evalf()).to_double();
    check.expected = {std::min(check.expected.low, number), std::max(check.expected.high, number)};
  }
  check.agrees = check.expected.low <= check.printed.high && check.printed.low <= check.expected.high;
  return check;
}

}  // namespace

ArithmeticCheck check_arithmetic(const PrintedArithmetic& arithmetic) {
  return evaluated(arithmetic.formula, [&] { return checked(arithmetic); });
}

}  // namespace secular::verify

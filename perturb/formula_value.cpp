#include "perturb/formula_value.hpp"

#include "perturb/symbol_table.hpp"

namespace secular {

int integer_exponent(const Expression& power, const FormulaSource& source) {
  const Expression& exponent = power.operands[1];
  const GiNaC::ex value = formula_value(exponent, source, [&](const Expression& symbol) -> GiNaC::ex {
    fail_at(source, symbol.place, "symbol '" + symbol.text + "' in an exponent", "exponents are integers");
  });
  if (!GiNaC::is_a<GiNaC::numeric>(value) || !GiNaC::ex_to<GiNaC::numeric>(value).is_integer() ||
      GiNaC::abs(GiNaC::ex_to<GiNaC::numeric>(value)) > largest_exponent)
    fail_at(source, exponent.place, "the exponent is not an integer between -64 and 64", "write an integer power");
  return GiNaC::ex_to<GiNaC::numeric>(value).to_int();
}

void refuse_power_of_zero(const GiNaC::ex& base, int exponent, const Expression& power,
                          const FormulaSource& source) {
  if (base.normal().is_zero())
    fail_at(source, power.place, exponent < 0 ? "division by zero" : "zero to the power of zero",
            "correct the power");
}

GiNaC::ex formula_value(const Expression& expression, const FormulaSource& source,
                        const std::function<GiNaC::ex(const Expression& symbol)>& value_of) {
  const auto value = [&](std::size_t operand) {
    return formula_value(expression.operands[operand], source, value_of);
  };
  switch (expression.kind) {
    case Expression::Kind::number:
      return exact_number(expression.text);
    case Expression::Kind::symbol:
      return expression.text == "Pi" ? GiNaC::ex(GiNaC::Pi) : value_of(expression);
    case Expression::Kind::sum: {
      GiNaC::ex sum = 0;
      for (std::size_t i = 0; i < expression.operands.size(); ++i) sum += value(i);
      return sum;
    }
    case Expression::Kind::product: {
      GiNaC::ex product = 1;
      for (std::size_t i = 0; i < expression.operands.size(); ++i) product *= value(i);
      return product;
    }
    case Expression::Kind::quotient: {
      const GiNaC::ex divisor = value(1);
      if (divisor.normal().is_zero())
        fail_at(source, expression.place, "division by zero", "correct the denominator");
      return value(0) / divisor;
    }
    case Expression::Kind::power: {
      const int exponent = integer_exponent(expression, source);
      const GiNaC::ex base = value(0);
      if (exponent <= 0) refuse_power_of_zero(base, exponent, expression, source);
      return GiNaC::pow(base, exponent);
    }
    case Expression::Kind::negation:
      return -value(0);
    case Expression::Kind::call:
      fail_at(source, expression.place, "function " + expression.text + " is not allowed here",
              "symbols, numbers and + - * / ^ only");
  }
  return 0;
}

}  // namespace secular

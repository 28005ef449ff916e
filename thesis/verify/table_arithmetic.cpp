#include "thesis/verify/table_arithmetic.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstdlib>
#include <limits>

#include "thesis/verify/evaluation.hpp"
#include "thesis/verify/number_formula.hpp"

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

using Digits = std::vector<std::vector<std::string>>;

double centre(const std::string& digits) {
  const RoundedNumber number = rounded_number(digits);
  return 0.5 * (number.low + number.high);
}

/// A formula of real numbers whose values are handed over by name.
class RealFormula {
 public:
  explicit RealFormula(const FormulaSource& source)
      : source_(source), parsed_(parse_expression(source, number_functions())) {}

  Eigen::MatrixXd value(const std::map<std::string, Eigen::MatrixXd>& values) const {
    try {
      const Numbers result = numbers_of(parsed_, source_, [&](const Expression& e) -> Numbers {
        const auto found = values.find(e.text);
        if (found == values.end()) fail_at(source_, e.place, "'" + e.text + "' has no value", "list it in `from`");
        return found->second.cast<std::complex<double>>();
      });
      if (result.imag().cwiseAbs().maxCoeff() > 1e-9 * result.cwiseAbs().maxCoeff())
        fail_at(source_, {source_.first_line, 1}, "is no real number", "a formula of real numbers");
      return result.real();
    } catch (const SizeMismatch& mismatch) {
      fail_at(source_, {source_.first_line, 1}, std::string("is ") + mismatch.what(), "sizes that fit");
    }
  }

 private:
  const FormulaSource& source_;
  Expression parsed_;
};

ArithmeticCheck checked(const PrintedArithmetic& arithmetic) {
  const RealFormula formula(arithmetic.formula);
  ArithmeticCheck check;
  check.printed = rounded_number(arithmetic.printed);
  check.expected = {std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
  // Formulas are monotonic in every entry over its rounding, so corners bound them.
  const std::size_t corners = std::size_t{1} << arithmetic.from.size();
  for (std::size_t corner = 0; corner < corners; ++corner) {
    std::map<std::string, Eigen::MatrixXd> values;
    std::size_t index = 0;
    for (const auto& [name, digits] : arithmetic.from) {
      const RoundedNumber number = rounded_number(digits);
      values[name] = Eigen::MatrixXd::Constant(1, 1, (corner >> index++) & 1 ? number.high : number.low);
    }
    const Eigen::MatrixXd value = formula.value(values);
    if (value.size() != 1)
      fail_at(arithmetic.formula, {arithmetic.formula.first_line, 1}, "makes a matrix", "a number");
    check.expected = {std::min(check.expected.low, value(0)), std::max(check.expected.high, value(0))};
  }
  const bool low_enough = check.expected.low <= check.printed.high,
             high_enough = check.printed.low <= check.expected.high;
  check.agrees = (arithmetic.claim == "at least" || low_enough) && (arithmetic.claim == "at most" || high_enough);
  return check;
}

Eigen::MatrixXd centres(const Digits& digits) {
  Eigen::MatrixXd m(std::ssize(digits), std::ssize(digits.front()));
  for (Eigen::Index i = 0; i < m.rows(); ++i)
    for (Eigen::Index k = 0; k < m.cols(); ++k)
      m(i, k) = centre(digits[static_cast<std::size_t>(i)][static_cast<std::size_t>(k)]);
  return m;
}

}  // namespace

ArithmeticCheck check_arithmetic(const PrintedArithmetic& arithmetic) {
  return evaluated(arithmetic.formula, [&] { return checked(arithmetic); });
}

std::vector<std::string> wrong_entries(const PrintedMatrix& matrix) {
  const RealFormula formula(matrix.formula);
  std::map<std::string, Eigen::MatrixXd> values;
  for (const auto& [name, digits] : matrix.from) values[name] = centres(digits);
  const Eigen::MatrixXd middle = formula.value(values), printed = centres(matrix.printed);
  if (middle.rows() != printed.rows() || middle.cols() != printed.cols())
    fail_at(matrix.formula, {matrix.formula.first_line, 1}, "makes a matrix of another size than the printed one",
            std::to_string(printed.rows()) + " rows and " + std::to_string(printed.cols()) + " columns");
  Eigen::MatrixXd open = Eigen::MatrixXd::Zero(middle.rows(), middle.cols());
  for (const auto& [name, digits] : matrix.from)
    for (std::size_t i = 0; i < digits.size(); ++i)
      for (std::size_t k = 0; k < digits[i].size(); ++k) {
        double& entry = values[name](static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(k));
        const double kept = entry;
        const RoundedNumber bounds = rounded_number(digits[i][k]);
        entry = bounds.high;
        const Eigen::MatrixXd up = (formula.value(values) - middle).cwiseAbs();
        entry = bounds.low;
        open += up.cwiseMax((formula.value(values) - middle).cwiseAbs());
        entry = kept;
      }
  std::vector<std::string> wrong;
  for (Eigen::Index i = 0; i < middle.rows(); ++i)
    for (Eigen::Index k = 0; k < middle.cols(); ++k) {
      const std::string& digits = matrix.printed[static_cast<std::size_t>(i)][static_cast<std::size_t>(k)];
      const RoundedNumber bounds = rounded_number(digits);
      if (std::abs(middle(i, k) - printed(i, k)) > open(i, k) + 0.5 * (bounds.high - bounds.low))
        wrong.push_back(fmt::format("row {}, column {}: {:.5g} to {:.5g}, printed {}", i + 1, k + 1,
                                    middle(i, k) - open(i, k), middle(i, k) + open(i, k), digits));
    }
  return wrong;
}

}  // namespace secular::verify

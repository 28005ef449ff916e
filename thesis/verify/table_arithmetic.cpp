#include "thesis/verify/table_arithmetic.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstdlib>
#include <limits>
#include <tuple>
#include <utility>

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
      const auto value_of = [&](const Expression& e) {
        const auto found = values.find(e.text);
        if (found == values.end()) fail_at(source_, e.place, "'" + e.text + "' has no value", "list it in `from`");
        return exact(found->second.cast<std::complex<double>>());
      };
      const Numbers result = numbers_of(parsed_, source_, value_of).value;
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

/// A number that a formula makes of rounded numbers, over the box of what these can be.
class OverRounding {
 public:
  explicit OverRounding(const PrintedArithmetic& arithmetic) : source_(arithmetic.formula), formula_(source_) {
    for (const auto& [name, digits] : arithmetic.from) {
      names_.push_back(name);
      box_.push_back(rounded_number(digits));
    }
  }

  /// The least and the largest value found: at the centre and at the corners, then along one number after the other
  /// from the best corner and from the centre. Exact where the formula is monotonic in every number (the corners),
  /// or turns but once along each (as a square, an absolute value or a cosine does over a rounding).
  RoundedNumber ends() const {
    Point middle;
    for (const RoundedNumber& bounds : box_) middle.push_back(0.5 * (bounds.low + bounds.high));
    const double at_middle = value(middle);
    Point low = middle, high = middle;
    double lowest = at_middle, highest = at_middle;
    for (std::size_t corner = 0; corner < std::size_t{1} << box_.size(); ++corner) {
      Point point;
      for (std::size_t k = 0; k < box_.size(); ++k) point.push_back((corner >> k) & 1 ? box_[k].high : box_[k].low);
      const double here = value(point);
      if (here < lowest) std::tie(low, lowest) = std::pair(point, here);
      if (here > highest) std::tie(high, highest) = std::pair(point, here);
    }
    return {std::min(least(low, 1), least(middle, 1)), -std::min(least(high, -1), least(middle, -1))};
  }

 private:
  using Point = std::vector<double>;

  double value(const Point& point) const {
    std::map<std::string, Eigen::MatrixXd> values;
    for (std::size_t k = 0; k < point.size(); ++k) values[names_[k]] = Eigen::MatrixXd::Constant(1, 1, point[k]);
    const Eigen::MatrixXd result = formula_.value(values);
    if (result.size() != 1) fail_at(source_, {source_.first_line, 1}, "makes a matrix", "a number");
    return result(0);
  }

  /// The least of sign * value that is found from `point` along one number after the other.
  double least(Point point, double sign) const {
    constexpr int most_rounds = 4;
    double best = sign * value(point);
    for (int round = 0; round < most_rounds; ++round) {
      const double before = best;
      for (std::size_t k = 0; k < box_.size(); ++k) best = least_along(k, point, sign, best);
      if (best == before) break;
    }
    return best;
  }
  /// Of eight equal pieces of the range of number k those beside the least are narrowed down; `point` goes there.
  double least_along(std::size_t k, Point& point, double sign, double best) const {
    constexpr int pieces = 8, narrowings = 8;
    double low = box_[k].low, high = box_[k].high, kept = point[k];
    for (int round = 0; round < narrowings && low < high; ++round) {
      const double width = (high - low) / pieces;
      double at = low, least_here = std::numeric_limits<double>::infinity();
      for (int n = 0; n <= pieces; ++n) {
        point[k] = n == pieces ? high : low + n * width;
        const double here = sign * value(point);
        if (here < least_here) std::tie(at, least_here) = std::pair(point[k], here);
      }
      if (least_here < best) std::tie(kept, best) = std::pair(at, least_here);
      if (at == low || at == high) break;  // an end of the range: no turn within
      std::tie(low, high) = std::pair(at - width, at + width);
    }
    point[k] = kept;
    return best;
  }

  const FormulaSource& source_;
  RealFormula formula_;
  std::vector<std::string> names_;
  std::vector<RoundedNumber> box_;
};

ArithmeticCheck checked(const PrintedArithmetic& arithmetic) {
  ArithmeticCheck check;
  check.printed = rounded_number(arithmetic.printed);
  check.expected = OverRounding(arithmetic).ends();
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

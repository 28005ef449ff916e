#include "thesis/verify/number_formula.hpp"

#include <Eigen/SVD>
#include <algorithm>
#include <array>
#include <boost/math/distributions/fisher_f.hpp>
#include <cmath>
#include <complex>
#include <cstdlib>
#include <limits>
#include <numbers>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "perturb/formula_value.hpp"

namespace secular::verify {
namespace {

using Complex = std::complex<double>;

constexpr std::array<FormulaFunction, 24> functions = {
    {{"sqrt", 1},     {"exp", 1},      {"log", 1},           {"cos", 1},       {"sin", 1},
     {"cosh", 1},     {"sinh", 1},     {"abs", 1},           {"real", 1},      {"imag", 1},
     {"conj", 1},     {"square", 1},   {"transpose", 1},     {"inverse", 1},   {"pseudoinverse", 1},
     {"diagonal", 1}, {"singular", 1}, {"left_singular", 1}, {"powers", 2},    {"right_singular", 1},
     {"unit", 1},     {"hankel", 3},   {"part", 5},          {"f_quantile", 3}}};

// Rows and columns of what a formula makes: far more than a source writes out.
constexpr int most_rows = 64;
// More samples than a table of an analysis of variance counts; the quantile of any such number takes no time.
constexpr double most_degrees = 1e6;

// A result whose rounding may reach this multiple of its size, in units of the precision, is not determined.
constexpr double most_rounding = 1e9;

bool is_number(const Numbers& m) {
  return m.size() == 1;
}

Complex entrywise(const std::string& name, Complex z) {
  if (name == "sqrt") return std::sqrt(z);
  if (name == "exp") return std::exp(z);
  if (name == "log") return std::log(z);
  if (name == "cos") return std::cos(z);
  if (name == "sin") return std::sin(z);
  if (name == "cosh") return std::cosh(z);
  if (name == "sinh") return std::sinh(z);
  if (name == "abs") return std::abs(z);
  if (name == "real") return z.real();
  if (name == "imag") return z.imag();
  if (name == "conj") return std::conj(z);
  return z * z;
}

/// A rounding, or infinity where it leaves nothing of a value of this size.
double determined(double rounding, double size) {
  return rounding <= most_rounding * size ? rounding : std::numeric_limits<double>::infinity();
}

/// What rounding `r` of the argument z makes of that function's value.
double carried(const std::string& name, Complex z, double r) {
  if (r == 0) return 0;
  if (name == "sqrt") return determined(r, std::abs(z)) / (2 * std::abs(std::sqrt(z)));
  if (name == "exp") return r * std::abs(std::exp(z));
  if (name == "log") return determined(r, std::abs(z)) / std::abs(z);
  if (name == "cos") return r * std::abs(std::sin(z));
  if (name == "sin") return r * std::abs(std::cos(z));
  if (name == "cosh") return r * std::abs(std::sinh(z));
  if (name == "sinh") return r * std::abs(std::cosh(z));
  if (name == "square") return 2 * r * std::abs(z);
  return r;
}

/// A value with what its rounding carries on, and that of its own last step.
Computed computed(Numbers value, const Eigen::MatrixXd& before) {
  Eigen::MatrixXd rounding = before + value.cwiseAbs();
  return {std::move(value), std::move(rounding)};
}
Computed number(Complex value) {
  return exact(Numbers::Constant(1, 1, value));
}
/// A result of a whole matrix, whose rounding is at most `by` in every entry.
Computed spread(Numbers value, double by) {
  by = determined(by, value.norm());
  return computed(value, Eigen::MatrixXd::Constant(value.rows(), value.cols(), by));
}

/// One walk through a formula.
class Evaluation {
 public:
  Evaluation(const FormulaSource& source, const std::function<Computed(const Expression&)>& value_of)
      : source_(source), value_of_(value_of) {}

  Computed value(const Expression& e) const {
    Computed result = unchecked(e);
    if (!result.value.allFinite())
      fail_at(source_, e.place, "has no finite value", "numbers within the range of double precision");
    return result;
  }

 private:
  Computed unchecked(const Expression& e) const {
    switch (e.kind) {
      case Expression::Kind::number:
        return number(std::strtod(e.text.c_str(), nullptr));
      case Expression::Kind::symbol:
        return e.text == "Pi" ? number(std::numbers::pi) : value_of_(e);
      case Expression::Kind::sum: {
        Computed sum = value(e.operands[0]);
        for (std::size_t i = 1; i < e.operands.size(); ++i) {
          const Computed next = value(e.operands[i]);
          require(next.value.rows() == sum.value.rows() && next.value.cols() == sum.value.cols(),
                  "a sum of matrices of different sizes");
          sum.value += next.value;
          sum.rounding += next.rounding;
        }
        return sum;
      }
      case Expression::Kind::product: {
        Computed product = value(e.operands[0]);
        for (std::size_t i = 1; i < e.operands.size(); ++i) product = times(product, value(e.operands[i]));
        return product;
      }
      case Expression::Kind::quotient: {
        const Computed divisor = value(e.operands[1]);
        require(is_number(divisor.value), "a division by a matrix");
        const Complex by = divisor.value(0);
        if (by == 0.0) fail_at(source_, e.place, "division by zero", "correct the denominator");
        const Computed divided = value(e.operands[0]);
        const Numbers ratio = divided.value / by;
        return computed(
            ratio,
            (divided.rounding + ratio.cwiseAbs() * determined(divisor.rounding(0), std::abs(by))) / std::abs(by));
      }
      case Expression::Kind::power:
        return power(e);
      case Expression::Kind::negation: {
        Computed result = value(e.operands[0]);
        result.value = -result.value;
        return result;
      }
      case Expression::Kind::call:
        break;
    }
    return call(e);
  }

  static void require(bool fits, const char* what) {
    if (!fits) throw SizeMismatch(what);
  }
  static Computed times(const Computed& a, const Computed& b) {
    require(is_number(a.value) || is_number(b.value) || a.value.cols() == b.value.rows(),
            "a product of matrices whose inner sizes differ");
    const auto product = [](const auto& x, const auto& y) {
      using Matrix = typename std::decay_t<decltype(x)>::PlainObject;
      if (x.size() == 1) return Matrix(x(0) * y);
      return y.size() == 1 ? Matrix(x * y(0)) : Matrix(x * y);
    };
    const Eigen::MatrixXd size_a = a.value.cwiseAbs(), size_b = b.value.cwiseAbs();
    // The sizes of the terms that a product of matrices adds are in it: |A| |B|, and the rounding of A and B.
    return {product(a.value, b.value), product(a.rounding, size_b) + product(size_a, b.rounding)};
  }
  static Computed inverse(const Computed& m) {
    require(m.value.rows() == m.value.cols(), "the inverse of a matrix that is not square");
    const Numbers inverted = m.value.inverse();
    return spread(inverted, inverted.squaredNorm() * m.rounding.norm());
  }

  Computed power(const Expression& e) const {
    const Computed base = value(e.operands[0]);
    if (is_number(base.value)) return power_of_number(e, base);
    const int exponent = integer_exponent(e, source_);
    require(base.value.rows() == base.value.cols(), "a power of a matrix that is not square");
    const Computed factor = exponent < 0 ? inverse(base) : base;
    Computed product = exact(Numbers::Identity(base.value.rows(), base.value.cols()));
    for (int i = 0; i < std::abs(exponent); ++i) product = times(product, factor);
    return product;
  }
  Computed power_of_number(const Expression& e, const Computed& base) const {
    const Computed raised = value(e.operands[1]);
    require(is_number(raised.value), "a matrix as an exponent");
    const Complex z = base.value(0), exponent = raised.value(0);
    if (z == 0.0 && exponent.real() <= 0)
      fail_at(source_, e.place, exponent == 0.0 ? "zero to the power of zero" : "division by zero",
              "correct the power");
    const double whole = std::round(exponent.real());
    const bool is_integer = exponent == whole && std::abs(whole) <= largest_exponent;
    const Complex result = is_integer ? std::pow(z, static_cast<int>(whole)) : std::pow(z, exponent);
    const bool has_derivative = is_integer && whole > 0;
    const double rounding = has_derivative ? base.rounding(0) : determined(base.rounding(0), std::abs(z));
    if (z == 0.0) return {Numbers::Constant(1, 1, result), Eigen::MatrixXd::Constant(1, 1, rounding)};
    const double of_base = std::abs(result * exponent / z) * rounding,
                 of_exponent = is_integer ? 0.0 : std::abs(result * std::log(z)) * raised.rounding(0);
    return computed(Numbers::Constant(1, 1, result), Eigen::MatrixXd::Constant(1, 1, of_base + of_exponent));
  }

  int count(const Expression& e, std::int64_t highest) const {
    const Numbers n = value(e).value;
    if (!is_number(n) || n(0) != std::round(n(0).real()) || n(0).real() < 1 ||
        n(0).real() > static_cast<double>(highest))
      fail_at(source_, e.place, "is no index here", "an integer from 1 to " + std::to_string(highest));
    return static_cast<int>(n(0).real());
  }

  Computed call(const Expression& e) const {
    const std::string& name = e.text;
    if (name == "unit") {
      const int n = count(e.operands[0], most_rows);
      return exact(Numbers::Identity(n, n));
    }
    const Computed m = value(e.operands[0]);
    if (name == "transpose") return {m.value.transpose(), m.rounding.transpose()};
    if (name == "inverse") return inverse(m);
    if (name == "pseudoinverse") {
      const Numbers inverted = m.value.completeOrthogonalDecomposition().pseudoInverse();
      return spread(inverted, 2 * inverted.squaredNorm() * m.rounding.norm());
    }
    if (name == "diagonal") {
      require(m.value.rows() == 1 || m.value.cols() == 1, "a diagonal of a matrix");
      return {Eigen::Map<const Eigen::VectorXcd>(m.value.data(), m.value.size()).asDiagonal(),
              Eigen::Map<const Eigen::VectorXd>(m.rounding.data(), m.rounding.size()).asDiagonal()};
    }
    if (name.ends_with("singular")) return singular(name, m);
    if (name == "powers") {
      require(is_number(m.value), "powers of a matrix");
      Computed column = exact(Numbers::Ones(count(e.operands[1], most_rows), 1));
      for (Eigen::Index i = 1; i < column.value.rows(); ++i) {
        column.value(i) = column.value(i - 1) * m.value(0);
        column.rounding(i) =
            column.rounding(i - 1) * std::abs(m.value(0)) + std::abs(column.value(i - 1)) * m.rounding(0);
      }
      return column;
    }
    if (name == "hankel") {
      const int rows = count(e.operands[1], most_rows), columns = count(e.operands[2], most_rows);
      require(m.value.size() >= rows + columns - 1, "a Hankel matrix of too few samples");
      return {Numbers::NullaryExpr(rows, columns, [&](Eigen::Index i, Eigen::Index k) { return m.value(i + k); }),
              Eigen::MatrixXd::NullaryExpr(rows, columns,
                                           [&](Eigen::Index i, Eigen::Index k) { return m.rounding(i + k); })};
    }
    if (name == "part") return part(e, m);
    if (name == "f_quantile") return f_quantile(e, m.value);
    return computed(m.value.unaryExpr([&](Complex z) { return entrywise(name, z); }),
                    m.value.binaryExpr(m.rounding, [&](Complex z, double r) { return carried(name, z, r); }));
  }

  // A singular value moves by no more than the matrix; a vector by that over the distance to the next value.
  static Computed singular(const std::string& name, const Computed& m) {
    const Eigen::JacobiSVD<Numbers> svd(m.value, Eigen::ComputeThinU | Eigen::ComputeThinV);
    const Eigen::VectorXd& values = svd.singularValues();
    const double moved = m.rounding.norm();
    if (name == "singular")
      return computed(values.cast<Complex>(), Eigen::VectorXd::Constant(values.size(), moved));
    Computed vectors = exact(name == "left_singular" ? svd.matrixU() : svd.matrixV());
    const bool completes = vectors.value.rows() == vectors.value.cols();
    for (Eigen::Index k = 0; k < values.size(); ++k) {
      double distance = completes ? std::numeric_limits<double>::infinity() : values(k);
      for (Eigen::Index j = 0; j < values.size(); ++j)
        if (j != k) distance = std::min(distance, std::abs(values(j) - values(k)));
      vectors.rounding.col(k).array() += determined(moved, distance) / distance;
    }
    return vectors;
  }

  Computed part(const Expression& e, const Computed& m) const {
    int bound[4];
    for (std::size_t i = 0; i < 4; ++i) bound[i] = count(e.operands[i + 1], most_rows);
    require(
        bound[0] <= bound[1] && bound[2] <= bound[3] && bound[1] <= m.value.rows() && bound[3] <= m.value.cols(),
        "rows or columns that a matrix does not have");
    const int rows = bound[1] - bound[0] + 1, columns = bound[3] - bound[2] + 1;
    return {m.value.block(bound[0] - 1, bound[2] - 1, rows, columns),
            m.rounding.block(bound[0] - 1, bound[2] - 1, rows, columns)};
  }

  Computed f_quantile(const Expression& e, const Numbers& probability) const {
    const Numbers above = value(e.operands[1]).value, below = value(e.operands[2]).value;
    const auto counts = [](const Numbers& n) {
      return is_number(n) && n(0).real() > 0 && n(0).real() <= most_degrees;
    };
    if (!is_number(probability) || !counts(above) || !counts(below) || !(probability(0).real() > 0) ||
        !(probability(0).real() < 1))
      fail_at(source_, e.place, "is no quantile of an F distribution",
              "a probability between 0 and 1 and positive degrees of freedom, at most a million");
    const boost::math::fisher_f distribution(above(0).real(), below(0).real());
    return number(boost::math::quantile(distribution, probability(0).real()));
  }

  const FormulaSource& source_;
  const std::function<Computed(const Expression&)>& value_of_;
};

}  // namespace

std::span<const FormulaFunction> number_functions() {
  return functions;
}

Computed exact(Numbers value) {
  Eigen::MatrixXd rounding = value.cwiseAbs();
  return {std::move(value), std::move(rounding)};
}

Computed numbers_of(const Expression& expression, const FormulaSource& source,
                    const std::function<Computed(const Expression& symbol)>& value_of) {
  return Evaluation(source, value_of).value(expression);
}

}  // namespace secular::verify

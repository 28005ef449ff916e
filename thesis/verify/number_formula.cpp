#include "thesis/verify/number_formula.hpp"

#include <Eigen/SVD>
#include <array>
#include <boost/math/distributions/fisher_f.hpp>
#include <cmath>
#include <complex>
#include <cstdlib>
#include <map>
#include <numbers>
#include <string>
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

Numbers number(Complex value) {
  return Numbers::Constant(1, 1, value);
}
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

/// One walk through a formula.
class Evaluation {
 public:
  Evaluation(const FormulaSource& source, const std::function<Numbers(const Expression&)>& value_of)
      : source_(source), value_of_(value_of) {}

  Numbers value(const Expression& e) const {
    const Numbers result = unchecked(e);
    if (!result.allFinite())
      fail_at(source_, e.place, "has no finite value", "numbers within the range of double precision");
    return result;
  }

 private:
  Numbers unchecked(const Expression& e) const {
    switch (e.kind) {
      case Expression::Kind::number:
        return number(std::strtod(e.text.c_str(), nullptr));
      case Expression::Kind::symbol:
        return e.text == "Pi" ? number(std::numbers::pi) : value_of_(e);
      case Expression::Kind::sum: {
        Numbers sum = value(e.operands[0]);
        for (std::size_t i = 1; i < e.operands.size(); ++i) {
          const Numbers next = value(e.operands[i]);
          require(next.rows() == sum.rows() && next.cols() == sum.cols(), "a sum of matrices of different sizes");
          sum += next;
        }
        return sum;
      }
      case Expression::Kind::product: {
        Numbers product = value(e.operands[0]);
        for (std::size_t i = 1; i < e.operands.size(); ++i) product = times(product, value(e.operands[i]));
        return product;
      }
      case Expression::Kind::quotient: {
        const Numbers divisor = value(e.operands[1]);
        require(is_number(divisor), "a division by a matrix");
        if (divisor(0) == 0.0) fail_at(source_, e.place, "division by zero", "correct the denominator");
        return value(e.operands[0]) / divisor(0);
      }
      case Expression::Kind::power:
        return power(e);
      case Expression::Kind::negation:
        return -value(e.operands[0]);
      case Expression::Kind::call:
        break;
    }
    return call(e);
  }

  static void require(bool fits, const char* what) {
    if (!fits) throw SizeMismatch(what);
  }
  static Numbers times(const Numbers& a, const Numbers& b) {
    if (is_number(a)) return a(0) * b;
    if (is_number(b)) return a * b(0);
    require(a.cols() == b.rows(), "a product of matrices whose inner sizes differ");
    return a * b;
  }
  static Numbers inverse(const Numbers& m) {
    require(m.rows() == m.cols(), "the inverse of a matrix that is not square");
    return m.inverse();
  }

  Numbers power(const Expression& e) const {
    const Numbers base = value(e.operands[0]);
    if (is_number(base)) {
      const Numbers exponent = value(e.operands[1]);
      require(is_number(exponent), "a matrix as an exponent");
      if (base(0) == 0.0 && exponent(0).real() <= 0)
        fail_at(source_, e.place, exponent(0) == 0.0 ? "zero to the power of zero" : "division by zero",
                "correct the power");
      const double whole = std::round(exponent(0).real());
      if (exponent(0) == whole && std::abs(whole) <= largest_exponent)
        return number(std::pow(base(0), static_cast<int>(whole)));
      return number(std::pow(base(0), exponent(0)));
    }
    const int exponent = integer_exponent(e, source_);
    require(base.rows() == base.cols(), "a power of a matrix that is not square");
    const Numbers factor = exponent < 0 ? inverse(base) : base;
    Numbers product = Numbers::Identity(base.rows(), base.cols());
    for (int i = 0; i < std::abs(exponent); ++i) product = product * factor;
    return product;
  }

  int count(const Expression& e, std::int64_t highest) const {
    const Numbers n = value(e);
    if (!is_number(n) || n(0) != std::round(n(0).real()) || n(0).real() < 1 ||
        n(0).real() > static_cast<double>(highest))
      fail_at(source_, e.place, "is no index here", "an integer from 1 to " + std::to_string(highest));
    return static_cast<int>(n(0).real());
  }

  Numbers call(const Expression& e) const {
    const std::string& name = e.text;
    if (name == "unit") {
      const int n = count(e.operands[0], most_rows);
      return Numbers::Identity(n, n);
    }
    const Numbers m = value(e.operands[0]);
    if (name == "transpose") return m.transpose();
    if (name == "inverse") return inverse(m);
    if (name == "pseudoinverse") return m.completeOrthogonalDecomposition().pseudoInverse();
    if (name == "diagonal") {
      require(m.rows() == 1 || m.cols() == 1, "a diagonal of a matrix");
      return Eigen::Map<const Eigen::VectorXcd>(m.data(), m.size()).asDiagonal();
    }
    if (name == "singular" || name == "left_singular" || name == "right_singular") {
      const Eigen::BDCSVD<Numbers> svd(m, Eigen::ComputeThinU | Eigen::ComputeThinV);
      if (name == "singular") return svd.singularValues().cast<Complex>();
      return name == "left_singular" ? Numbers(svd.matrixU()) : Numbers(svd.matrixV());
    }
    if (name == "powers") {
      require(is_number(m), "powers of a matrix");
      Numbers column = Numbers::Ones(count(e.operands[1], most_rows), 1);
      for (Eigen::Index i = 1; i < column.rows(); ++i) column(i, 0) = column(i - 1, 0) * m(0);
      return column;
    }
    if (name == "hankel") {
      const int rows = count(e.operands[1], most_rows), columns = count(e.operands[2], most_rows);
      require(m.size() >= rows + columns - 1, "a Hankel matrix of too few samples");
      return Numbers::NullaryExpr(rows, columns, [&](Eigen::Index i, Eigen::Index k) { return m(i + k); });
    }
    if (name == "part") return part(e, m);
    if (name == "f_quantile") return f_quantile(e, m);
    return m.unaryExpr([&](Complex z) { return entrywise(name, z); });
  }

  Numbers part(const Expression& e, const Numbers& m) const {
    int bound[4];
    for (std::size_t i = 0; i < 4; ++i) bound[i] = count(e.operands[i + 1], most_rows);
    require(bound[0] <= bound[1] && bound[2] <= bound[3] && bound[1] <= m.rows() && bound[3] <= m.cols(),
            "rows or columns that a matrix does not have");
    return m.block(bound[0] - 1, bound[2] - 1, bound[1] - bound[0] + 1, bound[3] - bound[2] + 1);
  }

  Numbers f_quantile(const Expression& e, const Numbers& probability) const {
    const Numbers above = value(e.operands[1]), below = value(e.operands[2]);
    if (!is_number(probability) || !is_number(above) || !is_number(below) || !(probability(0).real() > 0) ||
        !(probability(0).real() < 1) || !(above(0).real() > 0) || !(below(0).real() > 0))
      fail_at(source_, e.place, "is no quantile of an F distribution",
              "a probability between 0 and 1 and positive degrees of freedom");
    const boost::math::fisher_f distribution(above(0).real(), below(0).real());
    return number(boost::math::quantile(distribution, probability(0).real()));
  }

  const FormulaSource& source_;
  const std::function<Numbers(const Expression&)>& value_of_;
};

}  // namespace

std::span<const FormulaFunction> number_functions() {
  return functions;
}

Numbers numbers_of(const Expression& expression, const FormulaSource& source,
                   const std::function<Numbers(const Expression& symbol)>& value_of) {
  return Evaluation(source, value_of).value(expression);
}

}  // namespace secular::verify

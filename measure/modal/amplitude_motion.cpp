#include "measure/modal/amplitude_motion.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "measure/modal/motion_columns.hpp"
#include "measure/modal/pole_fit.hpp"
#include "measure/modal/short_problem.hpp"
#include "numerics/nonlinear_fit.hpp"
#include "numerics/orthonormal_span.hpp"

namespace secular {
namespace {

using Complex = std::complex<double>;
using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;
using Eigen::VectorXcd;
using Eigen::VectorXd;

// A law p + c_1 a + c_2 a^2 + ... as (Re p, Im p, Re c_1, Im c_1, ...), 1/s, of amplitudes a that are one where the
// largest record begins.
Complex law_at(const VectorXd& law, double amplitude) {
  Complex sum = 0;
  for (Index k = law.size() / 2; k-- > 0;) sum = sum * amplitude + Complex(law(2 * k), law(2 * k + 1));
  return sum;
}

// u of exp(u(t)) with u' = law(a exp(Re u)), u(0) = 0, at nodes a `step` apart, and u' there.
struct Path {
  VectorXcd value, slope;
};

Path path_of(const VectorXd& law, double amplitude, Index nodes, double step) {
  const auto slope = [&](Complex u) { return law_at(law, amplitude * std::exp(u.real())); };
  Path path{VectorXcd(nodes), VectorXcd(nodes)};
  Complex u = 0;
  for (Index i = 0; i < nodes; ++i) {
    const Complex k1 = slope(u), k2 = slope(u + 0.5 * step * k1), k3 = slope(u + 0.5 * step * k2),
                  k4 = slope(u + step * k3);
    path.value(i) = u;
    path.slope(i) = k1;
    u += step / 6 * (k1 + 2.0 * k2 + 2.0 * k3 + k4);
  }
  return path;
}

// Between nodes by Hermite's cubic polynomials.
VectorXcd at_rows(const Path& path, double step, Index rows, double rate) {
  VectorXcd u(rows);
  for (Index i = 0; i < rows; ++i) {
    const double t = static_cast<double>(i) / rate / step;
    const Index n = std::min(static_cast<Index>(t), path.value.size() - 2);
    const double x = t - static_cast<double>(n), y = 1 - x;
    u(i) = y * y * (1 + 2 * x) * path.value(n) + x * x * (1 + 2 * y) * path.value(n + 1) +
           step * x * y * (y * path.slope(n) - x * path.slope(n + 1));
  }
  return u;
}

// The fit of laws to the first rows by variable projection, as in pole_fit.cpp.
class LawFit {
 public:
  LawFit(const MotionBeside& motion, Index rows) : motion_(motion), rows_(rows) {
    const Index n = motion.others.size();
    MatrixXd columns = MatrixXd::Ones(rows, 2 * n + 1);
    for (Index r = 0; r < n; ++r)
      columns.middleCols(2 * r, 2) = motion_columns(exponential(rows, motion.sample_rate_hz, motion.others(r)));
    basis_ = orthonormal_span(columns);
    data_ = without_span(basis_, motion.samples.topRows(rows));
    largest_ = *std::max_element(motion.amplitudes.begin(), motion.amplitudes.end());
  }

  // From `law` on, which it moves; the squares that are left.
  double fit(VectorXd& law) const {
    const ResidualFunction function = [&](const VectorXd& x, VectorXd& residual, MatrixXd& jacobian) {
      MatrixXd hessian = MatrixXd::Zero(x.size(), x.size());
      VectorXd gradient = VectorXd::Zero(x.size());
      double squares = 0;
      for (std::size_t j = 0; j < motion_.amplitudes.size(); ++j) squares += add_record(x, j, hessian, gradient);
      if (!std::isfinite(squares)) {
        residual.setConstant(std::nan(""));  // a step too far, turned back
        jacobian.setZero();
        return;
      }
      fill_short_problem(hessian, gradient, squares, residual, jacobian);
    };
    const FitReport report = nonlinear_fit(function, law.size() + 1, law, 25);
    law = report.parameters;
    return 2 * report.cost;
  }

 private:
  double add_record(const VectorXd& law, std::size_t record, MatrixXd& hessian, VectorXd& gradient) const {
    constexpr Index nodes = 129;
    const double rate = motion_.sample_rate_hz, duration = static_cast<double>(rows_ - 1) / rate,
                 step = duration / static_cast<double>(nodes - 1), share = motion_.amplitudes[record] / largest_;
    const Path path = path_of(law, share, nodes, step);
    if (!path.value.allFinite() || !(path.value.real().maxCoeff() < 300))
      return std::numeric_limits<double>::infinity();
    const VectorXcd motion = at_rows(path, step, rows_, rate).array().exp();
    const MatrixXd columns = without_span(basis_, motion_columns(motion));
    const Index first = static_cast<Index>(record) * motion_.channels;
    const auto data = data_.middleCols(first, motion_.channels);
    const Eigen::HouseholderQR<MatrixXd> qr(columns);
    const MatrixXd basis = qr.householderQ() * MatrixXd::Identity(rows_, 2);
    const MatrixXd shadow = basis.transpose() * data;
    const MatrixXd amplitudes = qr.matrixQR().topRows(2).triangularView<Eigen::Upper>().solve(shadow);
    const MatrixXd left = data - basis * shadow;
    // Columns times du by each of the law's numbers.
    MatrixXd moved(rows_, 2 * law.size());
    for (Index i = 0; i < law.size(); ++i) {
      VectorXd other = law;
      const double h = 1e-6 / duration;
      other(i) += h;
      const Path ahead = path_of(other, share, nodes, step);
      other(i) -= 2 * h;
      const Path behind = path_of(other, share, nodes, step);
      const Path by{(ahead.value - behind.value) / (2 * h), (ahead.slope - behind.slope) / (2 * h)};
      moved.middleCols(2 * i, 2) = motion_columns(motion.cwiseProduct(at_rows(by, step, rows_, rate)));
    }
    moved = without_span(basis, without_span(basis_, moved));
    const MatrixXd moments = moved.transpose() * moved, slopes = moved.transpose() * left;
    for (Index s = 0; s < data.cols(); ++s) {
      MatrixXd turn = MatrixXd::Zero(moved.cols(), law.size());  // residuals fall by the columns times this
      for (Index i = 0; i < law.size(); ++i) turn.col(i).segment(2 * i, 2) = -amplitudes.col(s);
      hessian += turn.transpose() * moments * turn;
      gradient += turn.transpose() * slopes.col(s);
    }
    return left.squaredNorm();
  }

  const MotionBeside& motion_;
  Index rows_;
  MatrixXd basis_, data_;
  double largest_;
};

}  // namespace

double squares_left_by_law(const MotionBeside& motion, int degree, double constant) {
  const Index rows = motion.samples.rows();
  VectorXd start = VectorXd::Zero(2 * degree + 2);
  start.head(2) << motion.pole.real(), motion.pole.imag();
  // A phase that is off by a turn at the end is not found from there, but from shorter parts.
  VectorXd law = start;
  Index part = rows;
  while (part / 2 >= 16 * (motion.others.size() + degree + 2)) part /= 2;
  for (; part < rows; part *= 2) LawFit(motion, part).fit(law);
  const LawFit whole(motion, rows);
  const double left = whole.fit(law);
  return left < constant ? left : std::min(left, whole.fit(start));
}

}  // namespace secular

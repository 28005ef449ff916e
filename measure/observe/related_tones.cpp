#include "measure/observe/related_tones.hpp"

#include <Eigen/Dense>
#include <cmath>
#include <complex>
#include <stdexcept>

namespace secular {
namespace {

using Complex = std::complex<double>;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// 2 cos(w t) and -2 sin(w t) by a rotation from sample to sample, so that re*first + im*second = 2 Re(B exp(i w
// t)).
void wave(double frequency, double rate, MatrixXd& basis, Index column) {
  const Index n = basis.rows();
  const Complex step = std::polar(1.0, frequency / rate);
  Complex z = std::polar(2.0, -0.5 * frequency * static_cast<double>(n - 1) / rate);
  for (Index i = 0; i < n; ++i) {
    basis(i, column) = z.real();
    basis(i, column + 1) = -z.imag();
    z *= step;
  }
}

struct Projection {
  MatrixXd basis, coefficients, residual;
  Eigen::LLT<MatrixXd> gram;
  VectorXd weight;  // 1/variance by channel
};

class Fitter {
 public:
  Fitter(const Eigen::Ref<const MatrixXd>& y, double rate, const RelatedTones& tones)
      : y_(y),
        rate_(rate),
        tones_(tones),
        count_(tones.fixed.size()),
        varying_(tones.varying),
        degree_(tones.degree) {
    linear_ = 2 * count_ + 1 + 2 * degree_ * varying_;
    if (y.rows() <= linear_ + tones.coupling.cols())
      throw std::invalid_argument("fewer samples than unknown tones");
    half_ = 0.5 * static_cast<double>(y.rows() - 1) / rate;
    time_ = VectorXd::LinSpaced(y.rows(), -half_, half_);
  }

  Projection project(const VectorXd& u) const {
    const VectorXd frequency =
        tones_.coupling.cols() > 0 ? VectorXd(tones_.fixed + tones_.coupling * u) : tones_.fixed;
    Projection p;
    p.basis.resize(y_.rows(), linear_);
    for (Index j = 0; j < count_; ++j) wave(frequency(j), rate_, p.basis, 2 * j);
    p.basis.col(2 * count_).setOnes();
    for (Index j = 0; j < varying_; ++j) {
      // Powers of time over half of the window.
      for (Index power = 1; power <= degree_; ++power)
        p.basis.middleCols(power_column(j, power), 2) =
            time_.asDiagonal() * (p.basis.middleCols(power == 1 ? 2 * j : power_column(j, power - 1), 2) / half_);
    }
    MatrixXd gram = MatrixXd::Zero(linear_, linear_);
    gram.selfadjointView<Eigen::Lower>().rankUpdate(p.basis.transpose());
    p.gram.compute(gram.selfadjointView<Eigen::Lower>());
    p.coefficients = p.gram.solve(MatrixXd(p.basis.transpose() * y_));
    p.residual = y_ - p.basis * p.coefficients;
    // A second pass takes back what forming the Gram matrix lost.
    const MatrixXd correction = p.gram.solve(MatrixXd(p.basis.transpose() * p.residual));
    p.coefficients += correction;
    p.residual -= p.basis * correction;
    const double lost =
        static_cast<double>(linear_) + static_cast<double>(tones_.coupling.cols()) / static_cast<double>(y_.cols());
    p.weight = ((static_cast<double>(y_.rows()) - lost) / (p.residual.colwise().squaredNorm().array() + 1e-300))
                   .transpose();
    return p;
  }

  // Normal equations of the step in u.
  void normal_equations(const Projection& p, MatrixXd& hessian, VectorXd& gradient) const {
    const Index unknowns = tones_.coupling.cols();
    hessian = MatrixXd::Zero(unknowns, unknowns);
    gradient = VectorXd::Zero(unknowns);
    for (Index c = 0; c < y_.cols(); ++c) {
      MatrixXd slope = MatrixXd::Zero(y_.rows(), unknowns);
      for (Index j = 0; j < count_; ++j) {
        if ((tones_.coupling.row(j).array() == 0).all()) continue;
        // d/dw 2 Re(B exp(i w t)) = t 2 Re(i B exp(i w t)).
        const VectorXd turned = time_.cwiseProduct(-p.coefficients(2 * j + 1, c) * p.basis.col(2 * j) +
                                                   p.coefficients(2 * j, c) * p.basis.col(2 * j + 1));
        slope += turned * tones_.coupling.row(j);
      }
      slope -= p.basis * MatrixXd(p.gram.solve(MatrixXd(p.basis.transpose() * slope)));
      hessian += p.weight(c) * slope.transpose() * slope;
      gradient += p.weight(c) * slope.transpose() * p.residual.col(c);
    }
  }

  RelatedToneFit fit(VectorXd u) const {
    RelatedToneFit result;
    Projection p = project(u);
    MatrixXd hessian;
    VectorXd gradient;
    const Index unknowns = tones_.coupling.cols();
    const double bin = 2 * 3.14159265358979 * rate_ / static_cast<double>(y_.rows());
    if (unknowns > 0) {
      result.ending = SolverEnding::stalled;
      for (int iteration = 0; iteration < 30 && result.ending == SolverEnding::stalled; ++iteration) {
        normal_equations(p, hessian, gradient);
        VectorXd step = hessian.ldlt().solve(gradient);
        if (!step.allFinite()) {
          result.ending = SolverEnding::ran_away;
          break;
        }
        const double size = step.cwiseAbs().maxCoeff();
        if (size > 0.5 * bin) step *= 0.5 * bin / size;
        u += step;
        p = project(u);
        if (size < 1e-5 * bin) result.ending = SolverEnding::converged;
      }
      normal_equations(p, hessian, gradient);
      const MatrixXd covariance = hessian.ldlt().solve(MatrixXd(MatrixXd::Identity(unknowns, unknowns)));
      result.free_sd = covariance.diagonal().cwiseMax(0).cwiseSqrt();
    }
    result.free = u;
    result.noise_sd = p.weight.cwiseInverse().cwiseSqrt();
    const MatrixXd inverse = p.gram.solve(MatrixXd(MatrixXd::Identity(linear_, linear_)));
    result.amplitude.resize(count_, y_.cols());
    result.amplitude_sd.resize(count_, y_.cols());
    result.slope.resize(varying_, y_.cols());
    result.curvature.resize(varying_, y_.cols());
    for (Index c = 0; c < y_.cols(); ++c) {
      for (Index j = 0; j < count_; ++j) {
        result.amplitude(j, c) = {p.coefficients(2 * j, c), p.coefficients(2 * j + 1, c)};
        result.amplitude_sd(j, c) =
            result.noise_sd(c) * std::sqrt(0.5 * (inverse(2 * j, 2 * j) + inverse(2 * j + 1, 2 * j + 1)));
      }
      for (Index j = 0; j < varying_; ++j) {
        const Index first = power_column(j, 1), second = power_column(j, 2);
        result.slope(j, c) = Complex(p.coefficients(first, c), p.coefficients(first + 1, c)) / half_;
        result.curvature(j, c) =
            2.0 * Complex(p.coefficients(second, c), p.coefficients(second + 1, c)) / (half_ * half_);
      }
    }
    result.offset = p.coefficients.row(2 * count_).transpose();
    result.offset_sd = result.noise_sd * std::sqrt(inverse(2 * count_, 2 * count_));
    return result;
  }

 private:
  // Of a varying tone times a power of time.
  Index power_column(Index tone, Index power) const { return 2 * count_ + 1 + 2 * (degree_ * tone + power - 1); }

  const Eigen::Ref<const MatrixXd>& y_;
  double rate_;
  const RelatedTones& tones_;
  Index count_, varying_, degree_, linear_ = 0;
  double half_ = 0;
  VectorXd time_;
};

}  // namespace

RelatedToneFit fit_related_tones(const Eigen::Ref<const MatrixXd>& channels, double sample_rate_hz,
                                 const RelatedTones& tones, const VectorXd& start) {
  return Fitter(channels, sample_rate_hz, tones).fit(start);
}

double tone_power(const Eigen::Ref<const MatrixXd>& channels, double sample_rate_hz, const VectorXd& frequencies) {
  double sum = 0;
  MatrixXd basis(channels.rows(), 2);
  for (Index c = 0; c < channels.cols(); ++c) {
    if (!(frequencies(c) > 0)) continue;
    wave(frequencies(c), sample_rate_hz, basis, 0);
    const double power = (basis.transpose() * channels.col(c)).squaredNorm();
    sum += power / (channels.col(c).squaredNorm() + 1e-300);
  }
  return sum;
}

}  // namespace secular

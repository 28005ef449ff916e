#include "estimator/signal/refine_poles.hpp"

#include <Eigen/Dense>
#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>
#include <utility>

namespace secular {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

VectorXd centred_time(Index samples) {
  return VectorXd::LinSpaced(samples, -1, 1);  // in half windows
}

// Window of samples: rate and half length, the unit of time in which all unknowns are of the order of radians.
struct Window {
  Index samples = 0;
  double rate = 1, half = 1;
  Window(Index count, double sample_rate)
      : samples(count), rate(sample_rate), half(0.5 * static_cast<double>(count - 1) / sample_rate) {}
};

// A^T B, and A^T A from half of its entries.
MatrixXd product_of(const MatrixXd& a, const MatrixXd& b) {
  return a.transpose() * b;
}
MatrixXd square_of(const MatrixXd& a) {
  MatrixXd result = MatrixXd::Zero(a.cols(), a.cols());
  result.selfadjointView<Eigen::Lower>().rankUpdate(a.transpose());
  return result.selfadjointView<Eigen::Lower>();
}

// G^T G in columns of unit norm, factored.
struct Gram {
  Eigen::LLT<MatrixXd> factor;
  VectorXd scale;  // columns of G are multiplied by it
  double rcond = 0;

  explicit Gram(const MatrixXd& functions) {
    const MatrixXd gram = square_of(functions);
    scale = gram.diagonal().cwiseMax(std::numeric_limits<double>::min()).cwiseSqrt().cwiseInverse();
    factor.compute(scale.asDiagonal() * gram * scale.asDiagonal());
    rcond = factor.info() == Eigen::Success ? factor.rcond() : 0;
  }
};

// Moments of the functions G in time tau (half windows): G^T G and the part of (tau G)^T (tau G) that the
// amplitudes cannot imitate.
struct Moments {
  Gram gram;
  MatrixXd first;  // (G scale)^T tau G
  MatrixXd free;   // (tau G)^T (1 - P) (tau G)
  bool usable = false;

  Moments(Gram factored, const MatrixXd& functions, const MatrixXd& timed) : gram(std::move(factored)) {
    if (!(gram.rcond > 1e-15)) return;
    first = gram.scale.asDiagonal() * product_of(functions, timed);
    free = square_of(timed) - first.transpose() * gram.factor.solve(first);
    usable = true;
  }
};

// Amplitudes of time * functions in the derivative of one channel's signal, per unknown in 1/half window.
MatrixXd rotated(std::span<const Pole> poles, const Eigen::Ref<const VectorXd>& amplitudes) {
  MatrixXd result = MatrixXd::Zero(amplitudes.size(), parameter_count(poles));
  Index function = 0, unknown = 0;
  for (const Pole& pole : poles) {
    const Index size = function_count(pole);
    for (Index i = 0; i < parameter_count(pole); ++i)
      result.col(unknown++).segment(function, size) = generator(pole, i) * amplitudes.segment(function, size);
    function += size;
  }
  return result;
}

MatrixXd hessian_of(std::span<const Pole> poles, const Moments& m, const MatrixXd& amplitudes,
                    const VectorXd& weight) {
  const Index unknowns = parameter_count(poles);
  MatrixXd hessian = MatrixXd::Zero(unknowns, unknowns);
  for (Index c = 0; c < amplitudes.cols(); ++c) {
    const MatrixXd turn = rotated(poles, amplitudes.col(c));
    hessian += weight(c) * (turn.transpose() * m.free * turn);
  }
  return hessian;
}

// Covariance of (pole parameters, amplitudes by channel). Unknowns that the samples do not determine get infinity.
MatrixXd covariance_of(std::span<const Pole> poles, const Moments& m, const MatrixXd& amplitudes,
                       const VectorXd& variance, double half) {
  const Index unknowns = parameter_count(poles), functions = amplitudes.rows(), channels = amplitudes.cols();
  const Index size = unknowns + functions * channels;
  const double infinite = std::numeric_limits<double>::infinity();
  MatrixXd covariance = MatrixXd::Constant(size, size, 0);
  covariance.diagonal().setConstant(infinite);
  if (!m.usable) return covariance;
  const MatrixXd hessian = hessian_of(poles, m, amplitudes, variance.cwiseInverse());
  // In unit diagonal; eigenvalues at rounding level mark what is not determined.
  VectorXd unit = hessian.diagonal().cwiseMax(std::numeric_limits<double>::min()).cwiseSqrt().cwiseInverse();
  MatrixXd poles_covariance = MatrixXd::Zero(unknowns, unknowns);
  bool determined = true;
  if (unknowns > 0) {
    const Eigen::SelfAdjointEigenSolver<MatrixXd> spectrum(
        MatrixXd(unit.asDiagonal() * hessian * unit.asDiagonal()));
    determined = spectrum.eigenvalues().minCoeff() > 1e-13 && hessian.allFinite();
    if (!determined) return covariance;
    const MatrixXd vectors = unit.asDiagonal() * spectrum.eigenvectors();
    poles_covariance = vectors * spectrum.eigenvalues().cwiseInverse().asDiagonal() * vectors.transpose();
  }
  const MatrixXd inverse = m.gram.scale.asDiagonal() *
                           m.gram.factor.solve(MatrixXd::Identity(functions, functions)) *
                           m.gram.scale.asDiagonal();
  MatrixXd drag(functions * channels, unknowns);
  for (Index c = 0; c < channels; ++c)
    drag.middleRows(c * functions, functions) =
        m.gram.scale.asDiagonal() * m.gram.factor.solve(m.first * rotated(poles, amplitudes.col(c)));
  covariance.topLeftCorner(unknowns, unknowns) = poles_covariance;
  covariance.bottomLeftCorner(functions * channels, unknowns) = -drag * poles_covariance;
  covariance.topRightCorner(unknowns, functions * channels) =
      covariance.bottomLeftCorner(functions * channels, unknowns).transpose();
  covariance.bottomRightCorner(functions * channels, functions * channels) =
      drag * poles_covariance * drag.transpose();
  for (Index c = 0; c < channels; ++c)
    covariance.block(unknowns + c * functions, unknowns + c * functions, functions, functions) +=
        variance(c) * inverse;
  covariance.topRows(unknowns) /= half;
  covariance.leftCols(unknowns) /= half;
  return covariance;
}

class Refiner {
 public:
  Refiner(const Eigen::Ref<const MatrixXd>& channels, double rate, std::span<const Pole> start)
      : y_(channels), window_(channels.rows(), rate), tau_(centred_time(channels.rows())) {
    functions_ = function_count(start);
    unknowns_ = parameter_count(start);
    if (y_.rows() <= functions_ + unknowns_ + 1)
      throw std::invalid_argument("fewer samples than unknown frequencies and amplitudes");
    power_ = y_.colwise().squaredNorm().transpose() / static_cast<double>(y_.rows());
    const double smallest = std::numeric_limits<double>::min();
    power_ = power_.cwiseMax(smallest);
  }

  RefinedPoles run(std::span<const Pole> start, int limit) {
    RefinedPoles result;
    std::vector<Pole> poles(start.begin(), start.end());
    std::optional<State> now = evaluate(poles);
    if (!now) return undetermined(poles);
    Moments m(now->gram, now->functions, now->timed);
    double damping = 0;
    result.status = unknowns_ == 0 ? ToneStatus::converged : ToneStatus::iteration_limit;
    double moved_by = 0;  // since the moments were taken, radians at the ends of the window
    for (; unknowns_ > 0 && result.iterations < limit; ++result.iterations) {
      if (!m.usable) return undetermined(poles);
      MatrixXd hessian = hessian_of(poles, m, now->amplitudes, now->weight);
      const VectorXd slope = gradient(poles, *now);
      hessian.diagonal() *= 1 + damping;
      // Unknowns of a term without amplitude have no curvature: they stay where they are.
      const double floor = 1e-14 * hessian.diagonal().maxCoeff() + std::numeric_limits<double>::min();
      hessian.diagonal().array() += floor;
      const VectorXd step = -hessian.ldlt().solve(slope);
      if (!step.allFinite()) return undetermined(poles);
      const double promised = -0.5 * slope.dot(step);  // decrease of the quadratic model, in log-likelihood
      const std::vector<Pole> next = moved(poles, step);
      std::optional<State> candidate = evaluate(next);
      // Rounding floor of the sum of logarithms: below it only the gradient tells, and the step is taken.
      const bool flat = promised < 1e-9;
      if (candidate && (candidate->cost <= now->cost || (flat && candidate->cost <= now->cost + 1e-9))) {
        const double length = step.norm();
        poles = next;
        now = std::move(candidate);
        damping = damping < 1e-6 ? 0 : damping / 10;
        moved_by += length;
        // A step far below the standard deviation of the estimate changes nothing but rounding.
        if (promised < 1e-7 || length < 1e-14) {
          result.status = ToneStatus::converged;
          break;
        }
        // Gauss-Newton contracts by about as much as its moments are off.
        if (moved_by > 1e-2) {
          m = Moments(now->gram, now->functions, now->timed);
          moved_by = 0;
        }
      } else {
        if (flat || damping > 1e8) {
          result.status = ToneStatus::converged;
          break;
        }
        if (moved_by > 0) m = Moments(now->gram, now->functions, now->timed);
        moved_by = 0;
        damping = std::max(1e-3, damping * 10);
      }
    }
    if (moved_by > 1e-4) m = Moments(now->gram, now->functions, now->timed);
    finish(poles, *now, m, result);
    return result;
  }

 private:
  struct State {
    MatrixXd functions, timed;  // samples x functions, the second times tau
    Gram gram;
    MatrixXd amplitudes;  // functions x channels
    MatrixXd residual;    // samples x channels
    VectorXd weight;      // 1 / variance
    double cost = 0;
  };

  std::optional<State> evaluate(std::span<const Pole> poles) const {
    MatrixXd functions = pole_functions(poles, y_.rows(), window_.rate, -window_.half);
    if (!functions.allFinite()) return std::nullopt;
    Gram gram(functions);
    if (!(gram.rcond > 0)) return std::nullopt;
    State s{std::move(functions), {}, std::move(gram), {}, {}, {}, 0};
    s.timed = tau_.asDiagonal() * s.functions;
    const MatrixXd right = s.gram.scale.asDiagonal() * product_of(s.functions, y_);
    s.amplitudes = s.gram.scale.asDiagonal() * s.gram.factor.solve(right);
    s.residual = y_;
    s.residual.noalias() -= s.functions * s.amplitudes;
    if (s.gram.rcond < 1e-2 || s.residual.squaredNorm() < 1e-18 * y_.squaredNorm()) {
      // Normal equations lose digits, and this step finds them again.
      const MatrixXd left = s.gram.scale.asDiagonal() * product_of(s.functions, s.residual);
      s.amplitudes += s.gram.scale.asDiagonal() * s.gram.factor.solve(left);
      s.residual = y_;
      s.residual.noalias() -= s.functions * s.amplitudes;
    }
    const VectorXd variance =
        s.residual.colwise().squaredNorm().transpose() / static_cast<double>(y_.rows()) + 1e-30 * power_;
    s.weight = variance.cwiseInverse();
    s.cost = variance.array().log().sum();
    if (!std::isfinite(s.cost)) return std::nullopt;
    return s;
  }

  VectorXd gradient(std::span<const Pole> poles, const State& s) const {
    const MatrixXd moment = product_of(s.timed, s.residual);
    VectorXd slope = VectorXd::Zero(unknowns_);
    for (Index c = 0; c < y_.cols(); ++c)
      slope -= s.weight(c) * (rotated(poles, s.amplitudes.col(c)).transpose() * moment.col(c));
    return slope;
  }

  std::vector<Pole> moved(std::vector<Pole> poles, const VectorXd& step) const {
    Index i = 0;
    for (Pole& pole : poles) {
      if (parameter_count(pole) == 0) continue;
      if (pole.family == PoleFamily::circular || pole.family == PoleFamily::product)
        pole.frequency += step(i++) / window_.half;
      if (pole.family != PoleFamily::circular) pole.rate += step(i++) / window_.half;
    }
    return poles;
  }

  RefinedPoles undetermined(const std::vector<Pole>& poles) const {
    RefinedPoles result;
    result.poles = poles;
    result.amplitudes = MatrixXd::Zero(functions_, y_.cols());
    result.residual = y_;
    result.noise_sd = power_.cwiseSqrt();
    result.cost = std::numeric_limits<double>::infinity();
    const Index size = unknowns_ + functions_ * y_.cols();
    result.covariance = MatrixXd::Zero(size, size);
    result.covariance.diagonal().setConstant(std::numeric_limits<double>::infinity());
    return result;
  }

  void finish(const std::vector<Pole>& poles, State& now, const Moments& m, RefinedPoles& result) const {
    // Degrees of freedom: the shared poles are counted once.
    const auto n = static_cast<double>(y_.rows());
    const double lost =
        static_cast<double>(functions_) + static_cast<double>(unknowns_) / static_cast<double>(y_.cols());
    const VectorXd variance = now.weight.cwiseInverse() * (n / (n - lost));
    result.poles = poles;
    result.noise_sd = variance.cwiseSqrt();
    result.cost = now.cost;
    result.covariance = covariance_of(poles, m, now.amplitudes, variance, window_.half);
    result.amplitudes = std::move(now.amplitudes);
    result.residual = std::move(now.residual);
  }

  const Eigen::Ref<const MatrixXd>& y_;
  Window window_;
  VectorXd tau_, power_;
  Index functions_ = 0, unknowns_ = 0;
};

}  // namespace

RefinedPoles refine_poles(const Eigen::Ref<const MatrixXd>& channels, double sample_rate_hz,
                          std::span<const Pole> start, int iteration_limit) {
  return Refiner(channels, sample_rate_hz, start).run(start, iteration_limit);
}

MatrixXd cramer_rao_bound(std::span<const Pole> poles, const Eigen::Ref<const MatrixXd>& amplitudes,
                          const Eigen::Ref<const VectorXd>& noise_sd, Index samples, double sample_rate_hz) {
  const Window window(samples, sample_rate_hz);
  const MatrixXd functions = pole_functions(poles, samples, sample_rate_hz, -window.half);
  const MatrixXd timed = centred_time(samples).asDiagonal() * functions;
  return covariance_of(poles, Moments(Gram(functions), functions, timed), amplitudes, noise_sd.array().square(),
                       window.half);
}

}  // namespace secular

#include "estimator/signal/refine_poles.hpp"

#include <Eigen/Dense>
#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>
#include <tuple>
#include <utility>

#include "estimator/signal/folded_window.hpp"

namespace secular {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// G^T G in columns of unit norm, factored.
struct Gram {
  Eigen::LLT<MatrixXd> factor;
  VectorXd scale;  // columns of G are multiplied by it
  double rcond = 0;

  explicit Gram(const MatrixXd& gram) {
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

  Moments(Gram factored, const FoldedFunctions& functions) : gram(std::move(factored)) {
    if (!(gram.rcond > 1e-15)) return;
    std::tie(first, free) = functions.timed_moments();
    first = gram.scale.asDiagonal() * first;
    free -= first.transpose() * gram.factor.solve(first);
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
  if (unknowns == 0) return hessian;
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
  covariance.bottomRightCorner(functions * channels, functions * channels).setZero();
  // Without unknown poles there is nothing that drags the amplitudes along.
  if (unknowns > 0) {
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
  }
  for (Index c = 0; c < channels; ++c)
    covariance.block(unknowns + c * functions, unknowns + c * functions, functions, functions) +=
        variance(c) * inverse;
  covariance.topRows(unknowns) /= half;
  covariance.leftCols(unknowns) /= half;
  return covariance;
}

/// Decrease of the log-likelihood below which a step is a change within the model linearised where the poles stand:
/// a hundredth of a standard deviation, of which a Gauss-Newton step leaves less than a hundredth.
constexpr double linear_decrease = 1e-4;
/// Below this a step changes nothing but rounding.
constexpr double no_decrease = 1e-7;

class Refiner {
 public:
  Refiner(const Eigen::Ref<const MatrixXd>& channels, double rate, std::span<const Pole> start)
      : window_(channels.rows(), rate), even_(window_.even(channels)), odd_(window_.odd(channels)) {
    functions_ = function_count(start);
    unknowns_ = parameter_count(start);
    if (channels.rows() <= functions_ + unknowns_ + 1)
      throw std::invalid_argument("fewer samples than unknown frequencies and amplitudes");
    power_ = channels.colwise().squaredNorm().transpose() / static_cast<double>(channels.rows());
    const double smallest = std::numeric_limits<double>::min();
    power_ = power_.cwiseMax(smallest);
  }

  RefinedPoles run(std::span<const Pole> start, int limit) {
    RefinedPoles result;
    std::vector<Pole> poles(start.begin(), start.end());
    std::optional<State> now = evaluate(poles);
    if (!now) return undetermined(poles);
    Moments m(now->gram, now->functions);
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
      if (promised < no_decrease) {
        result.status = ToneStatus::converged;
        break;
      }
      if (promised < linear_decrease && damping == 0) {
        drag_amplitudes(poles, m, step, now->amplitudes);
        poles = moved(poles, step);
        result.status = ToneStatus::converged;
        ++result.iterations;
        break;
      }
      const std::vector<Pole> next = moved(poles, step);
      std::optional<State> candidate = evaluate(next);
      if (candidate && candidate->cost <= now->cost) {
        const double length = step.norm();
        poles = next;
        now = std::move(candidate);
        damping = damping < 1e-6 ? 0 : damping / 10;
        moved_by += length;
        if (length < 1e-14) {
          result.status = ToneStatus::converged;
          break;
        }
        // Gauss-Newton contracts by about as much as its moments are off.
        if (moved_by > 1e-2) {
          m = Moments(now->gram, now->functions);
          moved_by = 0;
        }
      } else {
        if (damping > 1e8) {
          result.status = ToneStatus::converged;
          break;
        }
        if (moved_by > 0) m = Moments(now->gram, now->functions);
        moved_by = 0;
        damping = std::max(1e-3, damping * 10);
      }
    }
    // The covariance is off by about as much as the functions have turned since.
    if (moved_by > 1e-3) m = Moments(now->gram, now->functions);
    finish(poles, *now, m, result);
    return result;
  }

 private:
  struct State {
    FoldedFunctions functions;
    Gram gram;
    MatrixXd amplitudes;  // functions x channels
    MatrixXd even, odd;   // residual, folded
    VectorXd weight;      // 1 / variance
    double cost = 0;
  };

  std::optional<State> evaluate(std::span<const Pole> poles) const {
    FoldedFunctions functions(poles, window_);
    Gram gram(functions.gram());
    if (!(gram.rcond > 0)) return std::nullopt;  // dependent functions, or rates beyond all numbers
    State s{std::move(functions), std::move(gram), MatrixXd::Zero(functions_, even_.cols()), even_, odd_, {}, 0};
    solve_residual(s);
    // Normal equations lose digits, and a second pass finds them again.
    if (s.gram.rcond < 1e-2 || s.even.squaredNorm() + s.odd.squaredNorm() < 1e-18 * power_.sum()) {
      solve_residual(s);
    }
    const VectorXd energy = (s.even.colwise().squaredNorm() + s.odd.colwise().squaredNorm()).transpose();
    const VectorXd variance = energy / static_cast<double>(window_.samples) + 1e-30 * power_;
    s.weight = variance.cwiseInverse();
    s.cost = variance.array().log().sum();
    if (!std::isfinite(s.cost)) return std::nullopt;
    return s;
  }

  // Amplitudes of what is left, and what is left then.
  static void solve_residual(State& s) {
    const MatrixXd right = s.gram.scale.asDiagonal() * s.functions.project(s.even, s.odd);
    const MatrixXd change = s.gram.scale.asDiagonal() * s.gram.factor.solve(right);
    s.functions.subtract(change, s.even, s.odd);
    s.amplitudes += change;
  }

  // What a small step of the poles does to the least-squares amplitudes. (The residual is smallest, and changes by
  // less than a share 1e-4/samples.)
  static void drag_amplitudes(std::span<const Pole> poles, const Moments& m, const VectorXd& step,
                              MatrixXd& amplitudes) {
    MatrixXd turned(amplitudes.rows(), amplitudes.cols());
    for (Index c = 0; c < amplitudes.cols(); ++c) turned.col(c) = rotated(poles, amplitudes.col(c)) * step;
    amplitudes -= m.gram.scale.asDiagonal() * m.gram.factor.solve(m.first * turned);
  }

  VectorXd gradient(std::span<const Pole> poles, const State& s) const {
    const MatrixXd moment = s.functions.project_timed(s.even, s.odd);
    VectorXd slope = VectorXd::Zero(unknowns_);
    for (Index c = 0; c < even_.cols(); ++c)
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
    result.amplitudes = MatrixXd::Zero(functions_, even_.cols());
    result.residual = window_.unfold(even_, odd_);
    result.noise_sd = power_.cwiseSqrt();
    result.cost = std::numeric_limits<double>::infinity();
    const Index size = unknowns_ + functions_ * even_.cols();
    result.covariance = MatrixXd::Zero(size, size);
    result.covariance.diagonal().setConstant(std::numeric_limits<double>::infinity());
    return result;
  }

  void finish(const std::vector<Pole>& poles, State& now, const Moments& m, RefinedPoles& result) const {
    // Degrees of freedom: the shared poles are counted once.
    const auto n = static_cast<double>(window_.samples);
    const double lost =
        static_cast<double>(functions_) + static_cast<double>(unknowns_) / static_cast<double>(even_.cols());
    const VectorXd variance = now.weight.cwiseInverse() * (n / (n - lost));
    result.poles = poles;
    result.noise_sd = variance.cwiseSqrt();
    result.cost = now.cost;
    result.covariance = covariance_of(poles, m, now.amplitudes, variance, window_.half);
    result.amplitudes = std::move(now.amplitudes);
    result.residual = window_.unfold(now.even, now.odd);
  }

  FoldedWindow window_;
  MatrixXd even_, odd_;  // channels, folded
  VectorXd power_;
  Index functions_ = 0, unknowns_ = 0;
};

}  // namespace

RefinedPoles refine_poles(const Eigen::Ref<const MatrixXd>& channels, double sample_rate_hz,
                          std::span<const Pole> start, int iteration_limit) {
  return Refiner(channels, sample_rate_hz, start).run(start, iteration_limit);
}

MatrixXd cramer_rao_bound(std::span<const Pole> poles, const Eigen::Ref<const MatrixXd>& amplitudes,
                          const Eigen::Ref<const VectorXd>& noise_sd, Index samples, double sample_rate_hz) {
  const FoldedWindow window(samples, sample_rate_hz);
  const FoldedFunctions functions(poles, window);
  return covariance_of(poles, Moments(Gram(functions.gram()), functions), amplitudes, noise_sd.array().square(),
                       window.half);
}

}  // namespace secular

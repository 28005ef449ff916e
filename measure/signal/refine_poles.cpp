#include "measure/signal/refine_poles.hpp"

#include <Eigen/Dense>
#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>
#include <utility>

#include "measure/signal/folded_window.hpp"
#include "measure/signal/pole_equations.hpp"
#include "measure/signal/tone_series.hpp"

namespace secular {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

class Refiner {
 public:
  Refiner(const Eigen::Ref<const MatrixXd>& channels, double rate, std::span<const Pole> start)
      : window_(channels.rows(), rate), even_(window_.even(channels)), odd_(window_.odd(channels)) {
    functions_ = function_count(start);
    unknowns_ = parameter_count(start);
    if (channels.rows() <= functions_ + unknowns_ + 1)
      throw std::invalid_argument("fewer samples than unknown frequencies and amplitudes");
    energy_ = channels.colwise().squaredNorm().transpose().cwiseMax(std::numeric_limits<double>::min());
    power_ = energy_ / static_cast<double>(channels.rows());
  }

  RefinedPoles run(std::span<const Pole> start, int limit) {
    RefinedPoles result;
    std::vector<Pole> poles(start.begin(), start.end());
    std::optional<State> now = begin(poles, limit, result.iterations);
    if (!now) return undetermined(poles);
    PoleMoments m(now->gram, now->functions.timed_moments());
    double damping = 0;
    result.ending = unknowns_ == 0 ? SolverEnding::converged : SolverEnding::stalled;
    double moved_by = 0;  // since the moments were taken, radians at the ends of the window
    for (; unknowns_ > 0 && result.iterations < limit; ++result.iterations) {
      if (!m.usable) return undetermined(poles);
      const PoleTurns turns(poles, now->amplitudes);
      MatrixXd hessian = turns.hessian(m, now->weight);
      const VectorXd slope = turns.slope(now->functions.project_timed(now->even, now->odd), now->weight);
      hessian.diagonal() *= 1 + damping;
      // Unknowns of a term without amplitude have no curvature: they stay where they are.
      const double floor = 1e-14 * hessian.diagonal().maxCoeff() + std::numeric_limits<double>::min();
      hessian.diagonal().array() += floor;
      const VectorXd step = -hessian.ldlt().solve(slope);
      if (!step.allFinite()) return undetermined(poles);
      const double promised = -0.5 * slope.dot(step);  // decrease of the quadratic model, in log-likelihood
      if (promised < no_decrease) {
        result.ending = SolverEnding::converged;
        break;
      }
      if (promised < linear_decrease && damping == 0) {
        // The amplitudes follow. The residual is smallest, and changes by less than a share 1e-4/samples.
        now->amplitudes += turns.dragged(m, step);
        poles = moved(std::move(poles), step, window_.half);
        result.ending = SolverEnding::converged;
        ++result.iterations;
        break;
      }
      const std::vector<Pole> next = moved(poles, step, window_.half);
      std::optional<State> candidate = evaluate(FoldedFunctions(next, window_));
      if (candidate && candidate->cost <= now->cost) {
        const double length = step.norm();
        poles = next;
        now = std::move(candidate);
        damping = damping < 1e-6 ? 0 : damping / 10;
        moved_by += length;
        if (length < 1e-14) {
          result.ending = SolverEnding::converged;
          break;
        }
        // Gauss-Newton contracts by about as much as its moments are off.
        if (moved_by > 1e-2) {
          m = PoleMoments(now->gram, now->functions.timed_moments());
          moved_by = 0;
        }
      } else {
        if (damping > 1e8) {
          result.ending = SolverEnding::converged;
          break;
        }
        if (moved_by > 0) m = PoleMoments(now->gram, now->functions.timed_moments());
        moved_by = 0;
        damping = std::max(1e-3, damping * 10);
      }
    }
    // The covariance is off by about as much as the functions have turned since.
    if (moved_by > 1e-3) m = PoleMoments(now->gram, now->functions.timed_moments());
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

  // From where on a step costs a pass over the samples, which circular poles come next to with one for all steps.
  std::optional<State> begin(std::vector<Pole>& poles, int limit, int& iterations) const {
    std::vector<Pole> next = poles;
    FoldedFunctions functions(next, window_);
    double cost = std::numeric_limits<double>::infinity();
    bool on = unknowns_ > 0;
    while (on && functions.closed && iterations + 1 < limit) {
      ToneSeries series = follow_series(next, functions, even_, odd_, energy_);
      if (!(series.start_cost < cost)) break;
      cost = series.start_cost;
      poles = next;
      if (!series.moved) break;
      next = std::move(series.poles);
      functions = FoldedFunctions(next, window_);
      on = series.far;
      ++iterations;
    }
    std::optional<State> state = evaluate(std::move(functions));
    if (state && !(state->cost > cost)) {
      poles = std::move(next);
      return state;
    }
    return evaluate(FoldedFunctions(poles, window_));
  }

  std::optional<State> evaluate(FoldedFunctions functions) const {
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
    const MatrixXd change = s.gram.solve(s.functions.project(s.even, s.odd));
    s.functions.subtract(change, s.even, s.odd);
    s.amplitudes += change;
  }

  RefinedPoles undetermined(const std::vector<Pole>& poles) const {
    RefinedPoles result;
    result.poles = poles;
    result.amplitudes = MatrixXd::Zero(functions_, even_.cols());
    result.residual = window_.unfold(even_, odd_);
    result.noise_sd = power_.cwiseSqrt();
    result.cost = std::numeric_limits<double>::infinity();
    result.covariance.unknowns = unknowns_;
    result.covariance.functions = functions_;
    result.covariance.variance = power_;
    return result;
  }

  void finish(const std::vector<Pole>& poles, State& now, const PoleMoments& m, RefinedPoles& result) const {
    // Degrees of freedom: the shared poles are counted once.
    const auto n = static_cast<double>(window_.samples);
    const double lost =
        static_cast<double>(functions_) + static_cast<double>(unknowns_) / static_cast<double>(even_.cols());
    const VectorXd variance = now.weight.cwiseInverse() * (n / (n - lost));
    result.poles = poles;
    result.noise_sd = variance.cwiseSqrt();
    result.cost = now.cost;
    result.covariance = PoleCovariance(poles, m, now.amplitudes, variance, window_.half);
    result.amplitudes = std::move(now.amplitudes);
    result.residual = window_.unfold(now.even, now.odd);
  }

  FoldedWindow window_;
  MatrixXd even_, odd_;      // channels, folded
  VectorXd energy_, power_;  // of the channels: sum and mean of the squares
  Index functions_ = 0, unknowns_ = 0;
};

}  // namespace

RefinedPoles refine_poles(const Eigen::Ref<const MatrixXd>& channels, double sample_rate_hz,
                          std::span<const Pole> start, int iteration_limit) {
  return Refiner(channels, sample_rate_hz, start).run(start, iteration_limit);
}

}  // namespace secular

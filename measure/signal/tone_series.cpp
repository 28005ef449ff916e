#include "measure/signal/tone_series.hpp"

#include <Eigen/Cholesky>
#include <limits>
#include <optional>
#include <utility>

#include "measure/signal/pole_equations.hpp"

namespace secular {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr Index powers = 6;  // of time, from 0
constexpr int most_steps = 6;
/// Radians at the ends of the window.
constexpr double longest_turn = 0.5;
/// Share of a channel's energy: a smaller residual is lost in rounding when it is taken as a difference.
constexpr double least_residual = 1e-13;

// (tau^k G)^T y, side by side for k = 0, 1, ...
MatrixXd project_powers(const FoldedFunctions& functions, const MatrixXd& even, const MatrixXd& odd) {
  const Index channels = even.cols();
  // Time times an even function is odd, and the other way round.
  MatrixXd on_even(even.rows(), powers * channels), on_odd(even.rows(), powers * channels);
  on_even.leftCols(channels) = even;
  on_odd.leftCols(channels) = odd;
  for (Index k = 1; k < powers; ++k) {
    const auto timed = functions.window->time.asDiagonal();
    on_even.middleCols(k * channels, channels) = timed * on_odd.middleCols((k - 1) * channels, channels);
    on_odd.middleCols(k * channels, channels) = timed * on_even.middleCols((k - 1) * channels, channels);
  }
  return functions.project(on_even, on_odd);
}

// G^T y and (tau G)^T y after the circular poles turned: their functions become exp(turn tau X^T) times what they
// were, X^T = (0 -1; 1 0).
std::pair<MatrixXd, MatrixXd> turned(std::span<const Pole> poles, const MatrixXd& moments, const VectorXd& turn) {
  const Index channels = moments.cols() / powers;
  std::pair<MatrixXd, MatrixXd> result(moments.leftCols(channels), moments.middleCols(channels, channels));
  Index row = 0, unknown = 0;
  for (const Pole& pole : poles) {
    if (parameter_count(pole) > 0) {
      const double d = turn(unknown++);
      for (Index c = 0; c < channels; ++c) {
        const auto cosine = [&](Index k) { return moments(row, k * channels + c); };
        const auto sine = [&](Index k) { return moments(row + 1, k * channels + c); };
        // Horner: f(k) + d X^T (f(k+1) + d/2 X^T (f(k+2) + ...)).
        const auto sum = [&](Index from, MatrixXd& into) {
          double p = cosine(powers - 1), q = sine(powers - 1);
          for (Index k = powers - 2; k >= from; --k) {
            const double share = d / static_cast<double>(k + 1 - from), turned_p = -share * q;
            q = sine(k) + share * p;
            p = cosine(k) + turned_p;
          }
          into(row, c) = p;
          into(row + 1, c) = q;
        };
        sum(0, result.first);
        sum(1, result.second);
      }
    }
    row += function_count(pole);
  }
  return result;
}

}  // namespace

ToneSeries follow_series(std::span<const Pole> start, const FoldedFunctions& functions, const MatrixXd& even,
                         const MatrixXd& odd, const VectorXd& energy) {
  ToneSeries result;
  result.poles.assign(start.begin(), start.end());
  const auto samples = static_cast<double>(functions.window->samples);
  const double half = functions.window->half;
  const MatrixXd moments = project_powers(functions, even, odd);
  VectorXd turn = VectorXd::Zero(parameter_count(start));
  std::optional<PoleMoments> m;
  std::optional<TimedMoments> sums = functions.closed;
  for (int steps = 0; steps < most_steps && sums; ++steps) {
    Gram gram(sums->zeroth);
    if (!(gram.rcond > 0)) break;
    const auto [projected, timed] = turned(start, moments, turn);
    const MatrixXd amplitudes = gram.solve(projected);
    const VectorXd left = energy - projected.cwiseProduct(amplitudes).colwise().sum().transpose();
    const VectorXd variance = left.cwiseMax(least_residual * energy) / samples, weight = variance.cwiseInverse();
    if (steps == 0) result.start_cost = variance.array().log().sum();
    const PoleTurns turns(result.poles, amplitudes);
    const VectorXd slope = turns.slope(timed - sums->first * amplitudes, weight);
    if (!m) m.emplace(std::move(gram), *sums);
    if (!m->usable) break;
    const MatrixXd hessian = turns.hessian(*m, weight);
    const VectorXd step = -hessian.ldlt().solve(slope);
    const double promised = -0.5 * slope.dot(step);
    if (!step.allFinite() || promised < no_decrease) break;
    result.far = (turn + step).cwiseAbs().maxCoeff() > longest_turn;
    if (result.far && result.moved) break;
    turn += step;
    result.poles = moved({start.begin(), start.end()}, turn, half);
    result.moved = true;
    if (result.far) break;
    if (promised < linear_decrease) break;
    if (step.cwiseAbs().maxCoeff() > 1e-2) m.reset();
    sums = circular_moments(result.poles, *functions.window);
  }
  return result;
}

}  // namespace secular

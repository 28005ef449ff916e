#include "diagnose/inference/held_out.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <map>
#include <random>

#include "diagnose/inference/directions.hpp"
#include "numerics/confidence.hpp"
#include "numerics/distribution.hpp"

namespace secular {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Of two conditions the other one alone would have to predict one, and nothing says how far it can.
constexpr std::size_t fewest_folds = 3;

/// Folds are gathered into so many groups.
constexpr int usual_groups = 8;

constexpr int bootstrap_draws = 4000;
constexpr int placebo_draws = 16;

/// Steps of a fit without what is held out, and how it is damped where one is refused (columns of unit length).
constexpr int most_steps = 12;
constexpr double least_damping = 0.03, more_damping = 10;

/// A step that promises less than this, in variances of the rows about the fit, is not tried.
constexpr double worth_a_step = 0.1;

/// Of intervals.
constexpr double confidence = 0.95;

MatrixXd some_rows(const MatrixXd& all, const std::vector<Index>& which) {
  MatrixXd some(static_cast<Index>(which.size()), all.cols());
  for (std::size_t i = 0; i < which.size(); ++i) some.row(static_cast<Index>(i)) = all.row(which[i]);
  return some;
}

// Rows of every group of folds, folds dealt out in turn; none with fewer than three folds.
std::vector<std::vector<Index>> groups_of_rows(const std::vector<RowLabel>& labels, int groups) {
  std::map<int, std::size_t> group;
  for (const RowLabel& label : labels) group.emplace(label.fold, 0);
  if (group.size() < fewest_folds) return {};
  std::vector<std::vector<Index>> rows(std::min<std::size_t>(static_cast<std::size_t>(groups), group.size()));
  std::size_t next = 0;
  for (auto& [fold, g] : group) g = next++ % rows.size();
  for (std::size_t r = 0; r < labels.size(); ++r) rows[group.at(labels[r].fold)].push_back(static_cast<Index>(r));
  return rows;
}

std::vector<Index> all_but(const std::vector<Index>& held, Index rows) {
  std::vector<Index> rest;
  for (Index r = 0; r < rows; ++r)
    if (!std::binary_search(held.begin(), held.end(), r)) rest.push_back(r);
  return rest;
}

// Rows to first order in the unknowns, each group as the others predict it.
VectorXd held_out_to_first_order(const MatrixXd& jacobian, const VectorXd& rows,
                                 const std::vector<std::vector<Index>>& groups) {
  VectorXd predicted = rows;
  for (const std::vector<Index>& held : groups) {
    const std::vector<Index> training = all_but(held, rows.size());
    const VectorXd step = Directions(some_rows(jacobian, training)).step(some_rows(rows, training), 0);
    for (const Index r : held) predicted(r) += jacobian.row(r).dot(step);
  }
  return predicted;
}

// Rows where those of `training` are least, from a fit to all of them. Its slopes are corrected by what every step
// shows of them (Broyden 1965), and steps are damped where they lead astray.
VectorXd refit_to(const Discrepancy& discrepancy, const Refit& fit, const std::vector<Index>& training) {
  VectorXd unknowns = fit.unknowns, rows = fit.rows;
  if (fit.free.empty()) return rows;
  MatrixXd jacobian = some_rows(fit.jacobian, training);
  VectorXd trained = some_rows(rows, training);
  std::optional<Directions> directions(jacobian);
  double damping = 0;
  const double worth = worth_a_step * std::max(1.0, trained.squaredNorm() / static_cast<double>(training.size()));
  for (int tried = 0; tried < most_steps; ++tried) {
    const VectorXd step = directions->step(trained, damping), expected = jacobian * step;
    if (trained.squaredNorm() - (trained + expected).squaredNorm() < worth) break;
    const VectorXd moved = unknowns_after(fit, unknowns, step);
    const VectorXd next = discrepancy(moved);
    const VectorXd change = some_rows(next, training) - trained;
    if (!next.allFinite() || !((trained + change).squaredNorm() < trained.squaredNorm())) {
      damping = std::max(least_damping, more_damping * damping);
      continue;
    }
    correct_slopes(jacobian, step, change);
    directions.emplace(jacobian);
    unknowns = moved;
    rows = next;
    trained += change;
    damping = damping > least_damping ? damping / more_damping : 0;
  }
  return rows;
}

/// Sums over the rows of a fold.
struct FoldSums {
  double before = 0, after = 0, count = 0;

  double gain() const { return before - after; }
  void add(const FoldSums& other) {
    before += other.before;
    after += other.after;
    count += other.count;
  }
};

std::vector<FoldSums> sums_of_folds(const VectorXd& before, const VectorXd& after,
                                    const std::vector<RowLabel>& labels) {
  std::map<int, FoldSums> by_fold;
  for (std::size_t r = 0; r < labels.size(); ++r) {
    const auto i = static_cast<Index>(r);
    by_fold[labels[r].fold].add({before(i), after(i), 1});
  }
  std::vector<FoldSums> folds;
  for (const auto& [fold, sums] : by_fold) folds.push_back(sums);
  return folds;
}

double root_mean_square(double squares, double count) {
  return std::sqrt(std::max(0.0, squares) / std::max(1.0, count));
}

// Of folds that are drawn. By chance they hold no more than the floor: there all is closed that there is.
double drawn_share(const FoldSums& sums, double floor) {
  const double before = root_mean_square(sums.before, sums.count), after = root_mean_square(sums.after, sums.count),
               left = std::max(0.0, after - floor), closed = before - after;
  if (closed > 0) return closed / (closed + left);
  const double room = before - floor;
  return left == 0 ? 0 : room > 0 ? std::max(-1.0, closed / room) : -1;
}

// Of draws of the share with as many folds as there are, docs/inference.md (30).
void take_interval(const std::vector<FoldSums>& folds, double floor, ClosedShare& share) {
  share.low = -1;
  share.high = 1;
  if (folds.size() < fewest_folds) return;
  std::mt19937_64 random(20001);
  std::vector<double> draws;
  for (int d = 0; d < bootstrap_draws; ++d) {
    FoldSums sum;
    for (std::size_t i = 0; i < folds.size(); ++i) sum.add(folds[random() % folds.size()]);
    draws.push_back(drawn_share(sum, floor));
  }
  std::sort(draws.begin(), draws.end());
  const auto n = static_cast<double>(folds.size());
  const double beyond = normal_upper_tail(confidence_interval(0, std::sqrt(n / (n - 1)), n - 1, confidence).high),
               last = static_cast<double>(draws.size() - 1);
  share.low = draws[static_cast<std::size_t>(beyond * last)];
  share.high = draws[static_cast<std::size_t>(std::ceil((1 - beyond) * last))];
}

}  // namespace

HeldOut predict_held_out(const Discrepancy& discrepancy, const Refit& fit, const std::vector<RowLabel>& labels) {
  HeldOut result;
  result.rows = fit.rows;
  for (const std::vector<Index>& held : groups_of_rows(labels, usual_groups)) {
    result.possible = true;
    const VectorXd rows = refit_to(discrepancy, fit, all_but(held, fit.rows.size()));
    for (const Index r : held) result.rows(r) = rows(r);
  }
  return result;
}

std::optional<double> placebo_closed(const Refit& null, const VectorXd& signature,
                                     const std::vector<RowLabel>& labels, double floor, const GapSpan& span) {
  const std::vector<std::vector<Index>> held = groups_of_rows(labels, usual_groups);
  if (held.empty()) return std::nullopt;
  const VectorXd before = held_out_to_first_order(null.jacobian, null.rows, held);
  MatrixXd columns(null.rows.size(), null.jacobian.cols() + 1);
  columns.leftCols(null.jacobian.cols()) = null.jacobian;
  std::mt19937_64 random(20002);
  double sum = 0;
  for (int draw = 0; draw < placebo_draws; ++draw) {
    std::map<int, double> sign;
    for (const RowLabel& label : labels) sign.emplace(label.fold, 0);
    for (auto& [fold, s] : sign) s = random() % 2 == 0 ? 1 : -1;
    for (std::size_t r = 0; r < labels.size(); ++r) {
      const auto i = static_cast<Index>(r);
      columns(i, columns.cols() - 1) = sign.at(labels[r].fold) * signature(i);
    }
    sum += closed_share(before, held_out_to_first_order(columns, null.rows, held), labels, floor, span).closed;
  }
  return sum / placebo_draws;
}

bool repeats(const VectorXd& before, const VectorXd& after, const std::vector<RowLabel>& labels) {
  const std::vector<FoldSums> folds = sums_of_folds(before.cwiseAbs2(), after.cwiseAbs2(), labels);
  const auto n = static_cast<double>(folds.size());
  if (n < 2) return false;
  double gain = 0, squares = 0;
  for (const FoldSums& fold : folds) gain += fold.gain();
  for (const FoldSums& fold : folds) squares += std::pow(fold.gain() - gain / n, 2);
  return confidence_interval(gain, std::sqrt(n / (n - 1) * squares), n - 1, confidence).low > 0;
}

ClosedShare closed_share(const VectorXd& before, const VectorXd& after, const std::vector<RowLabel>& labels,
                         double floor, const GapSpan& span) {
  const auto count = static_cast<double>(before.size());
  ClosedShare result;
  result.before = root_mean_square(before.squaredNorm(), count);
  result.after = root_mean_square(after.squaredNorm(), count);
  const GapSpan wider = span.with(after - before);
  const VectorXd squares_before = wider.squares(before, labels, floor),
                 squares_after = wider.squares(after, labels, floor);
  const double b = root_mean_square(squares_before.sum(), count), a = root_mean_square(squares_after.sum(), count);
  result.closed = b > floor ? std::clamp((b - a) / (b - floor), -1.0, 1.0) : 0.0;
  take_interval(sums_of_folds(squares_before, squares_after, labels), floor, result);
  return result;
}

}  // namespace secular

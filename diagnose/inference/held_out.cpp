#include "diagnose/inference/held_out.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <set>

namespace secular {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr int bootstrap_draws = 400;
constexpr int placebo_draws = 16;

MatrixXd some_rows(const MatrixXd& all, const std::vector<Index>& which) {
  MatrixXd some(static_cast<Index>(which.size()), all.cols());
  for (std::size_t i = 0; i < which.size(); ++i) some.row(static_cast<Index>(i)) = all.row(which[i]);
  return some;
}

VectorXd solve_steps(const MatrixXd& jacobian, const VectorXd& rows) {
  const VectorXd length = jacobian.colwise().norm().transpose();
  const VectorXd unit = length.unaryExpr([](double x) { return x > 0 ? 1 / x : 0.0; });
  Eigen::BDCSVD<MatrixXd> svd(jacobian * unit.asDiagonal(), Eigen::ComputeThinU | Eigen::ComputeThinV);
  svd.setThreshold(1e-6);
  return -unit.cwiseProduct(svd.solve(rows));
}

// Rows of every group of folds, folds dealt out in turn; none with fewer than three folds.
std::vector<std::vector<Index>> groups_of_rows(const std::vector<RowLabel>& labels, int groups) {
  std::map<int, std::size_t> group;
  for (const RowLabel& label : labels) group.emplace(label.fold, 0);
  if (group.size() < 3) return {};
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
    const VectorXd step = solve_steps(some_rows(jacobian, training), some_rows(rows, training));
    for (const Index r : held) predicted(r) += jacobian.row(r).dot(step);
  }
  return predicted;
}

}  // namespace

HeldOut predict_held_out(const Discrepancy& discrepancy, const Refit& fit, const std::vector<RowLabel>& labels,
                         int groups) {
  HeldOut result;
  result.rows = fit.rows;
  for (const std::vector<Index>& held : groups_of_rows(labels, groups)) {
    result.possible = true;
    const std::vector<Index> training = all_but(held, fit.rows.size());
    VectorXd unknowns = fit.unknowns;
    VectorXd rows = fit.rows;
    double chi_squared = some_rows(rows, training).squaredNorm();
    for (int step = 0; step < 2 && !fit.free.empty(); ++step) {
      const VectorXd change = solve_steps(some_rows(fit.jacobian, training), some_rows(rows, training));
      VectorXd moved = unknowns;
      for (std::size_t f = 0; f < fit.free.size(); ++f)
        moved(static_cast<Index>(fit.free[f])) += fit.scale(static_cast<Index>(f)) * change(static_cast<Index>(f));
      const VectorXd next_rows = discrepancy(moved);
      const double next_chi = some_rows(next_rows, training).squaredNorm();
      if (!(next_chi < chi_squared) || !next_rows.allFinite()) break;
      unknowns = moved;
      rows = next_rows;
      chi_squared = next_chi;
    }
    for (const Index r : held) result.rows(r) = rows(r);
  }
  return result;
}

std::optional<double> placebo_closed(const Refit& null, const VectorXd& signature,
                                     const std::vector<RowLabel>& labels, double floor, int groups) {
  const std::vector<std::vector<Index>> held = groups_of_rows(labels, groups);
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
    sum += closed_share(before, held_out_to_first_order(columns, null.rows, held), labels, floor).closed;
  }
  return sum / placebo_draws;
}

ClosedShare closed_share(const VectorXd& before, const VectorXd& after, const std::vector<RowLabel>& labels,
                         double floor) {
  struct Sums {
    double before = 0, after = 0, count = 0;
  };
  std::map<int, Sums> by_fold;
  for (std::size_t r = 0; r < labels.size(); ++r) {
    Sums& s = by_fold[labels[r].fold];
    const auto i = static_cast<Index>(r);
    s.before += before(i) * before(i);
    s.after += after(i) * after(i);
    s.count += 1;
  }
  std::vector<Sums> folds;
  for (const auto& [fold, sums] : by_fold) folds.push_back(sums);
  const auto share = [&](const Sums& s, ClosedShare& out) {
    out.before = std::sqrt(s.before / std::max(1.0, s.count));
    out.after = std::sqrt(s.after / std::max(1.0, s.count));
    const double room = out.before - floor;
    return room > 0 ? std::clamp((out.before - out.after) / room, -1.0, 1.0) : 0.0;
  };
  ClosedShare result;
  Sums total;
  for (const Sums& s : folds) {
    total.before += s.before;
    total.after += s.after;
    total.count += s.count;
  }
  result.closed = share(total, result);
  std::mt19937_64 random(20001);
  std::vector<double> draws;
  for (int d = 0; d < bootstrap_draws && !folds.empty(); ++d) {
    Sums sum;
    for (std::size_t i = 0; i < folds.size(); ++i) {
      const Sums& s = folds[random() % folds.size()];
      sum.before += s.before;
      sum.after += s.after;
      sum.count += s.count;
    }
    ClosedShare unused;
    draws.push_back(share(sum, unused));
  }
  std::sort(draws.begin(), draws.end());
  if (!draws.empty()) {
    result.low = draws[static_cast<std::size_t>(0.025 * static_cast<double>(draws.size()))];
    result.high = draws[static_cast<std::size_t>(0.975 * static_cast<double>(draws.size() - 1))];
  }
  return result;
}

}  // namespace secular

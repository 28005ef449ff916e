#include "diagnose/held_out.hpp"

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

}  // namespace

HeldOut predict_held_out(const Discrepancy& discrepancy, const Refit& fit, const std::vector<RowLabel>& labels,
                         int groups) {
  HeldOut result;
  result.rows = fit.rows;
  std::map<int, int> order;
  for (const RowLabel& label : labels) order.emplace(label.fold, 0);
  const int folds = static_cast<int>(order.size());
  if (folds < 3) return result;
  result.possible = true;
  int next = 0;
  for (auto& [fold, group] : order) group = next++ % std::min(groups, folds);
  for (int g = 0; g < std::min(groups, folds); ++g) {
    std::vector<Index> training, held;
    for (std::size_t r = 0; r < labels.size(); ++r)
      (order.at(labels[r].fold) == g ? held : training).push_back(static_cast<Index>(r));
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
      if (!(next_chi < chi_squared)) break;
      unknowns = moved;
      rows = next_rows;
      chi_squared = next_chi;
    }
    for (const Index r : held) result.rows(r) = rows(r);
  }
  return result;
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

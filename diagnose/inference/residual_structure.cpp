#include "diagnose/inference/residual_structure.hpp"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>
#include <vector>

#include "diagnose/inference/screening.hpp"
#include "diagnose/thresholds.hpp"
#include "numerics/distribution.hpp"
#include "numerics/orthonormal_span.hpp"

namespace secular {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Balances with fewer rows say nothing of how they change.
constexpr auto& fewest_rows = diagnose_thresholds().balance_rows;

/// A function of which the fitted unknowns leave no more than this share is theirs.
constexpr double rounding_of_functions = 1e-6;

/// Settings that differ by this share were meant to be the same.
constexpr auto& same_setting = diagnose_thresholds().same_setting;

/// The best explanation leaves structure where noise alone would leave as much less often than this.
constexpr auto& structure_alarm = diagnose_thresholds().structure_alarm;

/// A cause closes more of the gap than it leaves.
constexpr auto& least_closing = diagnose_thresholds().least_closing;

/// One row counts with no more standard deviations than this: outliers are no smooth function.
constexpr auto& largest_row = diagnose_thresholds().largest_row;

// Ranks from -1 to 1, equal ones alike: one dwell far from all others has no more weight than they.
VectorXd ranks(const VectorXd& x) {
  std::vector<double> sorted(x.begin(), x.end());
  std::sort(sorted.begin(), sorted.end());
  const double most = std::max(1.0, static_cast<double>(x.size() - 1));
  return x.unaryExpr([&](double value) {
    const double close = same_setting * std::abs(value);
    const auto first = std::lower_bound(sorted.begin(), sorted.end(), value - close),
               last = std::upper_bound(sorted.begin(), sorted.end(), value + close);
    return static_cast<double>((first - sorted.begin()) + (last - sorted.begin()) - 1) / most - 1;
  });
}

bool leaves_no_structure(const ResidualStructure& structure) {
  return structure.p_value >= structure_alarm && structure.smooth_p_value >= structure_alarm;
}

// What an explanation fails to predict of conditions that it has not seen is no more than these differ by when they
// are repeated: a^2 - 1 <= 1 (docs/inference.md, "Share that is closed").
bool predicts_as_well_as_rows_repeat(const ClosedShare& closing) {
  return closing.after * closing.after <= 2;
}

using Balance = std::tuple<std::string, std::string, EffectComponent>;

}  // namespace

SmoothStructure smooth_structure(const Refit& fit, const std::vector<RowLabel>& labels) {
  std::map<Balance, std::vector<Index>> balances;
  for (std::size_t r = 0; r < labels.size(); ++r) {
    const RowLabel& label = labels[r];
    if (label.balance && label.amplitude > 0)
      balances[{label.place, label.harmonic, label.component}].push_back(static_cast<Index>(r));
  }
  MatrixXd functions(fit.rows.size(), 0);
  for (const auto& [balance, rows] : balances) {
    if (rows.size() < fewest_rows) continue;
    const auto count = static_cast<Index>(rows.size());
    VectorXd amplitude(count), level(count), frequency(count), time(count);
    for (Index i = 0; i < count; ++i) {
      const RowLabel& label = labels[static_cast<std::size_t>(rows[static_cast<std::size_t>(i)])];
      amplitude(i) = label.amplitude;
      level(i) = label.level;
      frequency(i) = label.frequency;
      time(i) = label.time_s;
    }
    const VectorXd a = ranks(amplitude), l = ranks(level), f = ranks(frequency), t = ranks(time);
    MatrixXd columns(count, 9);
    columns << VectorXd::Ones(count), a, a.cwiseAbs2(), a.cwiseProduct(a.cwiseAbs2()), l, l.cwiseAbs2(), f,
        f.cwiseAbs2(), t;
    const Index before = functions.cols();
    functions.conservativeResize(Eigen::NoChange, before + columns.cols());
    functions.rightCols(columns.cols()).setZero();
    functions(rows, Eigen::seqN(before, columns.cols())) = columns;
  }
  SmoothStructure result;
  if (functions.cols() == 0) return result;
  MatrixXd beside = without_span(basis_of(fit.jacobian), functions);
  for (Index c = 0; c < beside.cols(); ++c)
    if (!(beside.col(c).norm() > rounding_of_functions * functions.col(c).norm())) beside.col(c).setZero();
  const MatrixXd basis = basis_of(beside);
  result.squares = (basis.transpose() * fit.rows.cwiseMin(largest_row).cwiseMax(-largest_row)).squaredNorm();
  result.freedom = static_cast<double>(basis.cols());
  if (basis.cols() > 0) result.p_value = chi_squared_upper_tail(result.squares, result.freedom);
  return result;
}

ResidualStructure residual_structure_of(const Refit& fit, const std::vector<RowLabel>& labels, double freedom,
                                        double explained) {
  const SmoothStructure smooth = smooth_structure(fit, labels);
  ResidualStructure left;
  left.p_value = chi_squared_upper_tail(fit.chi_squared, freedom - static_cast<double>(fit.rank));
  left.smooth_p_value = smooth.p_value;
  left.smooth_share = smooth.excess() > 0 ? std::sqrt(smooth.excess() / (smooth.excess() + explained)) : 0;
  return left;
}

bool closes_more_than_it_leaves(const ClosedShare& closing) {
  return closing.closed >= least_closing && closing.low >= least_closing;
}

bool closes_most(const ClosedShare& closing) {
  return closes_more_than_it_leaves(closing) && closing.closed >= diagnose_thresholds().most_of_the_gap;
}

Reach reach_of(const ResidualStructure& structure, const ClosedShare& closing) {
  if (!closes_more_than_it_leaves(closing)) return Reach::little;
  if (leaves_no_structure(structure)) return predicts_as_well_as_rows_repeat(closing) ? Reach::all : Reach::little;
  return closes_most(closing) ? Reach::approximate : Reach::little;
}

std::string what_is_missing(const ResidualStructure& structure, const ClosedShare& closing) {
  if (!(closing.closed >= least_closing)) return "the best explanation closes less of the gap than it leaves";
  if (!closes_more_than_it_leaves(closing))
    return "held-out conditions do not show that the best explanation closes half of the gap";
  if (leaves_no_structure(structure))
    return fmt::format(
        "the best explanation fits, but misses conditions that were held out by {:.3g} times the repeatability: "
        "too few conditions tell its law from others",
        closing.after);
  return fmt::format("the best explanation closes less than {:.0f} % of the gap and leaves structure (p = {:.1g})",
                     100 * diagnose_thresholds().most_of_the_gap,
                     std::min(structure.p_value, structure.smooth_p_value));
}

}  // namespace secular

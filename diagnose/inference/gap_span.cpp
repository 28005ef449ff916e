#include "diagnose/inference/gap_span.hpp"

#include <algorithm>

#include "diagnose/inference/screening.hpp"
#include "diagnose/thresholds.hpp"
#include "numerics/distribution.hpp"

namespace secular {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// A column of which the span leaves no more than this share is in it.
constexpr double least_beside = 1e-6;

// Columns of a fit's slopes that the model as it is has not.
std::vector<Index> slopes_of_members(const Refit& fit, const Refit& null) {
  std::vector<Index> columns;
  for (std::size_t f = 0; f < fit.free.size(); ++f)
    if (std::find(null.free.begin(), null.free.end(), fit.free[f]) == null.free.end())
      columns.push_back(static_cast<Index>(f));
  return columns;
}

}  // namespace

GapSpan::GapSpan(const MatrixXd& columns) : basis_(basis_of(columns)) {}

GapSpan GapSpan::with(const VectorXd& column) const {
  if (basis_.cols() == 0) return *this;
  GapSpan wider = *this;
  // Twice is enough (Kahan and Parlett): a column that is nearly in the span leaves what is beside it.
  VectorXd beside = without_span(basis_, without_span(basis_, column));
  if (!(beside.norm() > least_beside * column.norm())) return wider;
  wider.basis_.conservativeResize(Eigen::NoChange, basis_.cols() + 1);
  wider.basis_.rightCols(1) = beside.normalized();
  return wider;
}

VectorXd GapSpan::squares(const VectorXd& rows, double floor) const {
  if (basis_.cols() == 0) return rows.cwiseAbs2();
  const VectorXd along = basis_ * (basis_.transpose() * rows);
  return along.cwiseProduct(2 * rows - along) +
         floor * floor * (VectorXd::Ones(rows.size()) - basis_.rowwise().squaredNorm());
}

bool GapSpan::holds_all_but_noise(const VectorXd& rows) const {
  const double beside = rows.squaredNorm() - (basis_.transpose() * rows).squaredNorm();
  const auto directions = static_cast<double>(rows.size() - basis_.cols());
  return directions > 0 && chi_squared_upper_tail(beside, directions) >= diagnose_thresholds().structure_alarm;
}

GapSpan span_of_gap(const Refit& null, const std::vector<Explanation>& explanations, const VectorXd& unfitted) {
  MatrixXd columns = null.jacobian;
  const auto add = [&](const MatrixXd& more) {
    columns.conservativeResize(null.rows.size(), columns.cols() + more.cols());
    columns.rightCols(more.cols()) = more;
  };
  if (unfitted.size() > 0) add(unfitted - null.rows);
  for (const Explanation& e : explanations) {
    add(e.fit.jacobian(Eigen::all, slopes_of_members(e.fit, null)));
    add(e.fit.rows - null.rows);
  }
  return GapSpan(columns);
}

}  // namespace secular

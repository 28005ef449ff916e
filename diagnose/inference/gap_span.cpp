#include "diagnose/inference/gap_span.hpp"

#include <algorithm>

#include "diagnose/inference/screening.hpp"
#include "numerics/orthonormal_span.hpp"

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
  const VectorXd squares = rows.cwiseAbs2();
  if (basis_.cols() == 0) return squares;
  const VectorXd along = basis_ * (basis_.transpose() * rows), taken = along.cwiseProduct(2 * rows - along),
                 beside = floor * floor * (VectorXd::Ones(rows.size()) - basis_.rowwise().squaredNorm());
  return (squares - taken).sum() < beside.sum() ? VectorXd(taken + beside) : squares;
}

GapSpan span_of_gap(const Refit& null, const std::vector<Explanation>& explanations, const VectorXd& unfitted) {
  std::vector<MatrixXd> parts = {null.jacobian};
  if (unfitted.size() > 0) parts.emplace_back(unfitted - null.rows);
  for (const Explanation& e : explanations) {
    parts.emplace_back(e.fit.jacobian(Eigen::all, slopes_of_members(e.fit, null)));
    parts.emplace_back(e.fit.rows - null.rows);
  }
  Index count = 0;
  for (const MatrixXd& part : parts) count += part.cols();
  MatrixXd columns(null.rows.size(), count);
  Index place = 0;
  for (const MatrixXd& part : parts) {
    columns.middleCols(place, part.cols()) = part;
    place += part.cols();
  }
  return GapSpan(columns);
}

}  // namespace secular

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

VectorXd GapSpan::squares(const VectorXd& rows) const {
  if (basis_.cols() == 0) return rows.cwiseAbs2();
  const VectorXd along = basis_ * (basis_.transpose() * rows);
  return along.cwiseProduct(2 * rows - along);
}

VectorXd GapSpan::shares(Index rows) const {
  if (basis_.cols() == 0) return VectorXd::Ones(rows);
  return basis_.rowwise().squaredNorm();
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

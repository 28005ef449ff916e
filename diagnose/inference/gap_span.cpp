#include "diagnose/inference/gap_span.hpp"

#include <algorithm>
#include <map>

#include "diagnose/inference/screening.hpp"
#include "diagnose/thresholds.hpp"
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

/// Of a fold's rows.
struct Fold {
  double rows = 0, moved = 0, excess = 0;
};

// By row: how often its excess over what is expected counts, docs/inference.md (49a). `moved`: squares of the rows
// of an orthonormal basis; `excess` in units of what is expected of a row that nothing moves.
VectorXd weights_beside(const VectorXd& moved, const VectorXd& excess, const std::vector<RowLabel>& labels) {
  std::map<int, Fold> folds;
  for (std::size_t r = 0; r < labels.size(); ++r) {
    Fold& fold = folds[labels[r].fold];
    fold.rows += 1;
    fold.moved += moved(static_cast<Index>(r));
    fold.excess += excess(static_cast<Index>(r));
  }
  double squares = 0;
  for (const auto& [number, fold] : folds) squares += fold.moved * fold.moved / fold.rows;
  const double scale = moved.sum() / squares, effective_rows = scale * moved.sum();
  double guessed = 0;
  for (const auto& [number, fold] : folds) guessed += scale * fold.moved / fold.rows * fold.excess;
  guessed = std::max(0.0, guessed);
  const double more = std::max(0.0, excess.sum() - guessed),
               of_chance = diagnose_thresholds().quiet_rows_sd *
                           std::sqrt(std::max(0.0, 2 * (static_cast<double>(moved.size()) - effective_rows))),
               as_they_are = more > 0 ? 1 / (1 + std::pow(of_chance / more, 8)) : 0,
               by_guess = guessed > 0 ? 1 - as_they_are : 0;
  VectorXd weights(moved.size());
  for (std::size_t r = 0; r < labels.size(); ++r) {
    const Fold& fold = folds.at(labels[r].fold);
    weights(static_cast<Index>(r)) = by_guess * scale * fold.moved / fold.rows + as_they_are;
  }
  return weights;
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

VectorXd GapSpan::squares(const VectorXd& rows, const std::vector<RowLabel>& labels, double floor) const {
  const VectorXd squares = rows.cwiseAbs2();
  if (basis_.cols() == 0) return squares;
  const VectorXd along = basis_ * (basis_.transpose() * rows), moved = basis_.rowwise().squaredNorm(),
                 expected = floor * floor * (VectorXd::Ones(rows.size()) - moved),
                 excess = (rows - along).cwiseAbs2() - expected,
                 weights = weights_beside(moved, excess / (floor * floor), labels);
  return squares - (VectorXd::Ones(rows.size()) - weights).cwiseProduct(excess);
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

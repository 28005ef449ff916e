#include "thesis/procedures/added_last_anova.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <stdexcept>

#include "estimator/regression/linear_fit.hpp"
#include "numerics/distribution.hpp"

namespace secular {

using Eigen::Index;

namespace {

double tail_or_zero(double f, double numerator, double denominator) {
  const double p = f_upper_tail(f, numerator, denominator);
  return p < std::numeric_limits<double>::min() ? 0 : p;
}

}  // namespace

AnovaTable added_last_anova(const Eigen::Ref<const Eigen::MatrixXd>& design,
                            const Eigen::Ref<const Eigen::VectorXd>& response, std::span<const int> cluster,
                            const std::vector<AnovaTerm>& terms) {
  for (const AnovaTerm& term : terms)
    for (const int column : term.columns)
      if (column < 0 || column >= design.cols()) throw std::invalid_argument("an ANOVA term names no column");
  const LinearFit whole = linear_fit(design, response, cluster);
  AnovaTable table;
  table.residual = whole.residual.squaredNorm();
  table.total = response.squaredNorm();
  table.residual_degrees_of_freedom = static_cast<int>(design.rows() - whole.rank);
  table.total_degrees_of_freedom = static_cast<int>(design.rows());
  table.r_squared = 1 - table.residual / table.total;
  table.clusters = static_cast<int>(std::set<int>(cluster.begin(), cluster.end()).size());
  table.clustered_degrees_of_freedom = table.clusters - 1;
  for (const AnovaTerm& term : terms) {
    AnovaRow row;
    row.name = term.name;
    const auto q = static_cast<Index>(term.columns.size());
    std::vector<Index> kept;
    for (Index c = 0; c < design.cols(); ++c)
      if (std::find(term.columns.begin(), term.columns.end(), static_cast<int>(c)) == term.columns.end())
        kept.push_back(c);
    double without = table.total;
    Index rank_without = 0;
    if (!kept.empty()) {
      const LinearFit rest = linear_fit(Eigen::MatrixXd(design(Eigen::all, kept)), response, cluster);
      without = rest.residual.squaredNorm();
      rank_without = rest.rank;
    }
    // Columns that the others hold already take nothing away with them.
    row.degrees_of_freedom = static_cast<int>(whole.rank - rank_without);
    row.f = row.p = std::numeric_limits<double>::quiet_NaN();
    if (row.degrees_of_freedom > 0) {
      row.sum_of_squares = without - table.residual;
      const double variance = table.residual / table.residual_degrees_of_freedom;
      row.f = row.sum_of_squares / row.degrees_of_freedom / variance;
      row.p = tail_or_zero(row.f, row.degrees_of_freedom, table.residual_degrees_of_freedom);
    }
    row.clustered_f = row.clustered_p = std::numeric_limits<double>::quiet_NaN();
    const bool identifiable = std::all_of(term.columns.begin(), term.columns.end(), [&](int column) {
      return whole.identifiable[static_cast<std::size_t>(column)];
    });
    if (identifiable && whole.covariance_kind == CovarianceKind::clustered && table.clusters > q) {
      const Eigen::VectorXd value = whole.coefficients(term.columns);
      const Eigen::MatrixXd covariance = whole.covariance(term.columns, term.columns);
      // Coefficients differ by many powers of ten.
      const Eigen::VectorXd scale = covariance.diagonal().cwiseSqrt().cwiseInverse();
      const Eigen::VectorXd z = scale.cwiseProduct(value);
      const Eigen::MatrixXd correlation = scale.asDiagonal() * covariance * scale.asDiagonal();
      const double wald = z.dot(correlation.ldlt().solve(z));
      const double groups = table.clusters, terms_of = static_cast<double>(q);
      row.clustered_f = wald * (groups - terms_of) / ((groups - 1) * terms_of);
      row.clustered_p = tail_or_zero(row.clustered_f, terms_of, groups - terms_of);
    }
    table.rows.push_back(std::move(row));
  }
  return table;
}

}  // namespace secular

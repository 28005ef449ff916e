#pragma once

#include <Eigen/Core>
#include <span>
#include <string>
#include <vector>

namespace secular {

/// Columns of a regression that are tested together.
struct AnovaTerm {
  std::string name;
  std::vector<int> columns;
};

struct AnovaRow {
  std::string name;
  int degrees_of_freedom = 0;  ///< by which the rank falls without the term; 0: it is in the others
  double sum_of_squares = 0;   ///< by which the residual grows without the term
  double f = 0, p = 1;  ///< every row taken as independent, as the thesis does; NaN without degrees of freedom
  double clustered_f = 0, clustered_p = 1;  ///< rows of one condition taken as dependent; NaN where that fails
};

/// Added-last analysis of variance, thesis Appendix D.
struct AnovaTable {
  std::vector<AnovaRow> rows;
  double residual = 0, total = 0;  ///< sums of squares; total is not centred: the models have no constant
  int residual_degrees_of_freedom = 0, total_degrees_of_freedom = 0;
  int clusters = 0;
  int clustered_degrees_of_freedom = 0;  ///< denominator for terms of one column: clusters - 1
  double r_squared = 0;                  ///< 1 - residual/total
};

/// Partial F tests of `terms` against the whole model. Naive: F = (SS/d)/(residual/(rows - rank)) on d, by which
/// the rank falls without the term, and rows - rank degrees of freedom. Clustered: Wald statistic W of the term's q
/// coefficients in the covariance of the delete-one-cluster jackknife, F = W (G - q)/((G - 1) q) on q and G - q
/// degrees of freedom for G clusters (Hotelling). Throws std::invalid_argument for sizes that differ and columns
/// that do not exist.
AnovaTable added_last_anova(const Eigen::Ref<const Eigen::MatrixXd>& design,
                            const Eigen::Ref<const Eigen::VectorXd>& response, std::span<const int> cluster,
                            const std::vector<AnovaTerm>& terms);

}  // namespace secular

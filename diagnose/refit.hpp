#pragma once

#include <Eigen/Core>
#include <vector>

#include "diagnose/discrepancy.hpp"

namespace secular {

/// Least squares over some of the unknowns.
struct Refit {
  Eigen::VectorXd unknowns;
  Eigen::VectorXd rows;  ///< at the end
  double chi_squared = 0;
  std::vector<std::size_t> free;  ///< unknowns that were fitted
  Eigen::VectorXd scale;          ///< by free unknown: a change of it that moves the rows by about one
  Eigen::MatrixXd jacobian;       ///< rows x free, per scaled unknown
  Eigen::Index rank = 0;
  Eigen::MatrixXd covariance;  ///< of the free unknowns, for rows of unit variance; identifiable directions only
  std::vector<bool> identifiable;  ///< by free unknown
  bool converged = false;
};

struct RefitOptions {
  int iterations = 25;
  unsigned threads = 1;
};

/// Changes of each unknown that move the rows by about one standard deviation in all; 0 where nothing moves them.
Eigen::VectorXd natural_scales(const Discrepancy& discrepancy, const Eigen::VectorXd& unknowns,
                               const std::vector<std::size_t>& which, unsigned threads);

/// Columns of d rows / d (unknown / scale) by central differences of half a scale.
Eigen::MatrixXd jacobian_of(const Discrepancy& discrepancy, const Eigen::VectorXd& unknowns,
                            const std::vector<std::size_t>& which, const Eigen::VectorXd& scale, unsigned threads);

/// Levenberg-Marquardt with differences. Directions that the rows do not see stay where they start.
Refit refit(const Discrepancy& discrepancy, const Eigen::VectorXd& start, const std::vector<std::size_t>& free,
            const RefitOptions& options = {});

}  // namespace secular

#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

namespace secular {

/// docs/inference.md (53): rows of which least squares is the estimate by instruments, Z'(y - X c) = 0.
struct InstrumentRows {
  Eigen::MatrixXd design;    ///< of the columns X what the instruments Z make of them, Z onto
  Eigen::VectorXd response;  ///< that leaves y - X c
  Eigen::MatrixXd onto;      ///< instruments x columns
};

/// `instruments`, `columns`: rows x coefficients, `response`: rows; whitened. Instruments that depend on one
/// another leave as many directions of c open.
InstrumentRows instrument_rows(const Eigen::MatrixXd& instruments, const Eigen::MatrixXd& columns,
                               const Eigen::VectorXd& response);

/// docs/inference.md (55): how much more of columns than chance their instruments explain, least over all
/// coefficients: F of the first stage, where what is left of columns scatters from record to record. `explained`:
/// InstrumentRows::design; `record`: by row. Infinite where columns are their instruments.
double instrument_relevance(const Eigen::MatrixXd& explained, const Eigen::MatrixXd& columns,
                            const std::vector<std::size_t>& record);

}  // namespace secular

#pragma once

#include <Eigen/Core>

namespace secular {

/// Correlation matrix of the columns of the paired Hankel matrix [V|U] of thesis Eq. (C.4), of size ar_order +
/// ma_order + 2 (means removed), as in Figs. C.2 and C.4.
Eigen::MatrixXd delayed_correlation(const Eigen::Ref<const Eigen::VectorXd>& input,
                                    const Eigen::Ref<const Eigen::VectorXd>& output, int ar_order, int ma_order);

/// Correlation between the two blocks of that matrix as one number: the RV coefficient, the sum of squares of the
/// cross block over the geometric mean of those of the diagonal blocks. One when input and output span the same
/// functions, zero when ARMA cannot relate them.
double input_output_correlation(const Eigen::Ref<const Eigen::VectorXd>& input,
                                const Eigen::Ref<const Eigen::VectorXd>& output, int ar_order, int ma_order);

}  // namespace secular

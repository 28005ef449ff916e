#pragma once

#include <Eigen/Core>

namespace secular {

/// Auto-regressive moving-average relation of thesis Eq. (C.1),
/// sum_k alpha_k v(i+k) = sum_k beta_k u(i+k), alpha_0 = 1.
struct ArmaFit {
  Eigen::VectorXd alpha;  ///< [0..n], the first one
  Eigen::VectorXd beta;   ///< [0..m]
  double residual = 0;    ///< root mean square of the equation error over that of v
};

/// Least squares on the paired Hankel matrix, Eqs. (C.2)-(C.5), n = ar_order, m = ma_order. With the relation (C.1)
/// the unknowns that belong to the columns of u are -beta: the printed (C.5) leaves the sign out.
ArmaFit arma(const Eigen::Ref<const Eigen::VectorXd>& input, const Eigen::Ref<const Eigen::VectorXd>& output,
             int ar_order, int ma_order);

/// Correlation matrix of the columns of the paired Hankel matrix [V|U] of Eq. (C.4), of size ar_order + ma_order +
/// 2 (means removed), as in Figs. C.2 and C.4.
Eigen::MatrixXd delayed_correlation(const Eigen::Ref<const Eigen::VectorXd>& input,
                                    const Eigen::Ref<const Eigen::VectorXd>& output, int ar_order, int ma_order);

/// Correlation between the two blocks of that matrix as one number: the RV coefficient, the sum of squares of the
/// cross block over the geometric mean of those of the diagonal blocks. One when input and output span the same
/// functions, zero when ARMA cannot relate them.
double input_output_correlation(const Eigen::Ref<const Eigen::VectorXd>& input,
                                const Eigen::Ref<const Eigen::VectorXd>& output, int ar_order, int ma_order);

}  // namespace secular

#pragma once

#include <Eigen/Core>

namespace secular {

/// Modal responses from physical ones, thesis Eq. (3.19): v^T = pinv(Phi) y^T for mass-normalised shapes Phi
/// (channels x modes, more modes than channels is refused with std::invalid_argument).
struct ModalFilter {
  Eigen::MatrixXd inverse;  ///< modes x channels
  double condition = 0;     ///< largest over smallest singular value of the weighted shapes

  /// samples x channels to samples x modes; works for rows of Fourier coefficients as well.
  Eigen::MatrixXd responses(const Eigen::Ref<const Eigen::MatrixXd>& channels) const;
  Eigen::MatrixXcd responses(const Eigen::Ref<const Eigen::MatrixXcd>& coefficients) const;
  /// Covariance of the modal responses for independent noise of the channels.
  Eigen::MatrixXd covariance(const Eigen::Ref<const Eigen::VectorXd>& noise_sd) const;
};

/// Least squares in channels divided by noise_sd, or in the channels as they are where it is empty.
ModalFilter modal_filter(const Eigen::Ref<const Eigen::MatrixXd>& shapes,
                         const Eigen::Ref<const Eigen::VectorXd>& noise_sd = Eigen::VectorXd());

}  // namespace secular

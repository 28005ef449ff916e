#include "measure/modal/motion_columns.hpp"

namespace secular {

Eigen::VectorXcd exponential(Eigen::Index rows, double rate, std::complex<double> pole) {
  Eigen::VectorXcd e(rows);
  for (Eigen::Index i = 0; i < rows; ++i) e(i) = std::exp(pole * (static_cast<double>(i) / rate));
  return e;
}

Eigen::MatrixXd motion_columns(const Eigen::VectorXcd& motion) {
  Eigen::MatrixXd columns(motion.size(), 2);
  columns << 2 * motion.real(), -2 * motion.imag();
  return columns;
}

}  // namespace secular

#pragma once

// The decompositions that the project uses in several places: declared `extern template`
// or instantiated, as SECULAR_INSTANCE says. Member templates are listed with the arguments that occur.
#define SECULAR_DENSE_INSTANCES                                                                                   \
  namespace Eigen {                                                                                               \
  SECULAR_INSTANCE class JacobiSVD<MatrixXd>;                                                                     \
  SECULAR_INSTANCE class BDCSVD<MatrixXd>;                                                                        \
  SECULAR_INSTANCE class HouseholderQR<MatrixXd>;                                                                 \
  SECULAR_INSTANCE class ColPivHouseholderQR<MatrixXd>;                                                           \
  SECULAR_INSTANCE class CompleteOrthogonalDecomposition<MatrixXd>;                                               \
  SECULAR_INSTANCE class PartialPivLU<MatrixXd>;                                                                  \
  SECULAR_INSTANCE class PartialPivLU<MatrixXcd>;                                                                 \
  SECULAR_INSTANCE class LLT<MatrixXd>;                                                                           \
  SECULAR_INSTANCE class LDLT<MatrixXd>;                                                                          \
  SECULAR_INSTANCE class SelfAdjointEigenSolver<MatrixXd>;                                                        \
  SECULAR_INSTANCE class EigenSolver<MatrixXd>;                                                                   \
  SECULAR_INSTANCE class HessenbergDecomposition<MatrixXd>;                                                       \
  SECULAR_INSTANCE class RealSchur<MatrixXd>;                                                                     \
  SECULAR_INSTANCE EigenSolver<MatrixXd>& EigenSolver<MatrixXd>::compute(const EigenBase<MatrixXd>&, bool);       \
  SECULAR_INSTANCE RealSchur<MatrixXd>& RealSchur<MatrixXd>::compute(const EigenBase<MatrixXd>&, bool);           \
  SECULAR_INSTANCE SelfAdjointEigenSolver<MatrixXd>& SelfAdjointEigenSolver<MatrixXd>::compute(                   \
      const EigenBase<MatrixXd>&, int);                                                                           \
  SECULAR_INSTANCE void HouseholderQR<MatrixXd>::_solve_impl(const VectorXd&, VectorXd&) const;                   \
  SECULAR_INSTANCE void HouseholderQR<MatrixXd>::_solve_impl(const MatrixXd&, MatrixXd&) const;                   \
  SECULAR_INSTANCE void ColPivHouseholderQR<MatrixXd>::_solve_impl(const VectorXd&, VectorXd&) const;             \
  SECULAR_INSTANCE void ColPivHouseholderQR<MatrixXd>::_solve_impl(const MatrixXd&, MatrixXd&) const;             \
  SECULAR_INSTANCE void CompleteOrthogonalDecomposition<MatrixXd>::_solve_impl(const VectorXd&, VectorXd&) const; \
  SECULAR_INSTANCE void CompleteOrthogonalDecomposition<MatrixXd>::_solve_impl(const MatrixXd&, MatrixXd&) const; \
  SECULAR_INSTANCE void LDLT<MatrixXd>::_solve_impl(const VectorXd&, VectorXd&) const;                            \
  SECULAR_INSTANCE void LDLT<MatrixXd>::_solve_impl(const MatrixXd&, MatrixXd&) const;                            \
  SECULAR_INSTANCE void LLT<MatrixXd>::_solve_impl(const VectorXd&, VectorXd&) const;                             \
  SECULAR_INSTANCE void LLT<MatrixXd>::_solve_impl(const MatrixXd&, MatrixXd&) const;                             \
  }

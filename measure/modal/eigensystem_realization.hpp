#pragma once

#include <Eigen/Core>
#include <vector>

namespace secular {

/// Responses Y(k), k = 0 .. N-1, each p x q: responses to a unit pulse of each of q references at sample 0, or the
/// free motion after q releases. (Appendix A counts k from one.)
using ResponseSequence = std::vector<Eigen::MatrixXd>;

/// A realization with diagonal A, Eq. (A.4): Y(0) = C B + D, Y(k) = C A^k B. Only Y(0) sees D.
struct Realization {
  Eigen::VectorXcd z;      ///< 2n, diagonal of A
  Eigen::VectorXcd poles;  ///< 2n, ln(z) * sample rate, rad/s, Eq. (A.12)
  Eigen::MatrixXcd C;      ///< p x 2n, mode shapes of arbitrary scale
  Eigen::MatrixXcd B;      ///< 2n x q, initial modal amplitudes
  Eigen::MatrixXd D;       ///< p x q, initial pulse amplitudes; zero without feed-through
};

struct HankelSize {
  Eigen::Index rows = 0, columns = 0;  ///< in blocks of p x q; rows + columns + first <= N
};

/// Block sizes for N samples and the given largest model order: s = ceil(4n/q) block columns (the rule of thumb of
/// Appendix A), fewer where N does not allow it, and all remaining samples as block rows up to `row_limit` rows.
HankelSize hankel_size(Eigen::Index samples, Eigen::Index responses, Eigen::Index references, int largest_order,
                       bool feedthrough, Eigen::Index row_limit = 4000);

/// Eigensystem Realization Algorithm (Ho-Kalman), Appendix A: one singular-value decomposition of the block Hankel
/// matrix, then a realization of any order from its leading singular vectors.
///
/// With feed-through (accelerance) the Hankel matrices leave Y(0) out, which D is then found from; without, they
/// begin with Y(0) and D is zero. Relative accuracy of exact data is that of the singular-value decomposition:
/// never a Gram matrix.
class EigensystemRealization {
 public:
  /// Throws std::invalid_argument for unequal block sizes, fewer than four samples, a block size outside the data,
  /// a sample rate that is not positive, samples that are not finite.
  EigensystemRealization(const ResponseSequence& responses, double sample_rate_hz, bool feedthrough,
                         HankelSize size);

  const Eigen::VectorXd& singular_values() const { return singular_values_; }
  /// Number of singular values above 1e-13 times the largest: no realization has a higher order.
  Eigen::Index rank() const { return rank_; }
  /// Order 2n, at most rank(). Throws std::invalid_argument outside 1 .. rank().
  Realization realize(Eigen::Index order) const;

 private:
  double sample_rate_hz_;
  bool feedthrough_;
  Eigen::VectorXd singular_values_;
  Eigen::Index rank_ = 0;
  Eigen::MatrixXd first_rows_;     // E_p^T P
  Eigen::MatrixXd first_columns_;  // Q^T E_q
  Eigen::MatrixXd shifted_;        // P^T H(shifted) Q
  Eigen::MatrixXd pulse_;          // Y(0)
};

}  // namespace secular

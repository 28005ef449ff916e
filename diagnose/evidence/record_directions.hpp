#pragma once

#include <Eigen/Core>
#include <vector>

namespace secular {

/// What in the rows of one record may be its own: unknowns c of unit variance that move the rows by C c, such as
/// the lateness of its responses and its natural frequencies' departure from those of all records. Rows with the
/// covariance I + C C' are multiplied by its inverse root (docs/inference.md (24), (26)).
class RecordDirections {
 public:
  /// `rows`: places among all rows. `columns`: C, of these rows. `put_in`: values of c that the model was given,
  /// for which rows come to be evaluated.
  RecordDirections(std::vector<Eigen::Index> rows, Eigen::MatrixXd columns, Eigen::VectorXd put_in);

  const std::vector<Eigen::Index>& rows() const { return rows_; }
  /// Rows of all records, as evaluated, to rows of unit variance about the model without what was put in.
  void whiten_rows(Eigen::Ref<Eigen::VectorXd> all) const;
  /// The same for slopes, which do not feel what was put in.
  void whiten_slopes(Eigen::Ref<Eigen::MatrixXd> all) const;
  /// The likeliest c, from rows as evaluated.
  Eigen::VectorXd likeliest(const Eigen::VectorXd& all) const;
  Eigen::Index size() const { return columns_.cols(); }
  /// Length of what a change of c does to the rows.
  double length_of(const Eigen::VectorXd& change) const { return (columns_ * change).norm(); }

  /// One entry of c by the rows alone, as if it could be anything, and its variance; infinite where they do not
  /// tell.
  struct Told {
    double value = 0, variance = 0;
  };
  Told told(const Eigen::VectorXd& all, Eigen::Index entry) const;

 private:
  std::vector<Eigen::Index> rows_;
  Eigen::MatrixXd columns_;
  Eigen::VectorXd put_in_;
  Eigen::MatrixXd basis_;    // of the columns, orthonormal
  Eigen::VectorXd dropped_;  // by basis vector: 1 - 1/sqrt(1 + s^2), s singular values
};

/// Standard deviation between records of values with variances of their own about a combination of `functions`
/// (records x functions, of full rank, fewer than records): where the weighted sum of squares about the best one is
/// its expectation (R. C. Paule and J. Mandel, J. Res. Natl. Bur. Stand. 87, 1982); and the probability that values
/// as far from it as these come of their own variances alone.
struct Between {
  double sd = 0, p_value = 1;
};
Between between_records(const Eigen::VectorXd& values, const Eigen::VectorXd& variances,
                        const Eigen::MatrixXd& functions);

}  // namespace secular

#pragma once

#include <Eigen/Core>
#include <array>
#include <complex>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

namespace secular {

/// Integers over up to two base phases: the line at n[0]*nu_0 + n[1]*nu_1.
using LinePhase = std::array<int, 2>;

/// Periodic and doubly periodic motions as Fourier coefficients and as samples over one turn of every base phase:
/// x = c_0 + sum over lines (c_n exp(i n.theta) + conj), c_0 real. Lines are one half of the integer lattice
/// (n[1] > 0, or n[1] = 0 and n[0] > 0), the zero phase first; a line's coefficient is half of its peak.
class Torus {
 public:
  /// One dimension: lines 0..highest. Two: all with |n_0| + |n_1| <= highest. `points` in each dimension.
  Torus(int dimensions, int highest, Eigen::Index points);

  int dimensions() const { return dimensions_; }
  Eigen::Index lines() const { return static_cast<Eigen::Index>(phases_.size()); }
  Eigen::Index points() const { return basis_.rows(); }
  const LinePhase& phase(Eigen::Index line) const { return phases_[static_cast<std::size_t>(line)]; }
  /// First base phase of a point. Half a step off zero: points do not fall on the turning points of a leading line.
  double angle(Eigen::Index point) const;
  std::optional<Eigen::Index> find(const LinePhase& phase) const;

  /// coefficients: rows x lines -> rows x points.
  Eigen::MatrixXd samples(const Eigen::MatrixXcd& coefficients) const;
  /// Of one line alone.
  Eigen::RowVectorXd samples_of_line(Eigen::Index line, std::complex<double> coefficient) const;
  /// samples: rows x points -> rows x lines.
  Eigen::MatrixXcd coefficients(const Eigen::MatrixXd& samples) const;

  /// samples: rows x points -> coefficients on all sums and differences of two lines.
  Eigen::MatrixXcd coefficients_of_sums(const Eigen::MatrixXd& samples) const;
  /// Adds to `lines` those of a product with one line alone, samples_of_line(line, coefficient): with b the other
  /// factor's coefficients_of_sums and b_-m = conj(b_m), line n of b(theta) (a exp(i l.theta) + conj) is
  ///   a b_(n-l) + conj(a) b_(n+l),
  /// whatever the points alias.
  void add_product(const Eigen::Ref<const Eigen::RowVectorXcd, 0, Eigen::InnerStride<>>& sums, Eigen::Index line,
                   std::complex<double> coefficient,
                   Eigen::Ref<Eigen::RowVectorXcd, 0, Eigen::InnerStride<>> lines) const;

 private:
  /// Where a sum of phases stands; conjugated: its negative does.
  struct Place {
    Eigen::Index column = 0;
    bool conjugated = false;
  };
  /// Of products, made when the first is asked for.
  struct Sums {
    std::once_flag once;
    Eigen::MatrixXd basis;
    std::vector<Place> difference, sum;  ///< [line l * lines + line n]: n - l, n + l
  };
  Eigen::MatrixXd basis_of(const std::vector<LinePhase>& phases) const;
  const Sums& sums() const;

  int dimensions_, highest_;
  Eigen::Index turn_points_;  // in one dimension
  std::vector<LinePhase> phases_;
  Eigen::MatrixXd basis_;  // points x (cosine, -sine of every line)
  std::shared_ptr<Sums> sums_ = std::make_shared<Sums>();
};

}  // namespace secular

#pragma once

#include <Eigen/Core>
#include <cstddef>

#include "motion/response/response_field.hpp"
#include "motion/response/scaled_field.hpp"

namespace secular {

/// Unit tangent t of the curve f = 0 whose Jacobian has one row fewer than columns, turned so that det [J; t'] > 0:
/// it moves smoothly with the Jacobian, around folds as well. Not numbers where J is not finite or has not full
/// rank.
Eigen::VectorXd turned_tangent(const Eigen::Ref<const Eigen::MatrixXd>& jacobian);

/// Second derivative of |B|^2 along a curve, in unknowns of the order of one and over |B|^2 itself, up to which it
/// is flat: the rounding of slopes, some 1e-12, leaves the place of a top undetermined by 1e-6 there.
inline constexpr double flat_bend = 1e-6;

/// |B|^2 of a mode over that of a typical amplitude, as a function of the unknowns of a ScaledField.
class AmplitudeSquare {
 public:
  /// `field`, `scaled` must outlive it; `scaled` is of field.reduced().
  AmplitudeSquare(const ResponseField& field, const ScaledField& scaled, std::size_t mode, double scale)
      : field_(field), scaled_(scaled), mode_(mode), scale_(scale) {}

  double at(const Eigen::Ref<const Eigen::VectorXd>& unknowns) const;
  /// Along a direction of the unknowns, by five-point differences: exact to rounding, |B|^2 being of degree four.
  double slope(const Eigen::Ref<const Eigen::VectorXd>& unknowns,
               const Eigen::Ref<const Eigen::VectorXd>& direction) const;

 private:
  const ResponseField& field_;
  const ScaledField& scaled_;
  std::size_t mode_;
  double scale_;
};

}  // namespace secular

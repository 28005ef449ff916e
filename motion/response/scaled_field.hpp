#pragma once

#include <Eigen/Core>
#include <vector>

#include "motion/response/vector_field.hpp"

namespace secular {

/// A parameter that continuation may change, with its metric: p = centre + scale * unknown.
struct FreeParameter {
  Eigen::Index index = 0;
  double centre = 0, scale = 1;
};

/// A vector field in unknowns of the order of one: y = (x_i / typical_i, (p_k - centre_k) / scale_k), all other
/// parameters held. Rates are divided by typical_i too, so that eigenvalues stay those of the field.
class ScaledField {
 public:
  ScaledField(VectorField field, const Eigen::Ref<const Eigen::VectorXd>& parameters,
              std::vector<FreeParameter> free);

  Eigen::Index dimension() const { return field_.dimension(); }
  Eigen::Index free_count() const { return static_cast<Eigen::Index>(free_.size()); }
  Eigen::Index unknowns() const { return dimension() + free_count(); }

  /// y of (x, all parameters), and back; parameters that are not free are those held.
  Eigen::VectorXd unknowns_at(const Eigen::Ref<const Eigen::VectorXd>& state,
                              const Eigen::Ref<const Eigen::VectorXd>& parameters) const;
  Eigen::VectorXd state(const Eigen::Ref<const Eigen::VectorXd>& unknowns) const;
  Eigen::VectorXd parameters(const Eigen::Ref<const Eigen::VectorXd>& unknowns) const;
  /// A direction of y as a direction of (x, free p), and back.
  Eigen::VectorXd direction(const Eigen::Ref<const Eigen::VectorXd>& scaled) const;
  Eigen::VectorXd scaled_direction(const Eigen::Ref<const Eigen::VectorXd>& direction) const;

  /// dx/dt over typical, and its derivative by x over typical: dimension x dimension.
  Eigen::VectorXd rate(const Eigen::Ref<const Eigen::VectorXd>& unknowns) const;
  Eigen::MatrixXd state_jacobian(const Eigen::Ref<const Eigen::VectorXd>& unknowns) const;
  /// Derivative by unknown dimension() + which.
  Eigen::VectorXd parameter_derivative(const Eigen::Ref<const Eigen::VectorXd>& unknowns, Eigen::Index which) const;
  /// [dimension][unknown]
  Eigen::MatrixXd jacobian(const Eigen::Ref<const Eigen::VectorXd>& unknowns) const;

 private:
  VectorField field_;
  Eigen::VectorXd parameters_;
  std::vector<FreeParameter> free_;
  Eigen::VectorXd scale_;  // of every unknown
};

}  // namespace secular

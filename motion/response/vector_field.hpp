#pragma once

#include <Eigen/Core>
#include <functional>
#include <string>
#include <vector>

namespace secular {

/// An autonomous real vector field dx/dt = f(x, p) with named parameters p. A modulation equation of N modes has
/// the dimension 2N: x = (Re B_1, Im B_1, Re B_2, ...).
class VectorField {
 public:
  /// Writes dx/dt; state and rate: [dimension], parameters: [parameter].
  using RightSide =
      std::function<void(const Eigen::Ref<const Eigen::VectorXd>& state,
                         const Eigen::Ref<const Eigen::VectorXd>& parameters, Eigen::Ref<Eigen::VectorXd> rate)>;
  /// Writes jacobian(i, j) = d rate_i / d state_j.
  using Jacobian = std::function<void(const Eigen::Ref<const Eigen::VectorXd>& state,
                                      const Eigen::Ref<const Eigen::VectorXd>& parameters,
                                      Eigen::Ref<Eigen::MatrixXd> jacobian)>;

  /// Without `jacobian`, five-point differences stand in. Throws std::invalid_argument for a dimension below 1, a
  /// missing right side, or parameter names that are empty or not distinct.
  VectorField(Eigen::Index dimension, std::vector<std::string> parameter_names, RightSide right_side,
              Jacobian jacobian = {});

  /// Typical magnitudes of the states and the parameters (all 1 unless set): the metric of step lengths and the
  /// steps of differences. Amplitudes of a millimetre in metres need 1e-3 here. Throws std::invalid_argument
  /// unless all are positive and finite, one for each.
  void set_typical(const Eigen::Ref<const Eigen::VectorXd>& state,
                   const Eigen::Ref<const Eigen::VectorXd>& parameters);

  Eigen::Index dimension() const { return dimension_; }
  Eigen::Index parameter_count() const { return static_cast<Eigen::Index>(names_.size()); }
  const std::vector<std::string>& parameter_names() const { return names_; }
  const Eigen::VectorXd& typical_state() const { return typical_state_; }
  const Eigen::VectorXd& typical_parameters() const { return typical_parameters_; }

  /// Throw std::invalid_argument for vectors of the wrong size.
  Eigen::VectorXd rate(const Eigen::Ref<const Eigen::VectorXd>& state,
                       const Eigen::Ref<const Eigen::VectorXd>& parameters) const;
  Eigen::MatrixXd jacobian(const Eigen::Ref<const Eigen::VectorXd>& state,
                           const Eigen::Ref<const Eigen::VectorXd>& parameters) const;
  /// d rate / d parameter, [dimension], by differences.
  Eigen::VectorXd parameter_derivative(const Eigen::Ref<const Eigen::VectorXd>& state,
                                       const Eigen::Ref<const Eigen::VectorXd>& parameters,
                                       Eigen::Index parameter) const;
  /// Throws std::invalid_argument unless the sizes fit and all entries are finite.
  void check(const Eigen::Ref<const Eigen::VectorXd>& state,
             const Eigen::Ref<const Eigen::VectorXd>& parameters) const;

 private:
  Eigen::Index dimension_;
  std::vector<std::string> names_;
  RightSide right_side_;
  Jacobian jacobian_;
  Eigen::VectorXd typical_state_, typical_parameters_;
};

}  // namespace secular

#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "motion/response/limit_cycles.hpp"
#include "motion/response/response_curve.hpp"
#include "motion/response/response_field.hpp"

namespace secular {

/// Parameters with error bars: `directions` are parameters x independent directions, each one standard deviation
/// long (directions * directions' is their covariance).
struct UncertainParameters {
  Eigen::VectorXd values;
  Eigen::MatrixXd directions;
};

/// How far steady responses move with uncertain parameters, to first order: (R6), (R7), (R9) of docs/inference.md.
/// The field must outlive it.
class ResponseSpread {
 public:
  /// `range`, `scale`: of the varied parameter and of amplitudes, the units in which "across" is a right angle.
  ResponseSpread(const ResponseField& field, UncertainParameters parameters, Eigen::Index varied, double range,
                 double scale);

  /// [mode of the model]; empty where nothing follows: at rest, and where branches cross. A mode at rest has zeros.
  std::vector<CurveSpread> of(const ResponsePoint& point) const;
  /// Of the parameter's value at a saddle-node, a Hopf point or a threshold of the state of rest. Nothing where it
  /// does not follow to first order: other points where branches cross.
  std::optional<double> of(const ResponseSpecial& special) const;
  /// Of the parameter's value where the amplitude of a mode is largest, which is at `point`; that of the amplitude
  /// is of(point)[mode].amplitude. Nothing where branches cross, and where the amplitude is level to second order.
  std::optional<double> of_peak(const ResponsePoint& point, std::size_t mode) const;

 private:
  // How the curve goes on at a point and how it moves, in unknowns of the order of one.
  struct Moved {
    Eigen::MatrixXd jacobian;   // equations x (n + 1)
    Eigen::VectorXd tangent;    // n + 1, of unit length
    Eigen::MatrixXd direction;  // (n + 1) x directions, at right angles to the tangent
  };

  Eigen::VectorXd parameters_at(double value) const;
  std::optional<Moved> moved(const ResponsePoint& point) const;
  std::optional<double> of_saddle_node(const ResponsePoint& point) const;
  std::optional<double> of_eigenvalue(const VectorField& field, const Eigen::VectorXd& state, double value) const;

  const ResponseField& field_;
  UncertainParameters uncertain_;
  Eigen::Index varied_;
  double range_, scale_;
  VectorField reduced_;
};

/// One standard deviation of a backbone at one amplitude.
struct BackboneSpread {
  double frequency = 0;  ///< rad/s
  double growth = 0;     ///< 1/s
};

/// At the amplitudes of backbone(), to first order in every direction. Not finite where the equations are not.
std::vector<BackboneSpread> backbone_spread(const ResponseField& field, const UncertainParameters& parameters,
                                            std::size_t mode, double largest, int points);

/// One standard deviation of a limit cycle of an active mode: of its amplitude |B| and of its frequency, rad/s.
/// (R8); nothing where the growth has no slope there.
struct LimitCycleSpread {
  double amplitude = 0, frequency = 0;
};
std::optional<LimitCycleSpread> limit_cycle_spread(const ResponseField& field,
                                                   const UncertainParameters& parameters, std::size_t mode,
                                                   const LimitCycle& cycle);

}  // namespace secular

#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

#include "effects/force_law.hpp"

namespace secular {

/// A force that no term of an equation of motion can say, supplied as the signal of one of the model's excitations:
/// `law` of the motion of coordinate `mode`, which the model multiplies by a strength.
struct StateForce {
  static constexpr std::size_t none = static_cast<std::size_t>(-1);
  ForceLaw law = force_law::slider;  ///< not of the time
  std::size_t excitation = 0, mode = 0;
  std::size_t strength_symbol = 0;  ///< the signal is not computed where it is zero
  std::size_t shape_symbol = none;  ///< slip displacement, exponent, ...; none: the law has no shape
  double scale = 1;                 ///< displacement or velocity: usual in the data, so that a strength has a size

  double shape(std::span<const double> parameters) const {
    return shape_symbol == none ? 0 : parameters[shape_symbol];
  }
  /// Of sliders: the strength is the force at which all of them slide, over `scale`. It is dry friction's as well,
  /// which has no slip at all, and goes with the slip in a straight line where the spring alone is known. The
  /// spring's stiffness is so many times the strength, divided by the slip; of slips that are spread the mean is
  /// half (docs/inference.md (35)).
  double stiffness_scale() const { return law.kind == ForceLaw::Kind::spread_slider ? 2 * scale : scale; }
  /// Of sliders with this slip: the signal is their mean stretch times this factor.
  double per_stretch(double slip) const { return slip == 0 ? 0 : stiffness_scale() / std::abs(slip); }
};

/// Sliders that stand for an even spread of slips.
inline constexpr std::size_t spread_sliders = 8;

/// A spring in series with a slider, by the spring's stretch z, |z| <= slip.
struct Slider {
  double slip = 0;
  bool smooth =
      false;  ///< gives way with (z/slip)^2 while it is loaded (Bouc and Wen) instead of at once (Jenkins)

  /// Stretch after the displacement has grown by `way` without turning.
  double advanced(double stretch, double way) const {
    return smooth ? smoothly_advanced(stretch, way) : std::clamp(stretch + way, -slip, slip);
  }

 private:
  double smoothly_advanced(double stretch, double way) const;
};

/// The sliders of a force: one, spread_sliders, or none where the law has no memory. Of a slip the size counts
/// alone.
std::vector<Slider> sliders_of(const StateForce& force, double shape);

/// Stretch of the spring of a slider along a closed path, after so many turns that it is closed, too.
Eigen::RowVectorXd slider_stretch(const Eigen::RowVectorXd& path, const Slider& slider);

/// Of a signal that is a harmonic over whole turns: twice its variance.
double squared_amplitude(const Eigen::RowVectorXd& signal);

/// The signal over a closed turn of the motion, by a slider or a law without memory: modes x points each.
Eigen::RowVectorXd signal_over_turn(const StateForce& force, const Eigen::MatrixXd& displacement,
                                    const Eigen::MatrixXd& velocity, double shape);

}  // namespace secular

#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

namespace secular {

/// A force that no term of an equation of motion can say, supplied as the signal of one of the model's excitations:
/// a function of the motion x of coordinate `mode`, which the model multiplies by a strength.
struct StateForce {
  enum class Law {
    slider,         ///< stretch z of a spring in series with a slider: dz/dt = dx/dt while |z| < shape
    spread_slider,  ///< mean stretch of spread_sliders such, slips evenly spread between 0 and shape (micro-slip)
    smooth_slider,  ///< the stretch of Bouc and Wen: dz/dt = dx/dt - |dx/dt| z |z|/shape^2
    displacement_power,  ///< scale*sgn(x)*|x/scale|^shape
    velocity_power,      ///< scale*sgn(dx/dt)*|(dx/dt)/scale|^shape
    loss_power,          ///< |x/scale|^shape*dx/dt
    speed_power          ///< scale*|(dx/dt)/scale|^shape: damping of one direction only, beside a viscous one
  };
  Law law = Law::slider;
  std::size_t excitation = 0, mode = 0;
  std::size_t strength_symbol = 0;  ///< the signal is not computed where it is zero
  std::size_t shape_symbol = 0;     ///< slip displacement, or exponent
  double scale = 1;                 ///< displacement or velocity: usual in the data, so that a strength has a size
};

/// Whether the scale of a law with an exponent is a velocity.
constexpr bool is_of_velocity(StateForce::Law law) {
  return law == StateForce::Law::velocity_power || law == StateForce::Law::speed_power;
}

/// Whether the force depends on the path and not on displacement and velocity alone.
constexpr bool has_memory(StateForce::Law law) {
  return law == StateForce::Law::slider || law == StateForce::Law::spread_slider ||
         law == StateForce::Law::smooth_slider;
}

/// Signal of a law with an exponent, which is kept between 0 and 15.
double power_law(const StateForce& force, double displacement, double velocity, double exponent);

/// Sliders that stand for an even spread of slips.
inline constexpr std::size_t spread_sliders = 8;

/// A spring in series with a slider, by the spring's stretch z, |z| <= slip.
struct Slider {
  double slip = 0;
  bool smooth =
      false;  ///< gives way with (z/slip)^2 while it is loaded (Bouc and Wen) instead of at once (Jenkins)

  /// Stretch after the displacement has grown by `way` without turning.
  double advanced(double stretch, double way) const;
};

/// The sliders of a force: one, spread_sliders, or none where the law has no memory.
std::vector<Slider> sliders_of(const StateForce& force, double shape);

/// Stretch of the spring of a slider along a closed path, after so many turns that it is closed, too.
Eigen::RowVectorXd slider_stretch(const Eigen::RowVectorXd& path, const Slider& slider);

/// The signal over a closed turn of the motion: modes x points each.
Eigen::RowVectorXd signal_over_turn(const StateForce& force, const Eigen::MatrixXd& displacement,
                                    const Eigen::MatrixXd& velocity, double shape);

}  // namespace secular

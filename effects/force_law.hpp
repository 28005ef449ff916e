#pragma once

namespace secular {

/// What supplies the signal of a force that the text of a model cannot say.
struct ForceLaw {
  enum class Kind {
    none,           ///< no signal: the term is all text
    time,           ///< the time in s since the strength's reference instant
    slider,         ///< stretch z of a spring in series with a slider: dz/dt = D(v) while |z| < shape (Jenkins)
    spread_slider,  ///< mean stretch of many such, their slips evenly spread between 0 and shape (Iwan 1966)
    smooth_slider,  ///< dz/dt = D(v) - abs(D(v))*z*abs(z)/shape^2 (Bouc 1967, Wen 1976, with exponent 2)
    relaxation,     ///< stretch z of a spring in series with a damper: dz/dt = D(v) - z/shape (Maxwell)
    level,          ///< the square of the excitation's amplitude
    state,          ///< `value`, without memory
  };
  /// A function of one mode's displacement and velocity. `shape` is the parameter beside the strength (0: the term
  /// has none). `scale` is a usual displacement (or velocity, see of_velocity): a law with an exponent is of
  /// displacement/scale, so that its strength has a size whatever the exponent.
  using Value = double (*)(double displacement, double velocity, double shape, double scale);

  Kind kind = Kind::none;
  Value value = nullptr;
  bool of_velocity = false;
  bool is_power = false;  ///< scale times the power `shape` of displacement/scale or velocity/scale

  constexpr bool is_slider() const {
    return kind == Kind::slider || kind == Kind::spread_slider || kind == Kind::smooth_slider;
  }
  /// Whether the force depends on the path and not on displacement and velocity alone.
  constexpr bool has_memory() const { return is_slider() || kind == Kind::relaxation; }
};

namespace force_law {

inline constexpr ForceLaw time{ForceLaw::Kind::time}, slider{ForceLaw::Kind::slider},
    spread_slider{ForceLaw::Kind::spread_slider}, smooth_slider{ForceLaw::Kind::smooth_slider},
    relaxation{ForceLaw::Kind::relaxation}, level{ForceLaw::Kind::level};

/// Exponents are kept between 0 (below, a force would be infinite at rest) and 15 (beyond is as good as a wall).
extern const ForceLaw displacement_power,  ///< scale*sgn(v)*|v/scale|^shape
    velocity_power,                        ///< scale*sgn(D(v))*|D(v)/scale|^shape
    loss_power,                            ///< |v/scale|^shape*D(v)
    speed_power,                           ///< scale*|D(v)/scale|^shape
    saturation,                            ///< shape*tanh(v/shape) - v
    decay_with_speed;                      ///< exp(-|D(v)|/shape)

}  // namespace force_law
}  // namespace secular

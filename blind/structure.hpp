#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <memory>
#include <numbers>
#include <string>
#include <vector>

namespace secular::blind {

inline constexpr std::size_t most_modes = 2;
inline constexpr double two_pi = 2 * std::numbers::pi;

/// What acts at one modal coordinate q (mass-normalised: unit mass, SI). Left-hand side
///   (1 + 2 delta2 q + delta3 q^2) q'' + delta2 q'^2 + delta3 q q'^2 + omega^2 q,
/// right-hand side the other terms, each with the sign that its comment shows.
struct ModeTerms {
  double omega = 1;           ///< natural frequency, rad/s
  double drift = 0;           ///< omega (1 + drift t), t since the campaign began, 1/s
  double mu1 = 0;             ///< -2 mu1 q'
  double mu2 = 0;             ///< -mu2 |q'| q'
  double mu3 = 0;             ///< -mu3 q'^3
  double mu4 = 0;             ///< -mu4 q^2 q'
  double friction = 0;        ///< -friction sgn(q'), with rest
  double falling_share = 0;   ///< that friction is larger by this share at rest: ...
  double falling_speed = 1;   ///< ... (1 + falling_share exp(-|q'|/falling_speed)), > 0
  double power = 0;           ///< -power |q'|^exponent sgn(q')
  double exponent = 1;        ///< > 1
  double alpha2 = 0;          ///< -alpha2 q^2
  double alpha3 = 0;          ///< -alpha3 q^3
  double alpha5 = 0;          ///< -alpha5 q^5
  double bilinear = 0;        ///< -bilinear max(q, 0)
  double freeplay = 0;        ///< +freeplay clamp(q, -gap, gap): this stiffness is lost within the gap
  double gap = 0;             ///< of the dead band or in front of a stop, > 0 with either
  double one_sided_stop = 0;  ///< -one_sided_stop max(q - gap, 0)
  double two_sided_stop = 0;  ///< -two_sided_stop (q - clamp(q, -gap, gap))
  double saturating = 0;      ///< -saturating (level tanh(q/level) - q)
  double level = 1;           ///< > 0
  double delta2 = 0;          ///< quadratic inertia, see above
  double delta3 = 0;          ///< cubic inertia, see above
  double slider =
      0;            ///< -slider s, s the elastic displacement of a spring behind a slider that slips at |s| = slip
  double slip = 0;  ///< > 0 with a slider
  bool smooth_slider = false;  ///< Bouc-Wen, s' = q' - |q'| s |s| / slip^2, instead of Jenkins
  double direct = 0;           ///< +direct f(t)
  double parametric = 0;       ///< +parametric q f(t)
  double level_stiffness = 0;  ///< -level_stiffness F^2 q: the excitation's level loosens a joint
  // Outside of the catalogue
  double alpha7 = 0;             ///< -alpha7 q^7
  double one_sided = 0;          ///< -one_sided max(q', 0)
  double threshold_damping = 0;  ///< -threshold_damping q' where |q| > threshold
  double threshold = 0;
  double quartic_damping = 0;  ///< -quartic_damping q^4 q'
  double modulated_force = 0;  ///< +modulated_force F sin(2 pi t/9) cos(Omega t): a force that no channel records
  // With the other mode u of two
  double damping_coupling = 0;     ///< -damping_coupling u'
  double quadratic_coupling = 0;   ///< potential quadratic_coupling q^2 u
  double cubic_coupling = 0;       ///< potential cubic_coupling q^2 u^2 / 2 (of either mode)
  double third_coupling = 0;       ///< potential third_coupling q^3 u
  double parametric_coupling = 0;  ///< +parametric_coupling u f(t)

  /// Friction's size at speed |q'|.
  double friction_at(double speed) const {
    return falling_share == 0 ? friction : friction * (1 + falling_share * std::exp(-speed / falling_speed));
  }
  bool has_gap() const { return freeplay != 0 || one_sided_stop != 0 || two_sided_stop != 0; }
};

/// A linear mode that no model knows: z'' + 2 mu z' + omega^2 z = direct f(t), seen by every response channel.
struct ExtraMode {
  double omega = 1, mu = 0, direct = 0;
};

struct Structure {
  std::size_t modes = 1;
  std::array<ModeTerms, most_modes> mode;
  ExtraMode extra;
};

/// An excitation in m/s^2 at even times from zero on; zero before and behind.
struct Course {
  double step = 1;  ///< s
  std::vector<double> values;
  /// By the cubic through the four values around.
  double at(double t) const;
};

/// Excitation f(t) = F (cos Omega t + second cos 2 Omega t + third cos 3 Omega t), or any other course, in a record
/// that began `started` seconds after the campaign.
struct Drive {
  double amplitude = 0, frequency = 0;  ///< F in m/s^2 (of a course its level), Omega in rad/s
  double second = 0, third = 0;
  double started = 0;
  std::shared_ptr<const Course> course = {};  ///< none: harmonic
  double at(double t) const;
};

/// q, q', s of each mode, then z, z'.
using State = std::array<double, 3 * most_modes + 2>;
inline double& displacement(State& x, std::size_t k) {
  return x[3 * k];
}
inline double& velocity(State& x, std::size_t k) {
  return x[3 * k + 1];
}
inline double& slider_spring(State& x, std::size_t k) {
  return x[3 * k + 2];
}
inline double displacement(const State& x, std::size_t k) {
  return x[3 * k];
}
inline double velocity(const State& x, std::size_t k) {
  return x[3 * k + 1];
}
inline double slider_spring(const State& x, std::size_t k) {
  return x[3 * k + 2];
}
inline constexpr std::size_t extra_at = 3 * most_modes;

/// On which branch of its nonsmooth terms each mode is.
struct Regime {
  std::array<int, most_modes> sliding{};   ///< friction: sign of q', 0 at rest
  std::array<int, most_modes> slipping{};  ///< Jenkins: sign of q', 0 while the slider holds
  std::array<int, most_modes> side{};      ///< sign of q, for a contact
  std::array<int, most_modes> band{};      ///< -1, 0, 1: below, within, above the dead band
  std::array<int, most_modes> beyond{};    ///< the same for threshold damping
};

/// A state at time t, the drive's value then, and the branches that it is on.
struct Instant {
  const Regime& regime;
  double t, excitation;
  const State& x;
};

/// All forces on mode k but inertia and friction; divided by the mode's effective mass they give q''.
double force(const Structure& structure, const Drive& drive, const Instant& at, std::size_t k);
/// Time derivative of the state.
void derivative(const Structure& structure, const Drive& drive, const Instant& at, State& rate);
/// Modal accelerations q'' (first) and z''.
struct Accelerations {
  std::array<double, most_modes> modal{};
  double extra = 0;
};
Accelerations accelerations(const Structure& structure, const Drive& drive, const Instant& at);

/// The coefficient that switches an effect of docs/simulating.md, or one of those outside of it, on; nullptr for
/// faults of the excitation or the measurement.
double* coefficient(Structure& structure, const std::string& effect, std::size_t mode);

}  // namespace secular::blind

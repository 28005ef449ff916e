#include "blind/structure.hpp"

#include <algorithm>
#include <cmath>

namespace secular::blind {

double Course::at(double t) const {
  const double place = t / step, whole = std::floor(place), u = place - whole;
  const auto first = static_cast<std::ptrdiff_t>(whole);
  const auto value = [&](std::ptrdiff_t i) {
    return i < 0 || i >= static_cast<std::ptrdiff_t>(values.size()) ? 0 : values[static_cast<std::size_t>(i)];
  };
  return u * (u - 1) * (u + 1) / 6 * value(first + 2) - u * (u + 1) * (u - 2) / 2 * value(first + 1) +
         (u - 1) * (u + 1) * (u - 2) / 2 * value(first) - u * (u - 1) * (u - 2) / 6 * value(first - 1);
}

double Drive::at(double t) const {
  if (course) return course->at(t);
  double sum = std::cos(frequency * t);
  if (second != 0) sum += second * std::cos(2 * frequency * t);
  if (third != 0) sum += third * std::cos(3 * frequency * t);
  return amplitude * sum;
}

double force(const Structure& structure, const Drive& drive, const Instant& at, std::size_t k) {
  const ModeTerms& m = structure.mode[k];
  const auto& [regime, t, excitation, x] = at;
  const double q = displacement(x, k), p = velocity(x, k), q2 = q * q, p2 = p * p;
  const double omega = m.drift == 0 ? m.omega : m.omega * (1 + m.drift * (drive.started + t));
  double f = -omega * omega * q -
             p * (2 * m.mu1 + m.mu2 * std::abs(p) + m.mu3 * p2 + q2 * (m.mu4 + m.quartic_damping * q2));
  f -= q2 * (m.alpha2 + m.alpha3 * q + q2 * q * (m.alpha5 + m.alpha7 * q2));
  f += (m.direct + m.parametric * q) * excitation;
  if (m.bilinear != 0 && regime.side[k] > 0) f -= m.bilinear * q;
  if (m.freeplay != 0) f += m.freeplay * (regime.band[k] == 0 ? q : regime.band[k] * m.gap);
  if (m.one_sided_stop != 0 && regime.band[k] > 0) f -= m.one_sided_stop * (q - m.gap);
  if (m.two_sided_stop != 0 && regime.band[k] != 0) f -= m.two_sided_stop * (q - regime.band[k] * m.gap);
  if (m.saturating != 0) f += m.saturating * (q - m.level * std::tanh(q / m.level));
  if (m.slider != 0) f -= m.slider * slider_spring(x, k);
  if (m.power != 0) f -= std::copysign(m.power * std::pow(std::abs(p), m.exponent), p);
  if (m.one_sided != 0) f -= m.one_sided * std::max(p, 0.0);
  if (m.threshold_damping != 0 && regime.beyond[k] != 0) f -= m.threshold_damping * p;
  if (m.level_stiffness != 0) f -= m.level_stiffness * drive.amplitude * drive.amplitude * q;
  if (m.modulated_force != 0)
    f += m.modulated_force * drive.amplitude * std::sin(two_pi * t / 9) * std::cos(drive.frequency * t);
  if (structure.modes == 2) {
    const ModeTerms& o = structure.mode[1 - k];
    const double u = displacement(x, 1 - k), both = m.cubic_coupling + o.cubic_coupling;
    f -= m.damping_coupling * velocity(x, 1 - k);
    f -= 2 * m.quadratic_coupling * q * u + o.quadratic_coupling * u * u;
    f -= both * q * u * u;
    f -= 3 * m.third_coupling * q2 * u + o.third_coupling * u * u * u;
    f += m.parametric_coupling * u * excitation;
  }
  return f;
}

namespace {

double acceleration(const Structure& structure, const Drive& drive, const Instant& at, std::size_t k) {
  const ModeTerms& m = structure.mode[k];
  if (m.friction != 0 && at.regime.sliding[k] == 0) return 0;
  const double q = displacement(at.x, k), p = velocity(at.x, k);
  double f = force(structure, drive, at, k);
  if (m.friction != 0) f -= m.friction_at(std::abs(p)) * at.regime.sliding[k];
  if (m.delta2 == 0 && m.delta3 == 0) return f;
  f -= (m.delta2 + m.delta3 * q) * p * p;
  return f / (1 + (2 * m.delta2 + m.delta3 * q) * q);
}

double extra_acceleration(const ExtraMode& e, double excitation, const State& x) {
  return e.direct * excitation - 2 * e.mu * x[extra_at + 1] - e.omega * e.omega * x[extra_at];
}

}  // namespace

void derivative(const Structure& structure, const Drive& drive, const Instant& at, State& rate) {
  const State& x = at.x;
  const Regime& regime = at.regime;
  for (std::size_t k = 0; k < structure.modes; ++k) {
    const ModeTerms& m = structure.mode[k];
    const bool at_rest = m.friction != 0 && regime.sliding[k] == 0;
    const double p = at_rest ? 0 : velocity(x, k);
    displacement(rate, k) = p;
    velocity(rate, k) = acceleration(structure, drive, at, k);
    if (m.slider == 0) {
      slider_spring(rate, k) = 0;
    } else if (m.smooth_slider) {
      const double s = slider_spring(x, k);
      slider_spring(rate, k) = p - std::abs(p) * s * std::abs(s) / (m.slip * m.slip);
    } else {
      slider_spring(rate, k) = regime.slipping[k] == 0 ? p : 0;
    }
  }
  if (structure.extra.direct != 0) {
    rate[extra_at] = x[extra_at + 1];
    rate[extra_at + 1] = extra_acceleration(structure.extra, at.excitation, x);
  }
}

Accelerations accelerations(const Structure& structure, const Drive& drive, const Instant& at) {
  Accelerations result;
  for (std::size_t k = 0; k < structure.modes; ++k) result.modal[k] = acceleration(structure, drive, at, k);
  if (structure.extra.direct != 0) result.extra = extra_acceleration(structure.extra, at.excitation, at.x);
  return result;
}

double* coefficient(Structure& structure, const std::string& effect, std::size_t mode) {
  ModeTerms& m = structure.mode.at(mode);
  struct Entry {
    const char* effect;
    double* value;
  };
  const Entry entries[] = {{"viscous_damping", &m.mu1},
                           {"quadratic_damping", &m.mu2},
                           {"cubic_damping", &m.mu3},
                           {"amplitude_dependent_damping", &m.mu4},
                           {"coulomb_friction", &m.friction},
                           {"stribeck_friction", &m.friction},
                           {"power_damping", &m.power},
                           {"quadratic_stiffness", &m.alpha2},
                           {"cubic_stiffness", &m.alpha3},
                           {"quintic_stiffness", &m.alpha5},
                           {"bilinear_stiffness", &m.bilinear},
                           {"freeplay", &m.freeplay},
                           {"one_sided_stop", &m.one_sided_stop},
                           {"two_sided_stop", &m.two_sided_stop},
                           {"saturating_stiffness", &m.saturating},
                           {"quadratic_inertia", &m.delta2},
                           {"cubic_inertia", &m.delta3},
                           {"hysteresis", &m.slider},
                           {"direct_excitation", &m.direct},
                           {"parametric_excitation", &m.parametric},
                           {"natural_frequency_drift", &m.drift},
                           {"damping_coupling", &m.damping_coupling},
                           {"quadratic_coupling", &m.quadratic_coupling},
                           {"cubic_coupling", &m.cubic_coupling},
                           {"parametric_coupling", &m.parametric_coupling},
                           {"extra_mode", &structure.extra.direct},
                           {"natural_frequency", &m.omega},
                           {"septic_stiffness", &m.alpha7},
                           {"one_sided_damping", &m.one_sided},
                           {"threshold_damping", &m.threshold_damping},
                           {"quartic_damping", &m.quartic_damping},
                           {"level_stiffness", &m.level_stiffness},
                           {"modulated_force", &m.modulated_force}};
  for (const Entry& entry : entries)
    if (effect == entry.effect) return entry.value;
  return nullptr;
}

}  // namespace secular::blind

#include "blind/specimen.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace secular::blind {
namespace {

constexpr std::size_t decay_samples = 3072;  // beside dwells

// Draws a coefficient of an own term: share of the damping force at the typical amplitude.
void add_own(Specimen& s, const std::string& effect, std::size_t mode, const std::string& symbol, double share) {
  *coefficient(s.structure, effect, mode) = coefficient_of_share(s, effect, mode, share);
  s.own.push_back({effect, mode, symbol});
}

// Damping of a mode: linear, and sometimes drag or cubic damping beside it. A withheld kind is never there.
void draw_damping(Specimen& s, std::size_t k, const std::string& suffix, const std::set<std::string>& withheld,
                  Random& random) {
  const bool linear = !withheld.contains("viscous_damping");
  const bool cubic = !withheld.contains("cubic_damping") && !withheld.contains("amplitude_dependent_damping");
  const bool drag = !withheld.contains("quadratic_damping");
  const double other = random.uniform(0.15, 0.6);
  const bool with_drag = random.chance(0.4), with_cubic = random.chance(0.3);
  // Shares are of 2 mu omega a: mu1 has share 1; mean damping of |q'|q' is 8/(3 pi), of q'^3 3/4 of the peak's.
  if (linear) add_own(s, "viscous_damping", k, "mu1" + suffix, 1);
  if (drag && (!linear || with_drag))
    add_own(s, "quadratic_damping", k, "mu2" + suffix, (linear ? other : 1) * 3 * std::numbers::pi / 8);
  else if (cubic && (!linear || with_cubic))
    add_own(s, "cubic_damping", k, "mu3" + suffix, (linear ? other : 1) * 4 / 3);
}

// Cubic stiffness that moves the resonance by `shift` half-bandwidths at the typical amplitude:
// 3 alpha3 a^2/(8 omega) = shift mu.
void draw_cubic(Specimen& s, std::size_t k, const std::string& symbol, double shift) {
  add_own(s, "cubic_stiffness", k, symbol, shift * 4.0 / 3);
}

std::vector<double> spread(double low, double high, std::size_t count) {
  std::vector<double> values;
  for (std::size_t i = 0; i < count; ++i)
    values.push_back(low + (high - low) * static_cast<double>(i) /
                               static_cast<double>(std::max<std::size_t>(1, count - 1)));
  return values;
}

void add_dwell(Specimen& s, double omega, double amplitude, const std::string& group, const State& start) {
  Dwell dwell;
  dwell.drive.amplitude = amplitude;
  dwell.drive.frequency = two_pi * std::round(1e4 * omega / two_pi) / 1e4;  // as a generator is set, to 0.1 mHz
  dwell.state = start;
  dwell.group = group;
  s.dwells.push_back(dwell);
}

// Sweeps through the resonance of mode k at several levels.
void add_primary_dwells(Specimen& s, std::size_t k, std::size_t count, Random& random) {
  const std::size_t levels = count >= 20 ? 5 : 3, frequencies = std::max<std::size_t>(4, count / levels);
  const ModeTerms& m = s.structure.mode[k];
  const double mu = s.decay_rate[k];
  const double a = s.typical_amplitude[k];
  const double backbone =
      3 * m.alpha3 * a * a / (8 * m.omega) - 5 * m.alpha2 * m.alpha2 * a * a / (12 * m.omega * m.omega * m.omega);
  const double centre = random.uniform(-0.4, 0.4) * mu;
  const std::vector<double> level = spread(random.uniform(0.3, 0.45), random.uniform(1.1, 1.4), levels);
  const double drive = 2 * mu * m.omega * a / std::abs(m.direct);
  for (std::size_t i = 0; i < level.size(); ++i) {
    const double l = level[i];
    const double shift = backbone * l * l * 0.6;
    for (const double detuning : spread(-2.6, 2.6, frequencies))
      add_dwell(s, m.omega + centre + shift + detuning * mu, l * drive,
                "mode " + std::to_string(k + 1) + ", level " + std::to_string(i + 1), {});
  }
  s.typical_drive = drive;
}

void add_parametric_dwells(Specimen& s, std::size_t count, Random& random) {
  const ModeTerms& m = s.structure.mode[0];
  const double mu = s.decay_rate[0];
  // eta2 F/(4 omega) = ratio mu: the trivial solution is unstable within |Omega/2 - omega| < mu sqrt(ratio^2 - 1).
  const double unit_drive = 4 * m.omega * mu / std::abs(m.parametric);
  const std::size_t levels = count >= 40 ? 5 : 4, frequencies = count / levels;
  const double bends = m.alpha3 < 0 ? -1 : 1;
  State start{};
  displacement(start, 0) = s.typical_amplitude[0];
  const std::vector<double> ratios = spread(random.uniform(1.35, 1.5), random.uniform(2.2, 2.6), levels);
  for (std::size_t i = 0; i < ratios.size(); ++i)
    for (const double detuning : spread(-0.6, m.alpha3 == 0 ? 0.6 : 1.3, frequencies))
      add_dwell(s, 2 * (m.omega + bends * detuning * mu), ratios[i] * unit_drive, "level " + std::to_string(i + 1),
                start);
  s.typical_drive = ratios[levels / 2] * unit_drive;
}

// Settles every dwell of the structure as the model knows it, and leaves out those that end at rest.
void settle(Specimen& s) {
  std::vector<Dwell> kept;
  for (Dwell& dwell : s.dwells) {
    dwell.state = settled_state(s.structure, dwell.drive, dwell.state, s.settling);
    double size = 0;
    for (std::size_t k = 0; k < s.structure.modes; ++k)
      size = std::max(size, distance(s.structure, dwell.state, State{}, k) / s.typical_amplitude[k]);
    if (size > 0.02) kept.push_back(dwell);
  }
  s.dwells = std::move(kept);
}

// Dwells of all modes; three free decays of a structure that has one.
void draw_dwells(Specimen& s, std::size_t count, Random& random) {
  const std::size_t modes = s.structure.modes;
  if (s.family == "principal_parametric") {
    s.settling.periods_of_two = 2;
    add_parametric_dwells(s, count, random);
  } else {
    for (std::size_t k = 0; k < modes; ++k) add_primary_dwells(s, k, count / modes, random);
  }
  settle(s);
  if (random.chance(0.5)) random.shuffle(s.dwells);
  double started = 0;
  for (Dwell& dwell : s.dwells) {
    dwell.drive.started = started;
    started += 90;
  }
  if (modes == 1)
    for (const double part : {1.4, 1.0, 0.6})
      s.stretches.push_back(decay_from(part * s.typical_amplitude[0], decay_samples));
}

void draw_sensors(Specimen& s, Random& random) {
  Measurement& m = s.measurement;
  const std::size_t modes = s.structure.modes;
  m.with_modal_basis = modes == 2 || random.chance(0.4);
  m.of_displacement = !m.with_modal_basis && random.chance(0.25);
  m.names = {"base"};
  if (modes == 2) {
    m.shapes = {{1.0 + random.uniform(-0.2, 0.2), -0.7 + random.uniform(-0.15, 0.15)},
                {0.7 + random.uniform(-0.15, 0.15), 1.1 + random.uniform(-0.2, 0.2)},
                {-0.4 + random.uniform(-0.2, 0.2), 0.5 + random.uniform(-0.2, 0.2)}};
    m.names.insert(m.names.end(), {"upper", "lower", "side"});
  } else if (m.with_modal_basis) {
    m.shapes = {{random.uniform(0.9, 1.3)}, {random.uniform(0.4, 0.9)}};
    m.names.insert(m.names.end(), {"upper", "lower"});
  } else {
    m.shapes = {{1.0}};
    m.names.emplace_back("v");
  }
  for (std::vector<double>& row : m.shapes)  // as the file prints them
    for (double& x : row)
      if (m.with_modal_basis) x = std::round(x * 1e4) / 1e4;
  m.fault.assign(m.names.size(), {});
}

}  // namespace

double coefficient_of_share(const Specimen& s, const std::string& effect, std::size_t k, double share) {
  const ModeTerms& m = s.structure.mode[k];
  const double a = s.typical_amplitude[k], w = m.omega, mu = s.decay_rate[k], f = s.typical_drive;
  const double u = s.structure.modes == 2 ? s.typical_amplitude[1 - k] : 0;
  const double w_other = s.structure.modes == 2 ? s.structure.mode[1 - k].omega : 0;
  const double unit = share * 2 * mu * w * a;  // N/kg^(1/2)
  if (effect == "viscous_damping") return share * mu;
  if (effect == "quadratic_damping") return unit / (w * w * a * a);
  if (effect == "cubic_damping") return unit / std::pow(w * a, 3);
  if (effect == "amplitude_dependent_damping") return unit / (a * a * a * w);
  if (effect == "coulomb_friction" || effect == "stribeck_friction") return unit;
  // Of the mean of the exponents that are drawn; the strength is scaled to what is asked for anyway.
  if (effect == "power_damping") return unit / std::pow(w * a, 2.4);
  if (effect == "quadratic_stiffness") return unit / (a * a);
  if (effect == "cubic_stiffness") return unit / (a * a * a);
  if (effect == "quintic_stiffness") return unit / std::pow(a, 5);
  if (effect == "septic_stiffness") return unit / std::pow(a, 7);
  if (effect == "bilinear_stiffness" || effect == "freeplay" || effect == "hysteresis" ||
      effect.ends_with("_stop") || effect == "saturating_stiffness")
    return unit / a;
  if (effect == "quadratic_inertia") return unit / (w * w * a * a);
  if (effect == "cubic_inertia") return unit / (w * w * a * a * a);
  if (effect == "direct_excitation") return unit / f;
  if (effect == "parametric_excitation") return unit / (a * f);
  if (effect == "natural_frequency_drift") return share * mu / w / 3600;
  if (effect == "damping_coupling") return unit / (w_other * u);
  if (effect == "quadratic_coupling") return unit / (a * u);
  if (effect == "cubic_coupling") return unit / (a * u * u);
  if (effect == "parametric_coupling") return unit / (u * f);
  if (effect == "extra_mode") return share * w * w * a / f;
  if (effect == "one_sided_damping" || effect == "threshold_damping") return unit / (w * a);
  if (effect == "quartic_damping") return unit / (std::pow(a, 5) * w);
  if (effect == "level_stiffness") return unit / (a * f * f);
  return unit / f;  // modulated_force
}

Specimen draw_specimen(const std::string& family, const std::set<std::string>& withheld, std::size_t dwells,
                       Random& random, Programme programme) {
  Specimen s;
  s.family = family;
  s.settling.substeps = 4;
  const bool stiffness = !withheld.contains("cubic_stiffness") && !withheld.contains("cubic_inertia");
  const bool quadratic = !withheld.contains("quadratic_stiffness") && !withheld.contains("quadratic_inertia");
  const std::size_t modes = family == "two_modes" ? 2 : 1;
  s.structure.modes = modes;
  for (std::size_t k = 0; k < modes; ++k) {
    const double ratio = random.uniform(2.3, 2.6);
    ModeTerms& m = s.structure.mode[k];
    m.omega = k == 0 ? two_pi * random.uniform(9, 13) : s.structure.mode[0].omega * ratio;
    if (modes == 2 && k == 0) m.omega = two_pi * random.uniform(8, 10.5);
    s.decay_rate[k] = m.omega * random.uniform(0.006, 0.011);
    s.typical_amplitude[k] = random.log_uniform(1e-3, 4e-3) / (k == 0 ? 1 : 4);
    s.coordinates.push_back(modes == 1 ? "v" : "v" + std::to_string(k + 1));
    s.frequency_symbols.push_back(modes == 1 ? "omega0" : "omega" + std::to_string(k + 1));
  }
  s.settling.time_constant =
      1 / *std::min_element(s.decay_rate.begin(), s.decay_rate.begin() + static_cast<std::ptrdiff_t>(modes));
  // The excitation first: shares of excitation terms are counted in it.
  for (std::size_t k = 0; k < modes; ++k) {
    const std::string suffix = modes == 1 ? "" : k == 0 ? "a" : "b";
    ModeTerms& m = s.structure.mode[k];
    if (family == "principal_parametric") {
      m.parametric = random.sign() * random.log_uniform(2, 12);
      s.own.push_back({"parametric_excitation", k, "eta2"});
      if (!withheld.contains("direct_excitation") && random.chance(0.5)) {
        m.direct = random.sign() * random.log_uniform(0.01, 0.1);
        s.own.push_back({"direct_excitation", k, "eta1"});
      }
      if (stiffness || withheld.contains("cubic_damping") || withheld.contains("amplitude_dependent_damping"))
        draw_cubic(s, k, "alpha3", random.sign() * random.uniform(1.2, 2.2));
      add_own(s, "viscous_damping", k, "mu1", 1);
      if (!withheld.contains("cubic_damping") && !withheld.contains("amplitude_dependent_damping"))
        add_own(s, "cubic_damping", k, "mu3", random.uniform(0.4, 0.9));
      continue;
    }
    m.direct = random.sign() * random.log_uniform(0.02, 0.3);
    s.own.push_back({"direct_excitation", k, "eta1" + suffix});
    s.typical_drive = 2 * s.decay_rate[k] * m.omega * s.typical_amplitude[k] / std::abs(m.direct);
    draw_damping(s, k, suffix, withheld, random);
    const double shift = random.sign() * random.uniform(0.3, 1.2);
    if (stiffness) draw_cubic(s, k, "alpha3" + suffix, shift);
    if (family == "asymmetric" && quadratic) add_own(s, "quadratic_stiffness", k, "alpha2", random.uniform(6, 14));
  }
  if (modes == 2 && !withheld.contains("cubic_coupling"))
    add_own(s, "cubic_coupling", 0, "c22", random.sign() * random.uniform(0.3, 1));
  draw_sensors(s, random);
  if (programme == Programme::dwells)
    draw_dwells(s, dwells, random);
  else
    s.stretches = draw_stretches(programme, s.structure.mode[0], s.decay_rate[0],
                                 {s.typical_amplitude[0], s.typical_drive}, random);
  double started = s.dwells.empty() ? -90 : s.dwells.back().drive.started;
  for (Stretch& stretch : s.stretches) stretch.drive.started = started += 90;
  return s;
}

}  // namespace secular::blind

#include "blind/effect.hpp"

#include <algorithm>
#include <cmath>
#include <set>

namespace secular::blind {
namespace {

bool either_sign(const std::string& effect) {
  static const std::set<std::string> of_one_sign = {
      "viscous_damping",   "quadratic_damping", "cubic_damping",        "amplitude_dependent_damping",
      "coulomb_friction",  "freeplay",          "hysteresis",           "clipping",
      "one_sided_stop",    "two_sided_stop",    "saturating_stiffness", "one_sided_damping",
      "threshold_damping", "quartic_damping",   "channel_skew",         "stribeck_friction",
      "power_damping"};
  return !of_one_sign.contains(effect);
}

// A decay knows of no excitation, and its only response reads in units of its own; a level is that of a line.
bool is_shown(const std::string& effect, Programme programme) {
  static const std::set<std::string> of_lines = {"shaker_harmonics", "level_stiffness"};
  static const std::set<std::string> of_excitation = {"direct_excitation", "parametric_excitation", "extra_mode",
                                                      "sensor_gain",       "sensor_cross_axis",     "channel_skew"};
  if (programme == Programme::dwells) return true;
  const bool free = programme == Programme::decays || programme == Programme::one_decay;
  return !of_lines.contains(effect) && !(free && of_excitation.contains(effect));
}

}  // namespace

Reality reality_of(const Specimen& specimen) {
  return {specimen.structure, specimen.measurement, 0, 0, {}};
}

void switch_on(const Withheld& w, const Specimen& specimen, const std::vector<double>& peak, Reality& reality) {
  ModeTerms& mode = reality.structure.mode[w.mode];
  const double a = specimen.typical_amplitude[w.mode];
  ChannelFault& fault = reality.measurement.fault[w.channel];
  if (w.effect == "sensor_gain") {
    fault.gain = w.coefficient;
  } else if (w.effect == "sensor_offset") {
    fault.offset = w.coefficient;
  } else if (w.effect == "sensor_cross_axis") {
    fault.cross_axis = w.coefficient;
  } else if (w.effect == "channel_skew") {
    fault.late = w.coefficient;
  } else if (w.effect == "clipping") {
    fault.range = peak.at(w.channel) / (1 + w.coefficient);
  } else if (w.effect == "mode_shape_error") {
    reality.measurement.leak[w.mode] = w.coefficient;
  } else if (w.effect == "shaker_harmonics") {
    reality.second = w.coefficient;
    reality.third = w.coefficient * w.detail;
  } else {
    *coefficient(reality.structure, w.effect, w.mode) += w.coefficient;
    if (w.effect == "freeplay" || w.effect.ends_with("_stop")) mode.gap = w.detail * a;
    if (w.effect == "saturating_stiffness") mode.level = w.detail * a;
    if (w.effect == "stribeck_friction") {
      mode.falling_share = 1;
      mode.falling_speed = w.detail * a * mode.omega;
    }
    if (w.effect == "power_damping") mode.exponent = w.detail;
    if (w.effect == "threshold_damping") mode.threshold = w.detail * a;
    if (w.effect == "hysteresis") {
      mode.slip = w.detail * a;
      mode.smooth_slider = w.smooth;
    }
    if (w.effect == "extra_mode") {
      const double excited = specimen.family == "principal_parametric" ? 2 * mode.omega : mode.omega;
      reality.structure.extra.omega = excited * w.detail;
      reality.structure.extra.mu = specimen.decay_rate[w.mode] * 1.2;
    }
  }
}

bool is_measurement_fault(const std::string& effect) {
  static const std::set<std::string> faults = {"sensor_gain",  "sensor_offset", "sensor_cross_axis",
                                               "channel_skew", "clipping",      "mode_shape_error"};
  return faults.contains(effect);
}

std::vector<std::string> effects_shown(const std::string& family, Programme programme) {
  std::vector<std::string> effects = {
      "quadratic_damping",    "cubic_damping",     "coulomb_friction",        "amplitude_dependent_damping",
      "cubic_stiffness",      "quintic_stiffness", "bilinear_stiffness",      "freeplay",
      "cubic_inertia",        "hysteresis",        "natural_frequency_drift", "extra_mode",
      "shaker_harmonics",     "sensor_gain",       "sensor_offset",           "sensor_cross_axis",
      "channel_skew",         "clipping",          "one_sided_stop",          "two_sided_stop",
      "saturating_stiffness", "level_stiffness",   "stribeck_friction",       "power_damping"};
  const auto also = [&](const std::vector<std::string>& more) {
    effects.insert(effects.end(), more.begin(), more.end());
  };
  if (family == "principal_parametric") {
    also({"quadratic_stiffness", "quadratic_inertia", "direct_excitation"});
  } else if (family == "two_modes") {
    also({"viscous_damping", "damping_coupling", "quadratic_coupling", "cubic_coupling", "parametric_coupling",
          "mode_shape_error", "quadratic_stiffness"});
  } else {
    also({"viscous_damping", "quadratic_stiffness", "quadratic_inertia", "parametric_excitation"});
  }
  std::erase_if(effects, [&](const std::string& effect) { return !is_shown(effect, programme); });
  return effects;
}

std::vector<std::string> uncatalogued_effects(Programme programme) {
  std::vector<std::string> effects = {"septic_stiffness", "one_sided_damping", "threshold_damping",
                                      "quartic_damping"};
  if (programme == Programme::dwells) effects.emplace_back("modulated_force");
  return effects;
}

std::vector<std::string> look_alikes(const std::string& effect, const std::string& family, Programme programme) {
  static const std::vector<std::vector<std::string>> groups = {
      {"cubic_stiffness", "cubic_inertia"},
      {"quadratic_stiffness", "quadratic_inertia"},
      {"cubic_damping", "amplitude_dependent_damping"},
      {"quintic_stiffness", "septic_stiffness"},
      {"coulomb_friction", "hysteresis"},
      {"freeplay", "hysteresis", "two_sided_stop"},
      {"bilinear_stiffness", "one_sided_stop"},
      {"cubic_stiffness", "saturating_stiffness"},
      {"viscous_damping", "quadratic_damping"},
      {"coulomb_friction", "stribeck_friction"},
      {"quadratic_damping", "cubic_damping", "power_damping"},
      {"sensor_cross_axis", "extra_mode"},
      {"sensor_cross_axis", "parametric_excitation"}};
  std::vector<std::string> alike;
  const std::vector<std::string> outside = uncatalogued_effects(programme);
  const auto listed = effects_shown(family, programme);
  const auto add = [&](const std::string& name) {
    const bool of_catalogue = std::find(listed.begin(), listed.end(), name) != listed.end();
    if (of_catalogue && name != effect && std::find(alike.begin(), alike.end(), name) == alike.end())
      alike.push_back(name);
  };
  for (const std::vector<std::string>& group : groups)
    if (std::find(group.begin(), group.end(), effect) != group.end())
      for (const std::string& name : group) add(name);
  // Whatever is outside of the catalogue could look like any term of it.
  if (std::find(outside.begin(), outside.end(), effect) != outside.end())
    for (const std::string& name : listed)
      if (!is_measurement_fault(name) && name != "shaker_harmonics" && name != "extra_mode") add(name);
  return alike;
}

Withheld draw_withheld(const std::string& effect, const Specimen& s, Random& random) {
  Withheld w;
  w.effect = effect;
  w.mode = random.below(s.structure.modes);
  if (effect == "extra_mode" && s.family == "two_modes") w.mode = 0;
  const double sign = either_sign(effect) ? random.sign() : 1;
  const std::size_t channels = s.measurement.names.size();
  w.channel = is_measurement_fault(effect) ? 1 + random.below(channels - 1) : 0;
  if (effect == "sensor_offset" && !s.dwells.empty() && random.chance(0.2)) w.channel = 0;
  if (effect == "freeplay") w.detail = random.uniform(0.2, 0.6);
  if (effect.ends_with("_stop")) w.detail = random.uniform(0.3, 0.8);
  if (effect == "saturating_stiffness") w.detail = random.uniform(0.3, 1);
  if (effect == "hysteresis") w.detail = random.uniform(0.1, 0.5);
  if (effect == "stribeck_friction") w.detail = random.uniform(0.1, 0.6);
  if (effect == "power_damping") w.detail = random.uniform(1.3, 3.5);
  if (effect == "threshold_damping") w.detail = random.uniform(0.4, 0.8);
  if (effect == "shaker_harmonics") w.detail = random.uniform(-1, 1);
  if (effect == "extra_mode") w.detail = 1 + random.sign() * random.uniform(0.015, 0.05);
  w.smooth = effect == "hysteresis" && random.chance(0.5);
  if (effect == "sensor_gain" || effect == "mode_shape_error" || effect == "clipping" ||
      effect == "shaker_harmonics")
    w.coefficient = sign * 0.03;
  else if (effect == "channel_skew")
    w.coefficient = 0.03 / s.structure.mode[w.mode].omega;
  else if (effect == "sensor_offset" || effect == "sensor_cross_axis")
    w.coefficient = sign * 0.01;
  else
    w.coefficient =
        sign * coefficient_of_share(s, effect, w.mode,
                                    effect.starts_with("quadratic_s") || effect.starts_with("quadratic_i") ||
                                            effect == "parametric_excitation"
                                        ? 1
                                        : 0.1);
  return w;
}

}  // namespace secular::blind

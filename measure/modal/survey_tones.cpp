#include "measure/modal/survey_tones.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>
#include <vector>

#include "measure/modal/combination_tones.hpp"
#include "measure/modal/pole.hpp"
#include "measure/thresholds.hpp"
#include "numerics/hertz.hpp"

namespace secular {
namespace {

constexpr auto& combination_by_chance = measure_thresholds().combination_by_chance;

void widen(Interval& range, double value) {
  range.low = std::min(range.low, value);
  range.high = std::max(range.high, value);
}

DecayingMotion motion_of(const ModalSurvey& survey, const SurveyMode& mode) {
  const PoleSupport& support = mode.diagram.support;
  const double rate = -support.pole.real(), omega = support.pole.imag();
  DecayingMotion motion;
  motion.pole = support.pole;
  motion.growth_sd = support.growth_sd;
  motion.omega_sd = support.omega_sd;
  motion.amplitudes = support.amplitudes;
  motion.displacement =
      mode.diagram.strength / std::pow(natural_frequency(support.pole), static_cast<int>(survey.form));
  motion.rate = {rate, rate};
  motion.omega = {omega, omega};
  if (mode.amplitude) {
    const AmplitudeDependence& line = *mode.amplitude;
    // Where the first window begins, of which the amplitude is a mean.
    const double first = line.largest_amplitude * std::exp(std::abs(rate) * mode.window_s / 2);
    for (const double a : {0.0, first}) {
      widen(motion.omega, line.frequency_law.at(a) / to_hz);
      widen(motion.rate, -line.damping_law.at(a) / to_hz);
    }
    motion.followed = true;
  }
  return motion;
}

std::string name_of(const std::size_t (&modes)[2], const int (&times)[2]) {
  // What is added first.
  const std::size_t first = times[0] < 0 ? std::size_t{1} : std::size_t{0}, second = 1 - first;
  const auto term = [&](std::size_t i) {
    const int n = std::abs(times[i]);
    return (n > 1 ? fmt::format("{} ", n) : std::string()) + fmt::format("v{}", modes[i] + 1);
  };
  if (times[second] == 0) return term(first);
  return term(first) + (times[second] < 0 ? " - " : " + ") + term(second);
}

Interval in_hz(const Interval& omega) {
  return {omega.low * to_hz, omega.high * to_hz};
}

// Of a combination whose places are among modes, tones not counted.
SurveyTone tone_of(const CombinationMatch& match, const std::vector<SurveyMode>& modes) {
  SurveyTone tone;
  tone.found = modes[match.motion];
  const Combination& c = match.combination;
  for (std::size_t i = 0; i < 2; ++i) {
    tone.modes[i] = c.motions[i];
    tone.times[i] = c.times[i];
  }
  // A difference counts from the faster one.
  const double sign = c.times[0] * modes[c.motions[0]].diagram.support.pole.imag() +
                      c.times[1] * modes[c.motions[1]].diagram.support.pole.imag();
  if (sign < 0)
    for (int& times : tone.times) times = -times;
  tone.expected_hz = in_hz(match.omega);
  tone.expected_rate = match.rate;
  tone.chance = match.chance;
  return tone;
}

std::string remark_of(const SurveyTone& tone, CombinationVerdict verdict) {
  const double rate = -tone.found.diagram.support.pole.real();
  const std::string where = fmt::format("lies at {}", tone.name());
  const std::string rates = fmt::format("{:.3g} 1/s, not with {:.3g} to {:.3g} 1/s", rate, tone.expected_rate.low,
                                        tone.expected_rate.high);
  switch (verdict) {
    case CombinationVerdict::own_rate:
      return where + " but decays with a rate of its own, " + rates + ": a mode near an internal resonance";
    case CombinationVerdict::rates_unknown:
      return where + " and may be no mode: its rate of decay is not known well enough to tell";
    case CombinationVerdict::by_chance:
      return fmt::format("{} and decays like it, but of so many combinations one is that near by chance ({:.2g} %)",
                         where, 100 * tone.chance);
    case CombinationVerdict::own_amplitude:
      return where +
             " but is a mode: from record to record its amplitude goes with the excitation, not with the "
             "product of the others";
    case CombinationVerdict::tone:
      break;
  }
  return "";
}

}  // namespace

std::string SurveyTone::name() const {
  return name_of(modes, times);
}

std::string SurveyTone::reason() const {
  const std::complex<double> pole = found.diagram.support.pole;
  return fmt::format(
      "{} is at {:.6g} to {:.6g} Hz and decays with {:.3g} to {:.3g} 1/s; this is at {:.6g} Hz and decays with "
      "{:.3g} 1/s. A mode is there by chance with a probability of at most {:.2g} %",
      name(), expected_hz.low, expected_hz.high, expected_rate.low, expected_rate.high, pole.imag() * to_hz,
      -pole.real(), 100 * chance);
}

void set_tones_aside(ModalSurvey& survey) {
  std::vector<DecayingMotion> motions;
  std::vector<std::size_t> of_mode;
  for (std::size_t r = 0; r < survey.modes.size(); ++r) {
    if (!survey.modes[r].diagram.support.stands) continue;
    motions.push_back(motion_of(survey, survey.modes[r]));
    of_mode.push_back(r);
  }
  std::vector<bool> is_tone(survey.modes.size(), false);
  std::vector<std::pair<SurveyTone, CombinationVerdict>> found;
  for (CombinationMatch& match : find_combinations(motions, combination_by_chance)) {
    match.motion = of_mode[match.motion];
    for (std::size_t& partner : match.combination.motions) partner = of_mode[partner];
    found.emplace_back(tone_of(match, survey.modes), match.verdict);
    is_tone[match.motion] = match.verdict == CombinationVerdict::tone;
  }
  std::vector<std::size_t> place(survey.modes.size());
  std::size_t next = 0;
  for (std::size_t r = 0; r < place.size(); ++r) place[r] = is_tone[r] ? place.size() : next++;
  std::vector<SurveyMode> modes;
  for (std::size_t r = 0; r < survey.modes.size(); ++r)
    if (!is_tone[r]) modes.push_back(std::move(survey.modes[r]));
  for (auto& [tone, verdict] : found) {
    for (std::size_t& mode : tone.modes) mode = place[mode];
    if (verdict == CombinationVerdict::tone) {
      survey.tones.push_back(tone);
      continue;
    }
    const std::complex<double> pole = tone.found.diagram.support.pole;
    for (SurveyMode& mode : modes)
      if (mode.diagram.support.pole == pole) mode.remarks.push_back(remark_of(tone, verdict));
  }
  survey.modes = std::move(modes);
  std::erase_if(survey.windows, [&](const ModeWindow& w) { return is_tone[static_cast<std::size_t>(w.mode)]; });
  for (ModeWindow& w : survey.windows) w.mode = static_cast<Eigen::Index>(place[static_cast<std::size_t>(w.mode)]);
  std::sort(survey.tones.begin(), survey.tones.end(), [](const SurveyTone& a, const SurveyTone& b) {
    return a.found.natural_frequency_hz < b.found.natural_frequency_hz;
  });
}

}  // namespace secular

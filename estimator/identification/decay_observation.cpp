#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "estimator/identification/modal_projection.hpp"
#include "estimator/identification/mode_frequencies.hpp"
#include "estimator/identification/observation_set.hpp"
#include "estimator/identification/record_window.hpp"
#include "estimator/signal/free_decay.hpp"
#include "input/input_error.hpp"

namespace secular {
namespace {

using Complex = std::complex<double>;
using Eigen::Index;

/// A window whose residual is this many times that of the quiet ones is not used.
constexpr double disturbed_noise = 2;

/// Independent stretches that a decay is cut into for its error bars.
constexpr double decay_stretches = 12;

constexpr double two_pi = 2 * std::numbers::pi;

/// Another mode counts as decayed where its part of the samples is below this share of the mode's own.
constexpr double decayed_share = 0.02;

// True if another modal coordinate (samples x modes) moves visibly in the window around sample `centre`: more than
// its share of the mode's own motion and more than it does at the record's end.
bool others_move(const Eigen::MatrixXd& modal, std::size_t own, Index centre, Index length) {
  const Index first = std::clamp<Index>(centre - length / 2, 0, modal.rows() - 1);
  const Index count = std::min(length, modal.rows() - first), tail = std::min(length, modal.rows());
  const auto spread = [&](Index column, Index from, Index size) {
    const auto part = modal.col(column).segment(from, size);
    return std::sqrt((part.array() - part.mean()).square().mean());
  };
  const double mine = spread(static_cast<Index>(own), first, count);
  for (Index k = 0; k < modal.cols(); ++k) {
    if (k == static_cast<Index>(own)) continue;
    const double other = spread(k, first, count);
    if (other > decayed_share * mine && other > 2 * spread(k, modal.rows() - tail, tail)) return true;
  }
  return false;
}

}  // namespace

ObservationSet observe_free_decays(const Campaign& campaign, const RecordReader& read_samples,
                                   const CompiledModel& model, const CompiledCase& resonance,
                                   const Window& window) {
  const ModeFrequencies modes = mode_frequencies(model, resonance);
  const auto active = std::count(modes.oscillates.begin(), modes.oscillates.end(), true);
  if (active != 1)
    throw InputError(
        campaign.folder.string(), "case " + std::string(resonance.name),
        fmt::format("free decays of {} modes at once are not identified", active),
        "use a case in which all modes but one are in modes_at_rest: the windows in which the others have "
        "decayed are used");
  const auto own = static_cast<std::size_t>(std::find(modes.oscillates.begin(), modes.oscillates.end(), true) -
                                            modes.oscillates.begin());
  ObservationSet set;
  set.model = &model;
  set.resonance = &resonance;
  const ModalProjection projection = modal_projection(campaign, model);
  int condition = 0;
  for (std::size_t r = 0; r < campaign.records.size(); ++r) {
    const RecordEntry& entry = campaign.records[r];
    const bool decays = entry.kind == RecordKind::free_decay || entry.kind == RecordKind::impact;
    if (!decays || !window.takes(r, entry.file)) continue;
    const Record record = read_samples(r);
    const SampleRange range = range_of(record, window);
    // The modal filter works on samples as well as on amplitudes.
    const Eigen::MatrixXd all =
        samples_of(record, projection.channels, range.first, range.count) * projection.matrix.transpose();
    const Eigen::VectorXd modal = all.col(static_cast<Index>(own));
    const auto start = find_decay_start(modal, record.sample_rate_hz);
    if (!start) {
      set.warnings.push_back(fmt::format("{}: no free decay is found in it, left out", entry.file));
      continue;
    }
    const WindowOptions options;
    std::vector<DecayWindow> windows =
        sliding_windows(modal.tail(modal.size() - start->sample), record.sample_rate_hz, start->frequency, options);
    if (windows.size() < 6) {
      set.warnings.push_back(fmt::format("{}: fewer than six windows of free decay, left out", entry.file));
      continue;
    }
    // A window that leaves clearly more than the quiet ones is disturbed: a knock, lost samples, a step of the
    // clock.
    std::vector<double> noise;
    for (const DecayWindow& w : windows) noise.push_back(w.noise_sd(0));
    std::sort(noise.begin(), noise.end());
    const double quiet = noise[noise.size() / 5];
    const auto disturbed = [&](const DecayWindow& w) { return w.noise_sd(0) > disturbed_noise * quiet; };
    const auto bad = std::count_if(windows.begin(), windows.end(), disturbed);
    if (bad > 0) {
      const auto at = std::find_if(windows.begin(), windows.end(), disturbed);
      set.warnings.push_back(
          fmt::format("{}: {} of {} windows are disturbed (they leave more than {} times what the quiet ones "
                      "leave: a knock, lost "
                      "samples or a step of the clock; the first at {:.1f} s), left out",
                      entry.file, bad, windows.size(), disturbed_noise,
                      record.start_s + static_cast<double>(range.first + start->sample) / record.sample_rate_hz +
                          at->centre_s));
      windows.erase(std::remove_if(windows.begin(), windows.end(), disturbed), windows.end());
    }
    const auto others = [&](const DecayWindow& w) {
      return others_move(all, own, start->sample + static_cast<Index>(w.centre_s * record.sample_rate_hz),
                         static_cast<Index>(options.periods * two_pi / w.frequency * record.sample_rate_hz));
    };
    if (const auto moving = std::count_if(windows.begin(), windows.end(), others); moving > 0) {
      set.warnings.push_back(fmt::format("{}: {} of {} windows are left out because another mode moves too",
                                         entry.file, moving, windows.size()));
      windows.erase(std::remove_if(windows.begin(), windows.end(), others), windows.end());
    }
    if (windows.size() < 6) {
      set.warnings.push_back(fmt::format("{}: fewer than six windows of free decay of {} alone, left out",
                                         entry.file, model.coordinates[own]));
      continue;
    }
    // Neighbouring windows share samples: stretches of at least one and a half windows count as independent, about
    // a dozen of them in a record.
    const double window_s = options.periods * 2 * std::numbers::pi / windows.front().frequency;
    const double stretch_s =
        std::max(1.5 * window_s, (windows.back().centre_s - windows.front().centre_s) / decay_stretches);
    int stretches = 0;
    for (std::size_t w = 0; w < windows.size(); ++w) {
      const DecayWindow& window_fit = windows[w];
      Observation o;
      const auto stretch = static_cast<int>((window_fit.centre_s - windows.front().centre_s) / stretch_s);
      o.condition = condition + stretch;
      stretches = std::max(stretches, stretch + 1);
      o.record = r;
      o.centre_s = record.start_s + static_cast<double>(range.first + start->sample) / record.sample_rate_hz +
                   window_fit.centre_s;
      for (std::size_t j = 0; j < model.excitations.size(); ++j) {
        o.excitation_frequency.push_back(0);
        o.excitation_frequency_sd.push_back(0);
        o.forcing.emplace_back();
        o.forcing_sd.push_back(0);
      }
      const Complex rate(window_fit.growth, window_fit.frequency);
      for (std::size_t k = 0; k < model.modes(); ++k) {
        const bool here = k == own;
        o.amplitude.push_back(here ? to_displacement(window_fit.amplitude(0, 0), rate, projection.derivatives)
                                   : Complex());
        o.amplitude_sd.push_back(
            here ? window_fit.amplitude_sd(0, 0) / std::pow(window_fit.frequency, projection.derivatives) : 0.0);
        o.rate.push_back(here ? rate : Complex());
        o.growth_sd.push_back(here ? window_fit.growth_sd : 0.0);
        o.frequency_sd.push_back(here ? window_fit.frequency_sd : 0.0);
      }
      o.free_frequency_sd.push_back(window_fit.frequency_sd);
      for (const RegressorBlock& block : resonance.blocks) {
        const auto harmonic = std::find(options.harmonics.begin(), options.harmonics.end(),
                                        block.kind == BlockKind::harmonic ? block.phase[own] : 0);
        const bool seen =
            harmonic != options.harmonics.end() && *harmonic > 1 && block.mode == static_cast<int>(own);
        const Index row = harmonic - options.harmonics.begin();
        o.harmonic.push_back(seen ? to_displacement(window_fit.amplitude(row, 0),
                                                    rate * static_cast<double>(*harmonic), projection.derivatives)
                                  : Complex());
        o.harmonic_sd.push_back(seen ? window_fit.amplitude_sd(row, 0) /
                                           std::pow(window_fit.frequency * *harmonic, projection.derivatives)
                                     : -1.0);
      }
      set.observations.push_back(std::move(o));
    }
    condition += stretches;
  }
  return set;
}

}  // namespace secular

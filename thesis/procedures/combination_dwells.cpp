#include "thesis/procedures/combination_dwells.hpp"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "input/input_error.hpp"
#include "measure/observe/modal_projection.hpp"
#include "measure/observe/record_window.hpp"
#include "measure/signal/decomposition.hpp"
#include "measure/signal/tone_fit.hpp"
#include "measure/thresholds.hpp"
#include "numerics/hertz.hpp"
#include "thesis/procedures/engine_lumps.hpp"

namespace secular {
namespace {

using Complex = std::complex<double>;
using Eigen::Index;
using Eigen::MatrixXd;

/// A mode's frequency is looked for within this share of the nominal one.
constexpr double frequency_share = 0.05;

struct Reader {
  const Campaign& campaign;
  const CompiledModel& model;
  const CompiledCase& resonance;
  ModalProjection projection;
  std::size_t excitation = 0;
  const Window& window;
  double nominal[2] = {0, 0};

  // Frequencies of both modes, whose sum is the excitation's; nothing where a mode does not respond.
  bool mode_frequencies(const MatrixXd& modal, double rate, double excitation_frequency, double* frequency,
                        double& sd) const {
    // Both signals at once share the poles; the excitation's own tone is in them too.
    DecompositionOptions options;
    options.order = 2;
    options.imposed = {excitation_frequency};
    options.offset = true;
    options.refine = true;
    const Decomposition tones = decompose(modal, rate, options);
    double found[2], variance[2];
    for (Index k = 0; k < 2; ++k) {
      const std::optional<std::size_t> pole = tones.nearest(nominal[k]);
      if (!pole) return false;
      const ToneEstimate tone = tones.tone(*pole, k);
      if (!(std::abs(tone.frequency / nominal[k] - 1) < frequency_share) || !(tone.frequency_sd > 0)) return false;
      found[k] = tone.frequency;
      variance[k] = tone.frequency_sd * tone.frequency_sd;
    }
    // The sum is known far better than either.
    const double excess = excitation_frequency - found[0] - found[1];
    const double share = variance[0] / (variance[0] + variance[1]);
    frequency[0] = found[0] + share * excess;
    frequency[1] = found[1] + (1 - share) * excess;
    sd = std::sqrt(variance[0] * variance[1] / (variance[0] + variance[1]));
    return true;
  }

  bool ensemble(const Record& record, std::size_t r, int condition, Index begin, Index count,
                Observation& o) const {
    const RecordEntry& entry = campaign.records[r];
    const double rate = record.sample_rate_hz;
    o.condition = condition;
    o.record = r;
    o.centre_s = record.start_s + (static_cast<double>(begin) + 0.5 * static_cast<double>(count - 1)) / rate;
    const MatrixXd base = Eigen::Map<const Eigen::VectorXd>(record.channels[excitation].data() + begin, count);
    const double guess =
        entry.excitation_frequency_hz ? two_pi * *entry.excitation_frequency_hz : nominal[0] + nominal[1];
    const ToneFit tone = fit_harmonic_tone(base, rate, guess, ToneOptions{});
    if (tone.ending == SolverEnding::ran_away || std::abs(tone.frequency / guess - 1) > 0.2)
      throw InputError((campaign.folder / entry.file).string(), "channel " + campaign.channels[excitation].name,
                       "no steady excitation tone is found in it",
                       "check excitation_frequency_hz and the channel's role");
    o.excitation_frequency = {tone.frequency};
    const double noise = window.noise_factor(rate);
    o.excitation_frequency_sd = {noise * tone.frequency_sd};
    o.forcing = {2.0 * tone.amplitude(0, 0)};
    o.forcing_sd = {2 * noise * tone.amplitude_sd(0, 0)};
    const MatrixXd modal = samples_of(record, projection.channels, begin, count) * projection.matrix.transpose();
    double frequency[2], frequency_sd = 0;
    if (!mode_frequencies(modal, rate, tone.frequency, frequency, frequency_sd)) return false;
    frequency_sd *= noise;
    if (!window.passes(frequency[0]) || !window.passes(frequency[1])) return false;
    std::vector<double> tones;
    const double resolution = two_pi * rate / static_cast<double>(count);
    const auto index_of = [&](double f) -> std::ptrdiff_t {
      if (f < 2 * resolution || f > std::numbers::pi * rate - 2 * resolution) return -1;
      for (std::size_t i = 0; i < tones.size(); ++i)
        if (std::abs(tones[i] - f) < 0.5 * resolution) return static_cast<std::ptrdiff_t>(i);
      tones.push_back(f);
      return static_cast<std::ptrdiff_t>(tones.size() - 1);
    };
    const std::ptrdiff_t at_mode[2] = {index_of(frequency[0]), index_of(frequency[1])};
    std::vector<double> block_frequency;
    std::vector<std::ptrdiff_t> at_block;
    for (const RegressorBlock& block : resonance.blocks) {
      double f = 0;
      for (std::size_t i = 0; i < block.phase.size(); ++i)
        f += block.phase[i] * (i < 2 ? frequency[i] : tone.frequency);
      const bool seen = block.kind == BlockKind::harmonic && block.order <= 1 && window.passes(std::abs(f));
      block_frequency.push_back(std::abs(f));
      at_block.push_back(seen ? index_of(std::abs(f)) : -1);
    }
    index_of(tone.frequency);
    KnownFrequencyFit fit = known_frequency_components(modal, rate, tones, true);
    fit.amplitude_sd *= noise;
    for (std::size_t k = 0; k < 2; ++k) {
      const auto mode = static_cast<Index>(k);
      o.amplitude.push_back(
          to_displacement({fit.amplitude(at_mode[k], mode)}, frequency[k], projection.derivatives).value);
      o.amplitude_sd.push_back(fit.amplitude_sd(at_mode[k], mode) / std::pow(frequency[k], projection.derivatives));
      o.rate.emplace_back(0, frequency[k]);
      o.growth_sd.push_back(0);
      o.frequency_sd.push_back(frequency_sd);
    }
    o.free_frequency_sd = {frequency_sd};  // of either mode: their sum is the excitation's
    for (std::size_t b = 0; b < at_block.size(); ++b) {
      const auto mode = static_cast<Index>(resonance.blocks[b].mode);
      const bool seen = at_block[b] >= 0;
      o.harmonic.push_back(
          seen ? to_displacement({fit.amplitude(at_block[b], mode)}, block_frequency[b], projection.derivatives)
                     .value
               : Complex());
      o.harmonic_sd.push_back(
          seen ? fit.amplitude_sd(at_block[b], mode) / std::pow(block_frequency[b], projection.derivatives) : -1.0);
    }
    return true;
  }
};

bool both_respond(const std::vector<Observation>& ensembles) {
  for (std::size_t k = 0; k < 2; ++k) {
    double largest = 0;
    for (const Observation& o : ensembles)
      largest = std::max(largest, std::abs(o.amplitude[k]) / o.amplitude_sd[k]);
    if (largest < least_amplitude_sd()) return false;
  }
  return !ensembles.empty();
}

}  // namespace

ObservationSet observe_combination_dwells(const Campaign& campaign, const RecordReader& read,
                                          const CompiledModel& model, const CompiledCase& resonance,
                                          const Window& window) {
  if (!is_additive_combination(model, resonance))
    throw InputError(campaign.folder.string(), "case " + std::string(resonance.name),
                     "is no additive combination resonance of two modes", "Omega = omega1 + omega2 was expected");
  Reader reader{
      campaign, model, resonance, modal_projection(campaign, model), excitation_channels(campaign, model).front(),
      window,   {0, 0}};
  for (std::size_t k = 0; k < 2; ++k) reader.nominal[k] = model.nominal[k];
  ObservationSet set;
  set.model = &model;
  set.resonance = &resonance;
  int condition = 0;
  for (std::size_t r = 0; r < campaign.records.size(); ++r) {
    const RecordEntry& entry = campaign.records[r];
    if (entry.kind != RecordKind::dwell || !window.takes(r, entry.file)) continue;
    const Record record = read(r);
    const SampleRange range = range_of(record, window);
    std::optional<Index> asked;
    if (entry.ensemble_s) asked = static_cast<Index>(std::lround(*entry.ensemble_s * record.sample_rate_hz));
    const Index length = asked.value_or(range.count);
    const int label = condition++;
    if (const auto nominal = entry.excitation_frequency_hz; nominal && !window.passes(two_pi * *nominal)) {
      set.warnings.push_back(
          fmt::format("{}: its excitation at {:.4g} Hz is outside of the band, left out", entry.file, *nominal));
      continue;
    }
    if (const std::string why = too_short(record, window, range.count, asked, 64); !why.empty()) {
      set.warnings.push_back(fmt::format("{}: {}, left out", entry.file, why));
      continue;
    }
    std::vector<Observation> found;
    bool responds = true;
    for (Index begin = range.first; responds && begin + length <= range.first + range.count; begin += length) {
      Observation o;
      responds = reader.ensemble(record, r, label, begin, length, o);
      if (responds) found.push_back(std::move(o));
    }
    if (!responds || !both_respond(found)) {
      set.warnings.push_back(fmt::format(
          "{}: the motion is on the trivial branch (its amplitude is not above the noise), left out", entry.file));
      continue;
    }
    set.observations.insert(set.observations.end(), found.begin(), found.end());
  }
  return set;
}

}  // namespace secular

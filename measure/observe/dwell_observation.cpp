#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "estimator/model/zero_frequency.hpp"
#include "input/input_error.hpp"
#include "measure/observe/dwell_resonance.hpp"
#include "measure/observe/line_offset.hpp"
#include "measure/observe/mode_frequencies.hpp"
#include "measure/observe/observation_set.hpp"
#include "measure/observe/observed_blocks.hpp"
#include "measure/observe/record_window.hpp"
#include "measure/observe/related_tones.hpp"
#include "measure/observe/response_tones.hpp"
#include "measure/observe/tabled_tones.hpp"
#include "measure/signal/bispectral_phase.hpp"
#include "measure/signal/free_decay.hpp"
#include "measure/signal/tone_fit.hpp"
#include "measure/signal/tone_separation.hpp"
#include "measure/thresholds.hpp"
#include "numerics/distribution.hpp"
#include "numerics/hertz.hpp"
#include "numerics/in_parallel.hpp"

namespace secular {
namespace {

using Complex = std::complex<double>;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Share of an excitation channel's power that its tone must have: more than all else in it together.
constexpr double mainly_a_tone = 0.5;

/// Relative difference of measured and nominal excitation amplitude that is worth a warning.
constexpr auto& same_level = measure_thresholds().same_level;

/// Free frequencies are searched this far from where the nominal values put them, relative to the lowest mode.
constexpr auto& dwell_search_range = measure_thresholds().largest_detuning;

/// Fewer ensembles cannot tell phases that stand still from independent ones at the one percent that is asked for
/// (derived: independent ones pass with probability exp(-K), `bispectral_phase`).
constexpr std::size_t lock_ensembles = 5;

/// Amplitudes of a motion that has not settled, over one ensemble: they settle within a few ensembles, so that the
/// rates that a quadratic finds would be wrong by several percent.
constexpr int transient_degree = 4;

double strongest_frequency(const Eigen::Ref<const VectorXd>& y, double rate) {
  // Mean distance of upward crossings of the mean: enough as a start for one dominant tone.
  const double mean = y.mean();
  Index first = -1, last = -1, crossings = 0;
  for (Index i = 0; i + 1 < y.size(); ++i)
    if (y(i) < mean && y(i + 1) >= mean) {
      if (first < 0) first = i;
      last = i;
      ++crossings;
    }
  return crossings > 1 ? two_pi * rate * static_cast<double>(crossings - 1) / static_cast<double>(last - first)
                       : two_pi * rate / static_cast<double>(y.size());
}

/// A part of a dwell.
struct Ensemble {
  const Record& record;
  std::size_t index;  // of the record
  int condition;
  Index begin, count;  // samples
};

// Samples of an ensemble, where the record says how long they are. Rows that delays took off its ends shorten all
// ensembles a little, in place of taking one away.
std::optional<Index> asked_ensemble(const RecordEntry& entry, const Record& record, Index samples) {
  if (!entry.ensemble_s) return std::nullopt;
  const auto asked = static_cast<Index>(std::lround(*entry.ensemble_s * record.sample_rate_hz));
  const auto cut = static_cast<Index>(record.cut_for_delay);
  if (cut == 0 || asked <= 0 || samples / asked == (samples + cut) / asked) return asked;
  return samples / ((samples + cut) / asked);
}

/// Where frequencies that a resonance leaves free are looked for.
enum class FreeSearch { near_nominal, everywhere };

class DwellObserver {
 public:
  DwellObserver(const Campaign& campaign, const RecordReader& read_samples, const CompiledModel& model,
                const CompiledCase& resonance, const Window& window, DwellMotion motion)
      : campaign_(campaign),
        read_(read_samples),
        model_(model),
        resonance_(resonance),
        window_(window),
        motion_(motion),
        projection_(modal_projection(campaign, model)),
        excitations_(excitation_channels(campaign, model)),
        modes_(mode_frequencies(model, resonance)) {}

  ObservationSet run() const {
    std::vector<std::size_t> dwells;
    for (std::size_t r = 0; r < campaign_.records.size(); ++r)
      if (is_steady(campaign_.records[r].kind) && window_.takes(r, campaign_.records[r].file)) dwells.push_back(r);
    std::vector<ObservationSet> results(dwells.size());
    in_parallel(dwells.size(), window_.threads,
                [&](std::size_t i) { observe(dwells[i], static_cast<int>(i), results[i]); });
    share_conditions(campaign_, dwells, results);
    ObservationSet all;
    all.model = &model_;
    all.resonance = &resonance_;
    for (std::size_t i = 0; i < dwells.size(); ++i) {
      std::move(results[i].observations.begin(), results[i].observations.end(),
                std::back_inserter(all.observations));
      std::move(results[i].at_rest.begin(), results[i].at_rest.end(), std::back_inserter(all.at_rest));
      std::move(results[i].warnings.begin(), results[i].warnings.end(), std::back_inserter(all.warnings));
    }
    noise_from_repeats(all);
    return all;
  }

 private:
  void observe(std::size_t r, int condition, ObservationSet& result) const {
    const RecordEntry& entry = campaign_.records[r];
    const Record record = read_(r);
    if (record.row) return observe_row(*record.row, r, condition, result);
    const SampleRange range = range_of(record, window_);
    const std::optional<Index> asked = asked_ensemble(entry, record, range.count);
    const Index ensemble = asked.value_or(range.count);
    const auto leave_out = [&](const std::string& why) {
      result.warnings.push_back(fmt::format("{}: {}, left out", entry.file, why));
    };
    if (const std::string why = too_short(record, window_, range.count, asked, 32); !why.empty())
      return leave_out(why);
    const auto nominal = entry.excitation_frequency_hz;
    if (nominal && !window_.passes(two_pi * *nominal))
      return leave_out(fmt::format("its excitation at {:.4g} Hz is outside of the band", *nominal));
    if (const std::string why = not_an_excitation(record, entry, range); !why.empty()) return leave_out(why);
    const auto observed = [&](FreeSearch search) {
      std::vector<Observation> found;
      VectorXd free;  // of the ensemble before
      for (Index begin = range.first; begin + ensemble <= range.first + range.count; begin += ensemble)
        found.push_back(observe_ensemble({record, r, condition, begin, ensemble}, search, free));
      return found;
    };
    std::vector<Observation> found = observed(FreeSearch::near_nominal);
    if (window_.band && !all_seen(found)) return leave_out("a mode moves outside of the band");
    if (motion_ == DwellMotion::steady) {
      // What rests near the nominal frequencies may move elsewhere.
      if (modes_.free.size() == 1 && at_rest(found))
        if (std::vector<Observation> other = observed(FreeSearch::everywhere); !at_rest(other))
          found = std::move(other);
      if (at_rest(found)) {
        result.at_rest = std::move(found);
        return leave_out("the motion is on the trivial branch (its amplitude is not above the noise)");
      }
      if (const double drift = largest_drift(found); drift > 0)
        return leave_out(
            fmt::format("has not settled (the amplitude changes by {:.1f} % over the dwell)", 100 * drift));
      if (const std::string why = off_its_line(record, range, ensemble, found); !why.empty()) return leave_out(why);
      if (!locked(found))
        return leave_out("the modes are not locked to the excitation (their phases wander against it)");
      warn_of_level(entry, found, result);
    }
    result.observations = std::move(found);
  }

  // A row of a table: the lines are there, in place of what the tones of an ensemble are fitted to.
  void observe_row(const LineRow& row, std::size_t r, int condition, ObservationSet& result) const {
    const RecordEntry& entry = campaign_.records[r];
    const auto leave_out = [&](const std::string& why) {
      result.warnings.push_back(fmt::format("{}: {}, left out", entry.file, why));
    };
    if (!window_.passes(two_pi * row.frequency_hz))
      return leave_out(fmt::format("its excitation at {:.4g} Hz is outside of the band", row.frequency_hz));
    if (!modes_.free.empty())
      return leave_out("a table has lines at multiples of the excitation's frequency alone, and case " +
                       std::string(resonance_.name) + " leaves the modes' own frequencies free");
    Observation o;
    o.condition = condition;
    o.record = r;
    for (const std::size_t channel : excitations_) {
      const TableLine& force = *row.find(channel, {});
      o.excitation_frequency.push_back(two_pi * row.frequency_hz);
      o.excitation_frequency_sd.push_back(0);
      o.forcing.push_back(force.amplitude);
      o.forcing_sd.push_back(force.sd.value_or(0));
    }
    const TabledTones tones(row, {model_, resonance_, modes_}, o.excitation_frequency, projection_.channels,
                            window_);
    o.noise_known = tones.noise_known();
    if (const std::string missing = observe_tabled_modes(tones, o); !missing.empty()) return leave_out(missing);
    observe_tabled_blocks(tones, o);
    if (std::vector<Observation> found = {o}; motion_ == DwellMotion::steady && at_rest(found)) {
      result.at_rest = std::move(found);
      return leave_out("the motion is on the trivial branch (its amplitude is not above the noise)");
    }
    result.observations = {std::move(o)};
  }

  // docs/inference.md (70): a steady motion is at the frequency that its excitation gives it. Why it is not, in
  // words; empty: it is.
  std::string off_its_line(const Record& record, SampleRange range, Index length,
                           const std::vector<Observation>& found) const {
    if (!modes_.free.empty()) return {};
    const MatrixXd samples = samples_of(record, projection_.channels, range.first, range.count);
    for (std::size_t k = 0; k < model_.modes(); ++k) {
      if (!modes_.oscillates[k]) continue;
      const VectorXd motion = samples * projection_.matrix.row(static_cast<Index>(k)).transpose();
      const Eigen::Map<const MatrixXd> windows(motion.data(), length, std::ssize(found));
      const double frequency = found.front().rate[k].imag();
      const LineOffset line =
          line_offset(windows, record.sample_rate_hz, frequency, measure_thresholds().largest_detuning);
      double power = 0;
      for (const Observation& o : found) power += std::norm(o.amplitude[k]) / std::pow(o.amplitude_sd[k], 2);
      if (lost_by_turn(line.turn) > measure_thresholds().dwell_drift &&
          line.resolved * chi_squared_upper_tail(line.gain * power, 2 * static_cast<double>(found.size())) <
              measure_thresholds().motion_false_alarm)
        return fmt::format(
            "its response is at {:.5g} Hz and not at the {:.5g} Hz that the excitation gives it: the channels' "
            "clocks "
            "differ, rows of one channel are missing or doubled, or the motion is another one",
            (frequency + line.turn * record.sample_rate_hz / static_cast<double>(length)) / two_pi,
            frequency / two_pi);
    }
    return {};
  }

  // What the row lacks, in words; empty: nothing.
  std::string observe_tabled_modes(const TabledTones& tones, Observation& o) const {
    for (std::size_t k = 0; k < model_.modes(); ++k) {
      const double f = tones.frequency_of_mode(k);
      Complex value = 0;
      double sd = 0;
      if (modes_.oscillates[k]) {
        const auto line = tones.of_mode(k);
        if (!line)
          return fmt::format("it has no line at {:.4g} times the excitation's frequency, where {} moves in case {}",
                             f / o.excitation_frequency[0], model_.coordinates[k], resonance_.name);
        const double scale = std::pow(f, projection_.derivatives);
        value = to_displacement({project(projection_, k, line->amplitude)}, f, projection_.derivatives).value;
        sd = project_sd(projection_, k, line->sd) / scale;
      }
      o.amplitude.push_back(value);
      o.amplitude_sd.push_back(sd);
      o.rate.emplace_back(0, f);
      o.growth_sd.push_back(0);
      o.frequency_sd.push_back(0);
    }
    return {};
  }

  void observe_tabled_blocks(const TabledTones& tones, Observation& o) const {
    for (std::size_t b = 0; b < resonance_.blocks.size(); ++b) {
      const auto mode = static_cast<std::size_t>(resonance_.blocks[b].mode);
      const bool zero = is_zero_frequency(resonance_.blocks[b]);
      Complex value = 0;
      double sd = -1;
      const auto line = zero && projection_.derivatives > 0 ? std::nullopt : tones.of_block(b);
      if (line && zero) {
        value = project(projection_, mode, line->amplitude);
        sd = project_sd(projection_, mode, line->sd);
      } else if (line) {
        const double f = tones.frequency_of_block(b), size = std::abs(f);
        value = to_displacement({project(projection_, mode, line->amplitude)}, size, projection_.derivatives).value;
        if (f < 0) value = std::conj(value);
        sd = project_sd(projection_, mode, line->sd) / std::pow(size, projection_.derivatives);
      }
      o.harmonic.push_back(value);
      o.harmonic_sd.push_back(sd);
    }
  }

  // What an excitation channel holds if it is not mainly its tone.
  std::string not_an_excitation(const Record& record, const RecordEntry& entry, SampleRange range) const {
    if (motion_ != DwellMotion::steady || !entry.excitation_frequency_hz || excitations_.size() != 1) return {};
    const double frequency = two_pi * *entry.excitation_frequency_hz;
    const auto share = [&](std::size_t channel) {
      const MatrixXd samples = samples_of(record, {channel}, range.first, std::min<Index>(range.count, 4096));
      const KnownFrequencyFit fit =
          known_frequency_components(samples, record.sample_rate_hz, std::span(&frequency, 1), true);
      const double tone = 2 * std::norm(fit.amplitude(0, 0)), rest = fit.noise_sd(0) * fit.noise_sd(0);
      return tone + rest > 0 ? tone / (tone + rest) : 0.0;
    };
    const std::size_t named = excitations_.front();
    const double own = share(named);
    if (own > mainly_a_tone) return {};
    std::string text = fmt::format("channel {}, named excitation, has only {:.0f} % of its power at {:.4g} Hz",
                                   campaign_.channels[named].name, 100 * own, *entry.excitation_frequency_hz);
    std::size_t best = named;
    for (std::size_t c = 0; c < campaign_.channels.size(); ++c)
      if (share(c) > share(best)) best = c;
    if (best != named && share(best) > mainly_a_tone)
      text += fmt::format(" and channel {} has {:.0f} %: are they swapped?", campaign_.channels[best].name,
                          100 * share(best));
    return text;
  }

  // Of the frequency that was asked for and what the decomposition finds near it, which noise may lead astray, the
  // one with more power.
  static double tone_near(const MatrixXd& samples, double rate, double guess) {
    const double decomposed = decomposed_frequency(samples.col(0), rate, guess);
    const auto power = [&](double w) { return tone_power(samples, rate, VectorXd::Constant(1, w)); };
    return power(guess) > power(decomposed) ? guess : decomposed;
  }

  // The nominal frequency is that of one of several excitations: each is where it has more power.
  double excitation_guess(const MatrixXd& samples, double rate, const RecordEntry& entry) const {
    const double nominal = two_pi * entry.excitation_frequency_hz.value_or(0.0);
    if (nominal > 0 && excitations_.size() == 1) return nominal;
    const double strongest = strongest_frequency(samples.col(0), rate);
    const auto power = [&](double w) {
      return tone_power(samples, rate, VectorXd::Constant(1, tone_near(samples, rate, w)));
    };
    return nominal > 0 && power(nominal) >= power(strongest) ? nominal : strongest;
  }

  void warn_of_level(const RecordEntry& entry, const std::vector<Observation>& found,
                     ObservationSet& result) const {
    if (!entry.excitation_amplitude || !(*entry.excitation_amplitude > 0) || excitations_.size() != 1) return;
    const double ratio = std::abs(found.front().forcing[0]) / *entry.excitation_amplitude;
    if (std::abs(ratio - 1) > same_level)
      result.warnings.push_back(fmt::format(
          "{}: channel {} holds {:.3g} times the nominal excitation amplitude: wrong channel, unit or sensitivity?",
          entry.file, campaign_.channels[excitations_.front()].name, ratio));
  }

  Observation observe_ensemble(const Ensemble& ensemble, FreeSearch search, VectorXd& free) const {
    const double rate = ensemble.record.sample_rate_hz;
    Observation o;
    o.condition = ensemble.condition;
    o.record = ensemble.index;
    o.centre_s = ensemble.record.start_s +
                 (static_cast<double>(ensemble.begin) + 0.5 * static_cast<double>(ensemble.count - 1)) / rate;
    for (const std::size_t channel : excitations_) observe_excitation(ensemble, channel, o);
    const MatrixXd responses = samples_of(ensemble.record, projection_.channels, ensemble.begin, ensemble.count);
    if (modes_.free.empty())
      free.resize(0);
    else if (free.size() == 0)
      free = search_free(responses, rate, o.excitation_frequency, search);
    observe_responses(responses, rate, o, free);
    if (excitations_.size() == 1 && motion_ == DwellMotion::steady) observe_excitation_harmonics(ensemble, o);
    return o;
  }

  void observe_excitation(const Ensemble& ensemble, std::size_t channel, Observation& o) const {
    const RecordEntry& entry = campaign_.records[ensemble.index];
    const double rate = ensemble.record.sample_rate_hz;
    const MatrixXd samples = samples_of(ensemble.record, {channel}, ensemble.begin, ensemble.count);
    const double guess = excitation_guess(samples, rate, entry);
    const double start = tone_near(samples, rate, guess);
    ToneOptions tone;
    tone.harmonics = {1};
    const ToneFit fit = fit_harmonic_tone(samples, rate, start, tone);
    if (fit.ending == SolverEnding::ran_away ||
        std::abs(fit.frequency / guess - 1) > measure_thresholds().largest_detuning)
      throw InputError((campaign_.folder / entry.file).string(), "channel " + campaign_.channels[channel].name,
                       "no steady excitation tone is found in it",
                       "check excitation_frequency_hz and the channel's role");
    o.excitation_frequency.push_back(fit.frequency);
    const double noise = window_.noise_factor(rate);
    o.excitation_frequency_sd.push_back(noise * fit.frequency_sd);
    o.forcing.push_back(2.0 * fit.amplitude(0, 0));
    o.forcing_sd.push_back(2 * noise * fit.amplitude_sd(0, 0));
  }

  // What the excitation holds at the lines of the case's harmonics, beside its own tone.
  void observe_excitation_harmonics(const Ensemble& ensemble, Observation& o) const {
    const double rate = ensemble.record.sample_rate_hz, own = o.excitation_frequency[0];
    const double apart = bins_between_tones * two_pi * rate / static_cast<double>(ensemble.count);
    std::vector<double> lines = {own};
    std::vector<std::ptrdiff_t> of_block(resonance_.blocks.size(), -1);
    for (std::size_t b = 0; b < resonance_.blocks.size(); ++b) {
      if (!(o.harmonic_sd[b] >= 0)) continue;
      const double f = std::abs(block_frequency(resonance_.blocks[b], o));
      const auto near = std::find_if(lines.begin(), lines.end(), [&](double l) { return std::abs(l - f) < apart; });
      if (f < apart || near == lines.begin()) continue;
      of_block[b] = near - lines.begin();
      if (near == lines.end()) lines.push_back(f);
    }
    const Index count = static_cast<Index>(lines.size());
    o.forcing_harmonic.assign(resonance_.blocks.size(), 0);
    o.forcing_harmonic_sd.assign(resonance_.blocks.size(), -1);
    const MatrixXd samples = samples_of(ensemble.record, excitations_, ensemble.begin, ensemble.count);
    if (count == 1 || samples.rows() <= 2 * count + 1) return;
    const RelatedTones tones{Eigen::Map<const VectorXd>(lines.data(), count), MatrixXd(count, 0)};
    const RelatedToneFit fit = fit_related_tones(samples, rate, tones, VectorXd());
    for (std::size_t b = 0; b < resonance_.blocks.size(); ++b) {
      if (of_block[b] < 0) continue;
      const Complex line = 2.0 * fit.amplitude(of_block[b], 0);
      o.forcing_harmonic[b] = block_frequency(resonance_.blocks[b], o) < 0 ? std::conj(line) : line;
      o.forcing_harmonic_sd[b] = 2 * window_.noise_factor(rate) * fit.amplitude_sd(of_block[b], 0);
    }
  }

  // Whether all oscillating modes have frequencies that can be seen apart from the excitation's harmonics.
  bool are_own(const VectorXd& frequencies, const std::vector<double>& excitation, double resolution,
               double nyquist) const {
    for (std::size_t k = 0; k < model_.modes(); ++k) {
      if (!modes_.oscillates[k]) continue;
      const double w = frequencies(static_cast<Index>(k));
      if (w < bins_between_tones * resolution || w > nyquist - bins_between_tones * resolution) return false;
      for (const double e : excitation)
        if (std::abs(w - std::max(1.0, std::round(w / e)) * e) < bins_between_tones * resolution) return false;
    }
    return true;
  }

  // Where the free frequencies are, from the nominal natural frequencies or, without them, the strongest lines.
  VectorXd search_free(const MatrixXd& samples, double rate, const std::vector<double>& excitation,
                       FreeSearch search) const {
    const MatrixXd modal = samples * projection_.matrix.transpose();
    const double resolution = two_pi * rate / static_cast<double>(samples.rows());
    const auto modes = static_cast<Index>(model_.modes());
    VectorXd expected = VectorXd::Zero(modes);
    double lowest = INFINITY;
    for (Index k = 0; k < modes; ++k) {
      if (!modes_.oscillates[static_cast<std::size_t>(k)]) continue;
      expected(k) = model_.nominal[static_cast<std::size_t>(k)];
      if (!std::isfinite(expected(k))) {
        double best = 0;
        for (double w = bins_between_tones * resolution; w < 0.9 * std::numbers::pi * rate; w += 0.5 * resolution) {
          const bool excited = std::any_of(excitation.begin(), excitation.end(), [&](double e) {
            return std::abs(e - w) < bins_between_tones * resolution;
          });
          const double power = excited ? 0 : tone_power(modal.col(k), rate, VectorXd::Constant(1, w));
          if (power > best) {
            best = power;
            expected(k) = w;
          }
        }
      }
      lowest = std::min(lowest, expected(k));
    }
    VectorXd offset = expected;
    for (std::size_t j = 0; j < excitation.size(); ++j)
      offset -= excitation[j] * modes_.forced.col(static_cast<Index>(j));
    for (Index k = 0; k < modes; ++k)
      if (!modes_.oscillates[static_cast<std::size_t>(k)]) offset(k) = 0;
    const VectorXd centre = modes_.coupling.colPivHouseholderQr().solve(offset);
    VectorXd best = centre;
    double highest = -1;
    const bool everywhere = search == FreeSearch::everywhere;
    const double reach = everywhere ? std::numbers::pi * rate : dwell_search_range * lowest;
    if (centre.size() == 1)
      for (double shift = -reach; shift <= reach; shift += 0.25 * resolution) {
        const VectorXd u = centre.array() + shift;
        const VectorXd frequencies = modes_.observed(u, excitation);
        if (everywhere && !are_own(frequencies, excitation, resolution, std::numbers::pi * rate)) continue;
        const double power = tone_power(modal, rate, frequencies);
        if (power > highest) {
          highest = power;
          best = u;
        }
      }
    return best;
  }

  void observe_responses(const MatrixXd& samples, double rate, Observation& o, VectorXd& free) const {
    const ResponseTones tones(model_, resonance_, modes_,
                              {o.excitation_frequency, free, two_pi * rate / static_cast<double>(samples.rows()),
                               std::numbers::pi * rate},
                              window_);
    const RelatedToneFit fit = fit_tones(samples, rate, tones, free);
    free = fit.free;
    observe_modes(tones, fit, o);
    for (Index i = 0; i < free.size(); ++i) o.free_frequency_sd.push_back(fit.free_sd(i));
    observe_blocks(tones, fit, o);
  }

  // Amplitudes of all tones, and the free frequencies, with standard deviations by the noise of the band.
  RelatedToneFit fit_tones(const MatrixXd& samples, double rate, const ResponseTones& tones, VectorXd free) const {
    const double noise = window_.noise_factor(rate);
    const bool related = free.size() > 0;
    VectorXd free_sd;
    if (related) {
      const RelatedToneFit main = fit_related_tones(samples, rate, tones.related(tones.main()), free);
      free = main.free;
      free_sd = noise * main.free_sd;
    }
    RelatedTones list = tones.related(tones.tones().size());
    if (motion_ == DwellMotion::transient) {
      // A slope of an amplitude is what turns it, too: frequencies near the tones' are as good as any.
      if (related) list.fixed += list.coupling * free;
      list.coupling.resize(list.fixed.size(), 0);
      list.varying = static_cast<int>(tones.main());
      list.degree = transient_degree;
    }
    RelatedToneFit fit = fit_related_tones(samples, rate, list, free);
    fit.amplitude_sd *= noise;
    fit.offset_sd *= noise;
    if (list.coupling.cols() > 0) {
      fit.free_sd *= noise;
    } else {
      fit.free = free;
      fit.free_sd = free_sd;
    }
    return fit;
  }

  void observe_modes(const ResponseTones& tones, const RelatedToneFit& fit, Observation& o) const {
    for (std::size_t k = 0; k < model_.modes(); ++k) {
      const std::ptrdiff_t at = tones.mode_index(k);
      const double f = at >= 0 ? tones.tones()[static_cast<std::size_t>(at)].at(fit.free) : 0.0;
      Complex rate_of_mode(0, f), value = 0;
      double sd = 0, frequency_sd = 0;
      if (at >= 0) {
        SlowAmplitude slow{project(projection_, k, fit.amplitude.row(at)), 0, 0};
        if (motion_ == DwellMotion::transient) {
          slow.slope = project(projection_, k, fit.slope.row(at));
          slow.curvature = project(projection_, k, fit.curvature.row(at));
        }
        slow = to_displacement(slow, f, projection_.derivatives);
        value = slow.value;
        rate_of_mode += slow.slope / value;
        sd = project_sd(projection_, k, fit.amplitude_sd.row(at)) / std::pow(f, projection_.derivatives);
        if (fit.free.size() > 0)
          frequency_sd = tones.of_mode(k).coupling.transpose().cwiseProduct(fit.free_sd).norm();
      }
      o.amplitude.push_back(value);
      o.amplitude_sd.push_back(sd);
      o.rate.push_back(rate_of_mode);
      // A locked mode's frame is the excitation's: its frequency error is counted there.
      o.growth_sd.push_back(0);
      o.frequency_sd.push_back(frequency_sd);
    }
  }

  void observe_blocks(const ResponseTones& tones, const RelatedToneFit& fit, Observation& o) const {
    for (std::size_t b = 0; b < resonance_.blocks.size(); ++b) {
      const RegressorBlock& block = resonance_.blocks[b];
      const auto mode = static_cast<std::size_t>(block.mode);
      const std::ptrdiff_t at = tones.block_index(b);
      Complex value = 0;
      double sd = -1;
      if (at >= 0) {
        const double f = tones.tones()[static_cast<std::size_t>(at)].at(fit.free);
        value =
            to_displacement({project(projection_, mode, fit.amplitude.row(at))}, f, projection_.derivatives).value;
        if (tones.reversed(b)) value = std::conj(value);
        sd = project_sd(projection_, mode, fit.amplitude_sd.row(at)) / std::pow(f, projection_.derivatives);
      } else if (is_zero_frequency(block) && projection_.derivatives == 0 && window_.passes(0)) {
        value = project(projection_, mode, fit.offset.transpose().cast<Complex>());
        sd = project_sd(projection_, mode, fit.offset_sd.transpose());
      }
      o.harmonic.push_back(value);
      o.harmonic_sd.push_back(sd);
    }
  }

  // Whether every mode that the case lets oscillate has a tone.
  bool all_seen(const std::vector<Observation>& found) const {
    return std::all_of(found.begin(), found.end(), [&](const Observation& o) {
      for (std::size_t k = 0; k < model_.modes(); ++k)
        if (modes_.oscillates[k] && o.amplitude_sd[k] == 0) return false;
      return true;
    });
  }

  bool at_rest(const std::vector<Observation>& found) const {
    for (std::size_t k = 0; k < model_.modes(); ++k) {
      if (!modes_.oscillates[k]) continue;
      double largest = 0;
      for (const Observation& o : found)
        largest = o.noise_known ? std::max(largest, std::abs(o.amplitude[k]) / o.amplitude_sd[k])
                                : (o.amplitude[k] == Complex() ? largest : INFINITY);
      if (largest < least_amplitude_sd()) return true;
    }
    return false;
  }

  // Relative change of amplitude over the dwell where it is beyond four standard deviations and one percent.
  double largest_drift(const std::vector<Observation>& found) const {
    double drift = 0;
    if (found.size() < 3) return drift;
    for (std::size_t k = 0; k < model_.modes(); ++k) {
      if (!modes_.oscillates[k]) continue;
      const double first = std::abs(found.front().amplitude[k]), last = std::abs(found.back().amplitude[k]);
      const double sd = std::hypot(found.front().amplitude_sd[k], found.back().amplitude_sd[k]);
      if (std::abs(last - first) > measure_thresholds().dwell_drift_sd * sd &&
          std::abs(last - first) > measure_thresholds().dwell_drift * first)
        drift = std::max(drift, std::abs(last - first) / first);
    }
    return drift;
  }

  // Two modes with one free frequency, Omega = omega1 + omega2: gamma = arg(F conj(A1) conj(A2)) stands still
  // (thesis section 6.5); a mode that enters the relation with the other sign enters gamma unconjugated.
  bool locked(const std::vector<Observation>& found) const {
    std::vector<std::size_t> pair;
    for (std::size_t k = 0; k < model_.modes(); ++k)
      if (modes_.oscillates[k]) pair.push_back(k);
    if (modes_.free.size() != 1 || pair.size() != 2 || found.size() < lock_ensembles ||
        model_.excitations.size() != 1)
      return true;
    const int drive = resonance_.relations[model_.modes()];
    const int sign[] = {resonance_.relations[pair[0]] * drive, resonance_.relations[pair[1]] * drive};
    if (std::abs(sign[0]) != 1 || std::abs(sign[1]) != 1) return true;
    Eigen::VectorXcd force(static_cast<Index>(found.size())), first = force, second = force;
    for (std::size_t i = 0; i < found.size(); ++i) {
      const auto at = static_cast<Index>(i);
      force(at) = found[i].forcing[0];
      first(at) = sign[0] < 0 ? found[i].amplitude[pair[0]] : std::conj(found[i].amplitude[pair[0]]);
      second(at) = sign[1] < 0 ? found[i].amplitude[pair[1]] : std::conj(found[i].amplitude[pair[1]]);
    }
    return bispectral_phase(force, first, second, ensemble_layout(force.size(), 1, 0)).locked;
  }

  const Campaign& campaign_;
  const RecordReader& read_;
  const CompiledModel& model_;
  const CompiledCase& resonance_;
  const Window& window_;
  DwellMotion motion_;
  ModalProjection projection_;
  std::vector<std::size_t> excitations_;
  ModeFrequencies modes_;
};

}  // namespace

ObservationSet observe_dwells(const Campaign& campaign, const RecordReader& read_samples,
                              const CompiledModel& model, const CompiledCase& resonance, const Window& window,
                              DwellMotion motion) {
  return DwellObserver(campaign, read_samples, model, resonance, window, motion).run();
}

}  // namespace secular

#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "estimator/identification/modal_projection.hpp"
#include "estimator/identification/observation_set.hpp"
#include "estimator/signal/free_decay.hpp"
#include "estimator/signal/tone_fit.hpp"
#include "input/input_error.hpp"

namespace secular {
namespace {

using Complex = std::complex<double>;
using Eigen::Index;
using Eigen::MatrixXd;

/// Below this many standard deviations a mode counts as at rest.
constexpr double trivial_branch_sd = 8;

/// A window whose residual is this many times that of the quiet ones is not used.
constexpr double disturbed_noise = 2;

/// Independent stretches that a decay is cut into for its error bars.
constexpr double decay_stretches = 12;

MatrixXd samples_of(const Record& record, const std::vector<std::size_t>& channels, Index first, Index count) {
  MatrixXd samples(count, static_cast<Index>(channels.size()));
  for (std::size_t c = 0; c < channels.size(); ++c)
    samples.col(static_cast<Index>(c)) =
        Eigen::Map<const Eigen::VectorXd>(record.channels[channels[c]].data() + first, count);
  return samples;
}

// Samples of the record inside the window.
struct Range {
  Index first = 0, count = 0;
};
Range range_of(const Record& record, const Window& window) {
  const auto samples = static_cast<double>(record.samples());
  const double begin = std::clamp((window.from_s - record.start_s) * record.sample_rate_hz, 0.0, samples);
  const double end = std::clamp((window.to_s - record.start_s) * record.sample_rate_hz + 1, 0.0, samples);
  const auto first = static_cast<Index>(std::ceil(begin - 1e-6));
  return {first, std::max<Index>(0, static_cast<Index>(std::floor(end + 1e-6)) - first)};
}

double frequency_from(std::span<const Ratio> row, const double* natural, std::size_t modes,
                      const std::vector<double>& excitation) {
  double sum = 0;
  for (std::size_t i = 0; i < row.size(); ++i) {
    const double weight = static_cast<double>(row[i].numerator) / row[i].denominator;
    if (weight != 0) sum += weight * (i < modes ? natural[i] : excitation[i - modes]);
  }
  return sum;
}

// Division by the derivative operator of a tone exp(s t).
Complex to_displacement(Complex amplitude, Complex s, int derivatives) {
  for (int d = 0; d < derivatives; ++d) amplitude /= s;
  return amplitude;
}

// Modal value of channel amplitudes, and the standard deviation of its real (or imaginary) part.
Complex project(const ModalProjection& projection, std::size_t mode, const Eigen::RowVectorXcd& amplitudes) {
  return (projection.matrix.row(static_cast<Index>(mode)).cast<Complex>().cwiseProduct(amplitudes)).sum();
}
double project_sd(const ModalProjection& projection, std::size_t mode, const Eigen::RowVectorXd& sds) {
  return projection.matrix.row(static_cast<Index>(mode)).cwiseProduct(sds).norm();
}

class DwellObserver {
 public:
  DwellObserver(const Campaign& campaign, const RecordReader& read_samples, const CompiledModel& model,
                const CompiledCase& resonance, const Window& window)
      : campaign_(campaign),
        read_(read_samples),
        model_(model),
        resonance_(resonance),
        window_(window),
        projection_(modal_projection(campaign, model)),
        excitations_(excitation_channels(campaign, model)) {
    set_.model = &model;
    set_.resonance = &resonance;
    const std::size_t columns = model.modes() + model.excitations.size();
    for (std::size_t k = 0; k < model.modes(); ++k) {
      if (resonance.mode_at_rest[k]) continue;
      for (std::size_t i = 0; i < model.modes(); ++i)
        if (row_of(k, columns)[i].numerator != 0)
          throw InputError(
              campaign.folder.string(), "case " + std::string(resonance.name),
              "mode " + std::string(model.coordinates[k]) + " is not locked to the excitation in this case",
              "dwells are identified where every mode's frequency follows from the excitation's");
    }
  }

  ObservationSet run() {
    int condition = 0;
    for (std::size_t r = 0; r < campaign_.records.size(); ++r) {
      const RecordEntry& entry = campaign_.records[r];
      if (entry.kind != RecordKind::dwell || !matches_pattern(window_.records, entry.file)) continue;
      observe(r, condition++);
    }
    return std::move(set_);
  }

 private:
  std::span<const Ratio> row_of(std::size_t mode, std::size_t columns) const {
    return resonance_.observed_frequency.subspan(mode * columns, columns);
  }

  void observe(std::size_t r, int condition) {
    const RecordEntry& entry = campaign_.records[r];
    const Record record = read_(r);
    const Range range = range_of(record, window_);
    const Index ensemble =
        entry.ensemble_s ? static_cast<Index>(std::lround(*entry.ensemble_s * record.sample_rate_hz)) : range.count;
    if (ensemble < 32 || range.count < ensemble) {
      set_.warnings.push_back(fmt::format("{}: shorter than one ensemble, left out", entry.file));
      return;
    }
    std::vector<Observation> found;
    for (Index begin = range.first; begin + ensemble <= range.first + range.count; begin += ensemble)
      found.push_back(observe_ensemble(record, r, condition, begin, ensemble));
    if (at_rest(found)) {
      set_.warnings.push_back(fmt::format(
          "{}: the motion is on the trivial branch (its amplitude is not above the noise), left out", entry.file));
      return;
    }
    if (const double drift = largest_drift(found); drift > 0) {
      set_.warnings.push_back(
          fmt::format("{}: has not settled (the amplitude changes by {:.1f} % over the dwell), left out",
                      entry.file, 100 * drift));
      return;
    }
    set_.observations.insert(set_.observations.end(), found.begin(), found.end());
  }

  Observation observe_ensemble(const Record& record, std::size_t r, int condition, Index begin, Index count) const {
    const RecordEntry& entry = campaign_.records[r];
    Observation o;
    o.condition = condition;
    o.record = r;
    o.centre_s = record.start_s +
                 (static_cast<double>(begin) + 0.5 * static_cast<double>(count - 1)) / record.sample_rate_hz;
    for (std::size_t j = 0; j < excitations_.size(); ++j) {
      const MatrixXd samples = samples_of(record, {excitations_[j]}, begin, count);
      const double guess = entry.excitation_frequency_hz
                               ? 2 * std::numbers::pi * *entry.excitation_frequency_hz
                               : strongest_frequency(samples.col(0), record.sample_rate_hz);
      const double start = decomposed_frequency(samples.col(0), record.sample_rate_hz, guess);
      ToneOptions tone;
      tone.harmonics = {1};
      ToneFit fit = fit_harmonic_tone(samples, record.sample_rate_hz, start, tone);
      if (fit.status == ToneStatus::ill_conditioned || std::abs(fit.frequency / guess - 1) > 0.2)
        throw InputError(
            (campaign_.folder / entry.file).string(), "channel " + campaign_.channels[excitations_[j]].name,
            "no steady excitation tone is found in it", "check excitation_frequency_hz and the channel's role");
      o.excitation_frequency.push_back(fit.frequency);
      o.excitation_frequency_sd.push_back(fit.frequency_sd);
      o.forcing.push_back(2.0 * fit.amplitude(0, 0));
      o.forcing_sd.push_back(2 * fit.amplitude_sd(0, 0));
    }
    fit_responses(record, begin, count, o);
    return o;
  }

  static double strongest_frequency(const Eigen::Ref<const Eigen::VectorXd>& y, double rate) {
    // Mean distance of upward crossings of the mean: enough as a start for one dominant tone.
    const double mean = y.mean();
    Index first = -1, last = -1, crossings = 0;
    for (Index i = 0; i + 1 < y.size(); ++i)
      if (y(i) < mean && y(i + 1) >= mean) {
        if (first < 0) first = i;
        last = i;
        ++crossings;
      }
    return crossings > 1 ? 2 * std::numbers::pi * rate * static_cast<double>(crossings - 1) /
                               static_cast<double>(last - first)
                         : 2 * std::numbers::pi * rate / static_cast<double>(y.size());
  }

  void fit_responses(const Record& record, Index begin, Index count, Observation& o) const {
    const std::size_t modes = model_.modes(), columns = modes + model_.excitations.size();
    const double resolution = 2 * std::numbers::pi * record.sample_rate_hz / static_cast<double>(count);
    const double nyquist = std::numbers::pi * record.sample_rate_hz;
    std::vector<double> frequencies;
    const auto index_of = [&](double frequency) -> std::ptrdiff_t {
      if (frequency < 2 * resolution || frequency > nyquist - 2 * resolution) return -1;
      for (std::size_t i = 0; i < frequencies.size(); ++i)
        if (std::abs(frequencies[i] - frequency) < 0.5 * resolution) return static_cast<std::ptrdiff_t>(i);
      frequencies.push_back(frequency);
      return static_cast<std::ptrdiff_t>(frequencies.size() - 1);
    };
    std::vector<double> observed(modes);
    std::vector<std::ptrdiff_t> mode_index(modes), block_index;
    for (std::size_t k = 0; k < modes; ++k) {
      observed[k] = resonance_.mode_at_rest[k]
                        ? 0.0
                        : frequency_from(row_of(k, columns), nullptr, modes, o.excitation_frequency);
      mode_index[k] = resonance_.mode_at_rest[k] ? -1 : index_of(observed[k]);
    }
    std::vector<double> block_frequency;
    for (const RegressorBlock& block : resonance_.blocks) {
      double frequency = 0;
      for (std::size_t i = 0; i < block.phase.size(); ++i)
        frequency += block.phase[i] * (i < modes ? observed[i] : o.excitation_frequency[i - modes]);
      block_frequency.push_back(frequency);
      block_index.push_back(block.kind == BlockKind::harmonic ? index_of(frequency) : -1);
    }
    const KnownFrequencyFit fit = known_frequency_components(samples_of(record, projection_.channels, begin, count),
                                                             record.sample_rate_hz, frequencies, true);
    const auto modal = [&](std::size_t mode, std::ptrdiff_t at, double frequency) {
      return to_displacement(project(projection_, mode, fit.amplitude.row(at)), {0, frequency},
                             projection_.derivatives);
    };
    const auto modal_sd = [&](std::size_t mode, std::ptrdiff_t at, double frequency) {
      return project_sd(projection_, mode, fit.amplitude_sd.row(at)) / std::pow(frequency, projection_.derivatives);
    };
    for (std::size_t k = 0; k < modes; ++k) {
      const bool seen = mode_index[k] >= 0;
      o.amplitude.push_back(seen ? modal(k, mode_index[k], observed[k]) : Complex());
      o.amplitude_sd.push_back(seen ? modal_sd(k, mode_index[k], observed[k]) : 0.0);
      o.rate.emplace_back(0, observed[k]);
      // The frame is the excitation's: its frequency error is counted there.
      o.growth_sd.push_back(0);
      o.frequency_sd.push_back(0);
    }
    for (std::size_t b = 0; b < resonance_.blocks.size(); ++b) {
      const auto mode = static_cast<std::size_t>(resonance_.blocks[b].mode);
      const bool seen = block_index[b] >= 0;
      o.harmonic.push_back(seen ? modal(mode, block_index[b], block_frequency[b]) : Complex());
      o.harmonic_sd.push_back(seen ? modal_sd(mode, block_index[b], block_frequency[b]) : -1.0);
    }
  }

  bool at_rest(const std::vector<Observation>& found) const {
    for (std::size_t k = 0; k < model_.modes(); ++k) {
      if (resonance_.mode_at_rest[k]) continue;
      double largest = 0;
      for (const Observation& o : found) largest = std::max(largest, std::abs(o.amplitude[k]) / o.amplitude_sd[k]);
      if (largest < trivial_branch_sd) return true;
    }
    return false;
  }

  // Relative change of amplitude over the dwell where it is beyond four standard deviations and one percent.
  double largest_drift(const std::vector<Observation>& found) const {
    double drift = 0;
    if (found.size() < 3) return drift;
    for (std::size_t k = 0; k < model_.modes(); ++k) {
      if (resonance_.mode_at_rest[k]) continue;
      const double first = std::abs(found.front().amplitude[k]), last = std::abs(found.back().amplitude[k]);
      const double sd = std::hypot(found.front().amplitude_sd[k], found.back().amplitude_sd[k]);
      if (std::abs(last - first) > 4 * sd && std::abs(last - first) > 0.01 * first)
        drift = std::max(drift, std::abs(last - first) / first);
    }
    return drift;
  }

  const Campaign& campaign_;
  const RecordReader& read_;
  const CompiledModel& model_;
  const CompiledCase& resonance_;
  const Window& window_;
  ModalProjection projection_;
  std::vector<std::size_t> excitations_;
  ObservationSet set_;
};

}  // namespace

bool matches_pattern(const std::string& pattern, const std::string& file) {
  // Linear in time with one remembered star.
  std::size_t p = 0, f = 0, star = std::string::npos, resume = 0;
  while (f < file.size()) {
    if (p < pattern.size() && (pattern[p] == '?' || pattern[p] == file[f])) {
      ++p;
      ++f;
    } else if (p < pattern.size() && pattern[p] == '*') {
      star = p++;
      resume = f;
    } else if (star != std::string::npos) {
      p = star + 1;
      f = ++resume;
    } else {
      return false;
    }
  }
  while (p < pattern.size() && pattern[p] == '*') ++p;
  return p == pattern.size();
}

ObservationSet observe_dwells(const Campaign& campaign, const RecordReader& read_samples,
                              const CompiledModel& model, const CompiledCase& resonance, const Window& window) {
  return DwellObserver(campaign, read_samples, model, resonance, window).run();
}

ObservationSet observe_free_decays(const Campaign& campaign, const RecordReader& read_samples,
                                   const CompiledModel& model, const CompiledCase& resonance,
                                   const Window& window) {
  if (model.modes() != 1)
    throw InputError(campaign.folder.string(), "case " + std::string(resonance.name),
                     "free decays of several modes at once are not identified", "use a model of one mode");
  ObservationSet set;
  set.model = &model;
  set.resonance = &resonance;
  const ModalProjection projection = modal_projection(campaign, model);
  int condition = 0;
  for (std::size_t r = 0; r < campaign.records.size(); ++r) {
    const RecordEntry& entry = campaign.records[r];
    const bool decays = entry.kind == RecordKind::free_decay || entry.kind == RecordKind::impact;
    if (!decays || !matches_pattern(window.records, entry.file)) continue;
    const Record record = read_samples(r);
    const Range range = range_of(record, window);
    // The modal filter works on samples as well as on amplitudes.
    const Eigen::VectorXd modal =
        samples_of(record, projection.channels, range.first, range.count) * projection.matrix.row(0).transpose();
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
      o.amplitude.push_back(to_displacement(window_fit.amplitude(0, 0), rate, projection.derivatives));
      o.amplitude_sd.push_back(window_fit.amplitude_sd(0, 0) /
                               std::pow(window_fit.frequency, projection.derivatives));
      o.rate.push_back(rate);
      o.growth_sd.push_back(window_fit.growth_sd);
      o.frequency_sd.push_back(window_fit.frequency_sd);
      for (const RegressorBlock& block : resonance.blocks) {
        const auto harmonic = std::find(options.harmonics.begin(), options.harmonics.end(),
                                        block.kind == BlockKind::harmonic ? block.phase[0] : 0);
        const bool seen = harmonic != options.harmonics.end() && *harmonic > 1;
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

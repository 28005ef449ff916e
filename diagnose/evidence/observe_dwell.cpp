#include "diagnose/evidence/observe_dwell.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>
#include <set>
#include <utility>

#include "diagnose/evidence/dwell_ensembles.hpp"
#include "diagnose/thresholds.hpp"
#include "measure/signal/tone_fit.hpp"
#include "measure/signal/tone_search.hpp"
#include "numerics/distribution.hpp"
#include "numerics/hertz.hpp"

namespace secular {
namespace {

using Complex = std::complex<double>;
using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;

/// A mode moves at a line where its mean amplitude is this many standard deviations.
constexpr auto& present = diagnose_thresholds().present;

/// Fewest ensembles that a scatter is taken from; a longer dwell is cut into this many where it says nothing
/// itself.
constexpr auto& fewest_ensembles = diagnose_thresholds().fewest_ensembles;
constexpr auto& usual_ensembles = diagnose_thresholds().usual_ensembles;

/// An excitation that varies with less than this probability by its noise alone makes its response vary.
constexpr auto& unsteady_excitation = diagnose_thresholds().unsteady_excitation;

/// Excitations are read at these multiples of the first one's frequency.
constexpr int highest_excitation_line = 3;

/// Fewest samples and turns of the slowest line in an ensemble.
constexpr auto& fewest_samples = diagnose_thresholds().ensemble_samples;

/// A dwell whose amplitude drifts by more than this over its length has not settled; one that drifts less, but more
/// than a motion that stands still does by chance in so few cases, is taken with its rate of change.
constexpr auto& largest_drift = diagnose_thresholds().largest_drift;
constexpr auto& drift_alarm = diagnose_thresholds().drift_alarm;

// (dB/dt)/B over the ensembles of a dwell by a straight line through ln(B/mean B); the chance that a motion which
// stands still drifts as much, by the noise of the samples and by the scatter about that line, whichever is larger.
struct AmplitudeDrift {
  Complex rate;
  double sd = 0, p_value = 1;
};

// `noise_sd`: of one ensemble's real part, by the samples' noise; `scatter_sd`: the same about a straight line.
AmplitudeDrift amplitude_drift(const std::vector<Complex>& amplitude, double noise_sd, double scatter_sd,
                               double step_s) {
  const auto n = static_cast<double>(amplitude.size());
  const Complex mean = std::accumulate(amplitude.begin(), amplitude.end(), Complex(0)) / n;
  Complex moment = 0;
  for (std::size_t e = 0; e < amplitude.size(); ++e)
    moment += (static_cast<double>(e) - 0.5 * (n - 1)) * std::log(amplitude[e] / mean);
  const double spread = n * (n * n - 1) / 12;
  AmplitudeDrift drift;
  drift.rate = moment / (spread * step_s);
  const auto sd_of_rate = [&](double sd) { return sd / std::abs(mean) / (std::sqrt(spread) * step_s); };
  drift.sd = sd_of_rate(std::max(noise_sd, scatter_sd));
  // Half the squared ratio of a complex number to its sd is F-distributed on 2 and twice n - 2 degrees.
  const auto f = [&](double sd) { return 0.5 * std::norm(drift.rate) / (sd_of_rate(sd) * sd_of_rate(sd)); };
  const double scattered = f_upper_tail(f(scatter_sd), 2, 2 * (n - 2));
  drift.p_value = std::max(chi_squared_upper_tail(2 * f(noise_sd), 2), scattered);
  return drift;
}

// A pair of lines whose frequencies are only fixed in their combination: the lower one from the samples.
std::optional<double> lower_frequency(const RecordPart& part, double rate, const LineLayout& layout,
                                      const std::vector<double>& natural_frequency, double excitation,
                                      std::size_t responses) {
  const double natural = natural_frequency[layout.resonances[0].mode];
  // Responses without what is locked to the excitation.
  std::vector<double> known;
  for (int n = 1; n <= 3; ++n)
    if (n * excitation < 0.95 * std::numbers::pi * rate) known.push_back(n * excitation);
  MatrixXd samples = part.samples.leftCols(static_cast<Index>(responses));
  const KnownFrequencyFit fit = known_frequency_components(samples, rate, known, true);
  const Eigen::ArrayXd t =
      Eigen::ArrayXd::LinSpaced(samples.rows(), 0, static_cast<double>(samples.rows() - 1)) / rate -
      0.5 * static_cast<double>(samples.rows() - 1) / rate;
  for (Index c = 0; c < samples.cols(); ++c) {
    samples.col(c).array() -= fit.offset(c);
    for (std::size_t i = 0; i < known.size(); ++i) {
      const Complex a = fit.amplitude(static_cast<Index>(i), c);
      samples.col(c).array() -= 2 * (a.real() * (known[i] * t).cos() - a.imag() * (known[i] * t).sin());
    }
  }
  // The stronger of both lines is found first, then both are fitted together through their combination.
  const SpectralPeak peak = spectral_peak(samples, rate, 4, 7);
  if (!(peak.probability < diagnose_thresholds().lower_line_alarm)) return std::nullopt;
  const double high = natural_frequency[layout.resonances[1].mode];
  double low_frequency = std::abs(peak.frequency - natural) < std::abs(peak.frequency - high)
                             ? peak.frequency
                             : (excitation - peak.frequency) * layout.excitation[0];
  if (std::abs(low_frequency / natural - 1) > 0.2) return std::nullopt;
  // Golden-section search of the residual over less than a bin: smooth and with one minimum there.
  const auto left = [&](double w) {
    const std::vector<double> pair = {w, excitation - layout.excitation[0] * w};
    const KnownFrequencyFit tones = known_frequency_components(samples, rate, pair, true);
    double sum = 0;
    for (Index c = 0; c < tones.noise_sd.size(); ++c) sum += std::log(tones.noise_sd(c) + 1e-300);
    return sum;
  };
  const double bin = two_pi * rate / static_cast<double>(samples.rows());
  double a = low_frequency - bin, b = low_frequency + bin;
  constexpr double golden = 0.6180339887498949;
  double x = b - golden * (b - a), y = a + golden * (b - a), fx = left(x), fy = left(y);
  for (int i = 0; i < 40; ++i) {
    if (fx < fy) {
      b = y;
      y = x;
      fy = fx;
      x = b - golden * (b - a);
      fx = left(x);
    } else {
      a = x;
      x = y;
      fx = fy;
      y = a + golden * (b - a);
      fy = left(y);
    }
  }
  low_frequency = 0.5 * (a + b);
  return low_frequency;
}

std::optional<double> excitation_frequency(const RecordPart& part, double rate, std::size_t responses,
                                           const RecordEntry& entry) {
  const auto channel = static_cast<Index>(responses);
  // Of several excitations the nominal frequency may be that of another one.
  const bool is_only = part.samples.cols() == channel + 1;
  const double guess = is_only && entry.excitation_frequency_hz
                           ? two_pi * *entry.excitation_frequency_hz
                           : spectral_peak(part.samples.col(channel), rate, 4, 1).frequency;
  ToneOptions options;
  const ToneFit fit = fit_harmonic_tone(part.samples.col(channel), rate, guess, options);
  if (fit.ending == SolverEnding::ran_away || std::abs(fit.frequency / guess - 1) > 0.1) return std::nullopt;
  if (!(std::abs(fit.amplitude(0, 0)) > present * fit.amplitude_sd(0, 0))) return std::nullopt;
  return fit.frequency;
}

// The multiple of the first excitation's frequency at which each other one has its tone, 1 where it has none. Why
// they make no motion of lines at such multiples; empty where they do.
std::string off_multiples(const RecordPart& part, double rate, std::size_t responses, double omega,
                          std::vector<int>& multiples) {
  multiples.assign(1, 1);
  for (Index c = static_cast<Index>(responses) + 1; c < part.samples.cols(); ++c) {
    const double guess = spectral_peak(part.samples.col(c), rate, 4, 1).frequency;
    const ToneFit fit = fit_harmonic_tone(part.samples.col(c), rate, guess, ToneOptions());
    const bool is_tone =
        fit.ending != SolverEnding::ran_away && std::abs(fit.amplitude(0, 0)) > present * fit.amplitude_sd(0, 0);
    // Phases that part by more than a turn over the record are no multiple's.
    const double multiple = is_tone ? std::round(fit.frequency / omega) : 1,
                 apart = fit.frequency - omega * multiple;
    multiples.push_back(static_cast<int>(multiple));
    if (is_tone && multiple > highest_excitation_line)
      return fmt::format("its excitation at {:.4g} Hz is beyond the {} multiples of {:.4g} Hz that are read",
                         fit.frequency / two_pi, highest_excitation_line, omega / two_pi);
    if (is_tone && std::abs(apart) * static_cast<double>(part.samples.rows()) / rate > two_pi)
      return fmt::format(
          "its excitations at {:.4g} and {:.4g} Hz make lines at sums of both, and a dwell has those at "
          "multiples of one; kind = \"broadband\" compares it sample by sample",
          omega / two_pi, fit.frequency / two_pi);
  }
  return {};
}

// How a dwell's motion varies; nothing where its excitation does.
std::vector<Nonstationarity> nonstationarity_within(const DwellReader& reader, const Condition& c,
                                                    const DwellLines& lines, const SensorModel& sensors) {
  std::vector<double> frequencies;
  for (const Index l : lines.observed)
    if (l != 0) frequencies.push_back(lines.frequency(l));
  const auto channels = static_cast<Index>(sensors.responses.size() + sensors.excitations.size());
  std::map<Index, std::vector<MatrixXcd>> read;  // by line
  const auto through = [&](Index line, const Eigen::RowVectorXd& weights) {
    std::vector<MatrixXcd>& about = read[line];
    if (about.empty()) about = reader.read_about(lines.frequency(line), frequencies);
    MatrixXcd seen(static_cast<Index>(about.size()), about.front().cols());
    for (std::size_t e = 0; e < about.size(); ++e)
      seen.row(static_cast<Index>(e)) = weights.cast<Complex>() * about[e];
    return nonstationarity_of(seen.col(0), seen.rightCols(seen.cols() - 1));
  };
  for (std::size_t j = 0; j < sensors.excitations.size(); ++j) {
    const auto channel = static_cast<Index>(sensors.responses.size() + j);
    const Nonstationarity excitation =
        through(c.tone_of(static_cast<Index>(j)), Eigen::RowVectorXd::Unit(channels, channel));
    if (test_nonstationarity({excitation}).p_value < unsteady_excitation) return {};
  }
  // Where the masters are, and where the excitation drives every mode, near resonance or not.
  std::set<std::pair<Index, std::size_t>> seen;
  for (const MasterLine& master : c.masters) seen.emplace(master.line, master.mode);
  for (std::size_t k = 0; k < static_cast<std::size_t>(sensors.filter.rows()); ++k) seen.emplace(c.fundamental, k);
  std::vector<Nonstationarity> all;
  for (const auto& [line, mode] : seen) {
    Eigen::RowVectorXd weights = Eigen::RowVectorXd::Zero(channels);
    weights.head(static_cast<Index>(sensors.responses.size())) = sensors.filter.row(static_cast<Index>(mode));
    all.push_back(through(line, weights));
    all.back().record = c.record;
  }
  return all;
}

bool is_transient(const std::vector<Nonstationarity>& nonstationarity) {
  bool transient = false;
  for (const Nonstationarity& w : nonstationarity) {
    if (!is_unsteady(w)) continue;
    if (!w.dies_out) return false;
    transient = true;
  }
  return transient;
}

class DwellObserver {
 public:
  DwellObserver(const DwellContext& context, std::size_t index, const Record& record)
      : context_(context),
        index_(index),
        record_(record),
        entry_(context.campaign.records[index]),
        rate_(record.sample_rate_hz),
        responses_(context.sensors.responses.size()) {}

  std::optional<Dwell> observe() {
    if (!read_part()) return std::nullopt;
    const std::optional<Index> length = ensemble_length();
    if (!length) return std::nullopt;
    const DwellReader reader(part_, rate_, responses_, *length);
    for (const LineLayout& layout : possible_layouts(context_.natural_frequency, omega_)) {
      std::optional<DwellLines> lines = lines_of(layout, reader);
      if (!lines) continue;
      std::vector<LineEnsemble> ensembles = reader.read(*lines);
      if (!context_.window.passes(0) || any_wanders(context_.wandering, context_.sensors.responses))
        leave_mean_out(ensembles, *lines);
      align(ensembles, *lines);
      const EnsembleStatistics statistics = statistics_of(ensembles, *lines);
      Dwell dwell = dwell_of(ensembles.size(), *length, statistics);
      Condition& c = dwell.condition;
      const Resonances found = find_masters(ensembles, *lines, reader, statistics, c);
      const bool bound = layout.dimensions == 2 || layout.divisor > 1;
      if (bound && (!found.whole || c.masters.empty())) continue;
      if (found.drift > largest_drift)
        return left_out(fmt::format("it has not settled (its amplitude changes by {:.1f} %)", 100 * found.drift));
      if (found.drift > 0) {  // which is no lack of repeatability
        dwell.response_scatter = statistics.response_about_line;
        dwell.excitation_scatter = statistics.excitation_about_line;
        dwell.degrees_of_freedom -= 1;
      }
      place(c, *lines);
      if (layout.dimensions == 1)
        dwell.nonstationarity = nonstationarity_within(reader, c, *lines, context_.sensors);
      if (is_transient(dwell.nonstationarity)) return left_out("it has not settled (what varies in it dies out)");
      return dwell;
    }
    return left_out("its motion fits no resonance of model " + std::string(context_.model.name));
  }

  // Of a dwell that is not there.
  const std::string& reason() const { return reason_; }

 private:
  /// What the resonances of a layout show.
  struct Resonances {
    bool whole = true;  // every subharmonic or pair of the layout is really there
    double drift = 0;   // largest relative change of an amplitude over the dwell that is not by chance
  };

  std::nullopt_t left_out(std::string reason) {
    reason_ = std::move(reason);
    return std::nullopt;
  }

  // The samples and their excitation's frequency.
  bool read_part() {
    const SensorModel& sensors = context_.sensors;
    const auto fails = [&](std::string reason) {
      reason_ = std::move(reason);
      return false;
    };
    if (sensors.excitations.empty()) return fails("a dwell without an excitation channel");
    std::vector<std::size_t> channels = sensors.responses;
    channels.insert(channels.end(), sensors.excitations.begin(), sensors.excitations.end());
    part_ = part_of(record_, channels, context_.window);
    if (const auto nominal = entry_.excitation_frequency_hz; nominal && !context_.window.passes(two_pi * *nominal))
      return fails(fmt::format("its excitation at {:.4g} Hz is outside of the band", *nominal));
    if (part_.samples.rows() < fewest_ensembles * fewest_samples)
      return fails("too short to be cut into ensembles");
    const auto omega = excitation_frequency(part_, rate_, responses_, entry_);
    if (!omega) return fails("no steady excitation tone is found in it");
    omega_ = *omega;
    if (std::string why = off_multiples(part_, rate_, responses_, omega_, tone_multiples_); !why.empty())
      return fails(std::move(why));
    return true;
  }

  // In samples.
  std::optional<Index> ensemble_length() {
    const Index samples = part_.samples.rows();
    Index length = entry_.ensemble_s ? static_cast<Index>(std::lround(*entry_.ensemble_s * rate_)) : samples;
    length = std::max<Index>(length, fewest_samples);
    if (samples / length < fewest_ensembles) length = samples / usual_ensembles;
    if (length < fewest_samples ||
        static_cast<double>(length) / rate_ * omega_ / two_pi < diagnose_thresholds().ensemble_turns)
      return left_out("too few turns of the excitation in an ensemble");
    return length;
  }

  // Nothing where the samples do not show the layout's frequencies.
  std::optional<DwellLines> lines_of(const LineLayout& layout, const DwellReader& reader) const {
    DwellLines lines;
    lines.layout = layout;
    lines.base = {omega_ / layout.divisor, 0};
    if (layout.dimensions == 2) {
      const auto low = lower_frequency(part_, rate_, layout, context_.natural_frequency, omega_, responses_);
      if (!low) return std::nullopt;
      lines.base = {*low, omega_ - layout.excitation[0] * *low};
      lines.torus = std::make_shared<const Torus>(2, 3, 24);
    } else {
      lines.torus = torus_of_turns(layout.divisor);
    }
    lines.fundamental = *lines.torus->find(layout.excitation);
    lines.observed = reader.observable(lines, context_.window);
    lines.excitation = {0};
    for (int n = 1; n <= highest_excitation_line; ++n) {
      const auto line = lines.torus->find({n * layout.excitation[0], n * layout.excitation[1]});
      if (line && lines.observes(*line)) lines.excitation.push_back(*line);
    }
    if (!lines.observes(lines.fundamental)) return std::nullopt;
    for (const int n : tone_multiples_)
      if (n > 1 && lines.own_line.empty()) lines.own_line.resize(tone_multiples_.size(), lines.fundamental);
    for (std::size_t j = 0; j < lines.own_line.size(); ++j) {
      const auto line =
          lines.torus->find({tone_multiples_[j] * layout.excitation[0], tone_multiples_[j] * layout.excitation[1]});
      if (!line || !lines.observes(*line)) return std::nullopt;
      lines.own_line[j] = *line;
    }
    return lines;
  }

  static Dwell dwell_of(std::size_t ensembles, Index length, const EnsembleStatistics& statistics) {
    Dwell dwell;
    dwell.condition.response = statistics.response;
    dwell.condition.excitation = statistics.excitation;
    dwell.condition.samples = static_cast<Index>(ensembles) * length;
    dwell.ensembles = ensembles;
    dwell.degrees_of_freedom = static_cast<double>(ensembles - 1);
    dwell.response_scatter = statistics.response_scatter;
    dwell.excitation_scatter = statistics.excitation_scatter;
    dwell.noise = statistics.noise;
    return dwell;
  }

  // Notes in the condition which modes move at their lines, how their amplitudes drift, and which are at rest.
  Resonances find_masters(const std::vector<LineEnsemble>& ensembles, const DwellLines& lines,
                          const DwellReader& reader, const EnsembleStatistics& statistics, Condition& c) const {
    const Eigen::RowVectorXd line_noise =  // of a real part of half the peak
        context_.window.noise_factor(rate_) * statistics.noise.head(c.response.rows()).transpose() /
        std::sqrt(2 * static_cast<double>(reader.length()));
    Resonances found;
    for (const LineLayout::Resonance& resonance : lines.layout.resonances) {
      const auto line = lines.torus->find(resonance.line);
      if (!line || !lines.observes(*line)) continue;
      const Index column = lines.column(*line);
      const Eigen::RowVectorXd weights = context_.sensors.filter.row(static_cast<Index>(resonance.mode));
      const auto modal = [&](const MatrixXcd& response) {
        return (weights.cast<Complex>() * response.col(column))(0);
      };
      const auto sd_of = [&](const MatrixXd& scatter) {
        return weights.cwiseProduct(scatter.col(column).transpose()).norm();
      };
      const double sd = sd_of(statistics.response_scatter);
      const double amplitude = std::abs(modal(c.response));
      const bool moves = amplitude > present * sd / std::sqrt(static_cast<double>(ensembles.size()));
      if (!moves) {
        found.whole = false;
        c.resting.push_back({resonance.mode, *line});
        continue;
      }
      c.masters.push_back({resonance.mode, *line});
      std::vector<Complex> amplitudes;
      for (const LineEnsemble& e : ensembles) amplitudes.push_back(modal(e.response));
      const AmplitudeDrift drift = amplitude_drift(amplitudes, weights.cwiseProduct(line_noise).norm(),
                                                   sd_of(statistics.response_about_line), reader.duration_s());
      const bool drifts = drift.p_value < drift_alarm;
      if (drifts)
        found.drift =
            std::max(found.drift, std::abs(drift.rate) * static_cast<double>(part_.samples.rows()) / rate_);
      c.amplitude_drift_rate.push_back(drifts ? drift.rate : Complex());
      c.amplitude_drift_rate_sd.push_back(drifts ? drift.sd : 0);
    }
    return found;
  }

  // What a condition says of the record and the lines that it comes from.
  void place(Condition& c, const DwellLines& lines) const {
    c.record = index_;
    c.fold = static_cast<int>(index_);
    c.time_s = part_.start_s - record_.start_s + 0.5 * static_cast<double>(part_.samples.rows()) / rate_;
    c.torus = lines.torus;
    c.rate = {Complex(0, lines.base[0]), Complex(0, lines.base[1])};
    c.fundamental = lines.fundamental;
    c.own_line = lines.own_line;
    c.lines = lines.observed;
    c.excitation_lines = lines.excitation;
  }

  const DwellContext& context_;
  std::size_t index_;
  const Record& record_;
  const RecordEntry& entry_;
  double rate_;
  std::size_t responses_;
  RecordPart part_;
  double omega_ = 0;
  std::vector<int> tone_multiples_;  // [excitation channel] of omega_
  std::string reason_;
};

}  // namespace

std::optional<Dwell> observe_dwell(const DwellContext& context, std::size_t index, const Record& record,
                                   std::vector<std::string>& warnings) {
  DwellObserver observer(context, index, record);
  std::optional<Dwell> dwell = observer.observe();
  if (!dwell) warnings.push_back(context.campaign.records[index].file + ": " + observer.reason() + ", left out");
  return dwell;
}

}  // namespace secular

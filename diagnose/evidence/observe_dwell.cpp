#include "diagnose/evidence/observe_dwell.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>
#include <set>
#include <utility>

#include "diagnose/evidence/record_window.hpp"
#include "diagnose/evidence/resonant_lines.hpp"
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
constexpr double present = 6;

/// Fewest ensembles that a scatter is taken from; a longer dwell is cut into this many where it says nothing
/// itself.
constexpr Index fewest_ensembles = 4, usual_ensembles = 8;

/// Noise beside a line is read at these distances from it, in frequency resolutions of an ensemble, on both sides.
constexpr double beside[] = {3.5, 4.5, 5.5, 6.5};

/// An excitation that varies with less than this probability by its noise alone makes its response vary.
constexpr double unsteady_excitation = 1e-3;

/// Fewest samples and turns of the slowest line in an ensemble.
constexpr Index fewest_samples = 64;

/// A dwell whose amplitude drifts by more than this over its length has not settled; one that drifts less, but more
/// than a motion that stands still does by chance in so few cases, is taken with its rate of change.
constexpr double largest_drift = 0.05, drift_alarm = 2e-3;

/// Points over a turn of a motion that is a multiple of one frequency. An odd number: the corners of a force that
/// is odd in the motion fall on twice as many places, and alias half as far from the lines that are looked at.
constexpr Index turn_points = 255;

struct Ensemble {
  MatrixXcd response;     // channel x observed line
  MatrixXcd excitation;   // channel x excitation line
  Eigen::VectorXd noise;  // of a sample: responses, then excitations
};

class DwellReader {
 public:
  DwellReader(const RecordPart& part, double rate, std::size_t responses, Index length)
      : part_(part), rate_(rate), responses_(static_cast<Index>(responses)), length_(length) {}

  Index ensembles() const { return part_.samples.rows() / length_; }

  // Frequencies (rad/s) of the lines on a torus that these samples can tell apart, the mean first.
  static std::vector<Index> observable(const Torus& torus, const std::array<double, 2>& base, double resolution,
                                       double nyquist, const Window& window) {
    std::vector<Index> lines = {0};
    std::vector<double> taken = {0};
    // Low orders first: where two lines fall together the simpler one is meant.
    std::vector<Index> order;
    for (Index l = 1; l < torus.lines(); ++l) order.push_back(l);
    std::stable_sort(order.begin(), order.end(), [&](Index a, Index b) {
      const auto size = [&](Index l) { return std::abs(torus.phase(l)[0]) + std::abs(torus.phase(l)[1]); };
      return size(a) < size(b);
    });
    for (const Index l : order) {
      const double frequency = frequency_of(torus, l, base);
      const bool separate = std::all_of(taken.begin(), taken.end(), [&](double other) {
        return std::abs(frequency - other) > 2 * resolution && std::abs(frequency + other) > 2 * resolution;
      });
      if (!separate || std::abs(frequency) > nyquist - 2 * resolution || !window.passes(std::abs(frequency)))
        continue;
      lines.push_back(l);
      taken.push_back(frequency);
    }
    std::sort(lines.begin(), lines.end());
    return lines;
  }

  static double frequency_of(const Torus& torus, Index line, const std::array<double, 2>& base) {
    return torus.phase(line)[0] * base[0] + torus.phase(line)[1] * base[1];
  }

  // For every ensemble the channels' amplitudes on a line, by the clock, and at frequencies beside it that no line
  // is near. `lines`: frequencies of all.
  std::vector<MatrixXcd> read_about(double line, const std::vector<double>& lines, double resolution) const {
    std::vector<double> frequencies = {line};
    for (const double other : lines)
      if (other != line) frequencies.push_back(other);
    const std::size_t known = frequencies.size();
    for (const double distance : beside)
      for (const int side : {-1, 1}) {
        const double w = line + side * distance * resolution;
        const bool free = std::all_of(lines.begin(), lines.end(),
                                      [&](double other) { return std::abs(w - other) > 2.5 * resolution; });
        if (free && w > 2.5 * resolution && w < std::numbers::pi * rate_ - 2.5 * resolution)
          frequencies.push_back(w);
      }
    const auto count = static_cast<Index>(frequencies.size() - known);
    std::vector<MatrixXcd> all;
    for (Index e = 0; e < ensembles(); ++e) {
      const KnownFrequencyFit fit =
          known_frequency_components(part_.samples.middleRows(e * length_, length_), rate_, frequencies, true);
      MatrixXcd about(part_.samples.cols(), 1 + count);
      about.col(0) =
          fit.amplitude.row(0).transpose() * std::polar(1.0, -line * static_cast<double>(e * length_) / rate_);
      about.rightCols(count) = fit.amplitude.bottomRows(count).transpose();
      all.push_back(std::move(about));
    }
    return all;
  }

  // Every ensemble's lines, phases at the dwell's first sample.
  std::vector<Ensemble> read(const Torus& torus, const std::vector<Index>& lines,
                             const std::vector<Index>& excitation_lines, const std::array<double, 2>& base) const {
    std::vector<double> frequencies;
    for (const Index l : lines)
      if (l != 0) frequencies.push_back(std::abs(frequency_of(torus, l, base)));
    std::vector<Ensemble> all;
    for (Index e = 0; e < ensembles(); ++e) {
      const KnownFrequencyFit fit =
          known_frequency_components(part_.samples.middleRows(e * length_, length_), rate_, frequencies, true);
      const double centre = (static_cast<double>(e * length_) + 0.5 * static_cast<double>(length_ - 1)) / rate_;
      MatrixXcd values(part_.samples.cols(), static_cast<Index>(lines.size()));
      Index next = 0;
      for (std::size_t i = 0; i < lines.size(); ++i) {
        const auto column = static_cast<Index>(i);
        if (lines[i] == 0) {
          values.col(column) = fit.offset.cast<Complex>();
          continue;
        }
        const double w = frequency_of(torus, lines[i], base);
        Eigen::VectorXcd amplitude = fit.amplitude.row(next++).transpose();
        if (w < 0) amplitude = amplitude.conjugate().eval();
        values.col(column) = amplitude * std::polar(1.0, -w * centre);
      }
      Ensemble ensemble;
      ensemble.noise = fit.noise_sd;
      ensemble.response = values.topRows(responses_);
      ensemble.excitation.resize(values.rows() - responses_, static_cast<Index>(excitation_lines.size()));
      for (std::size_t i = 0; i < excitation_lines.size(); ++i) {
        const auto found = std::find(lines.begin(), lines.end(), excitation_lines[i]) - lines.begin();
        ensemble.excitation.col(static_cast<Index>(i)) = values.col(found).tail(ensemble.excitation.rows());
      }
      all.push_back(std::move(ensemble));
    }
    return all;
  }

 private:
  const RecordPart& part_;
  double rate_;
  Index responses_, length_;
};

// Turns an ensemble's base phases by `angle`.
void turn_phases(Ensemble& ensemble, const Torus& torus, const std::vector<Index>& lines,
                 const std::vector<Index>& excitation_lines, const std::array<double, 2>& angle) {
  const auto factor = [&](Index line) {
    return std::polar(1.0, torus.phase(line)[0] * angle[0] + torus.phase(line)[1] * angle[1]);
  };
  for (std::size_t i = 0; i < lines.size(); ++i) ensemble.response.col(static_cast<Index>(i)) *= factor(lines[i]);
  for (std::size_t i = 0; i < excitation_lines.size(); ++i)
    ensemble.excitation.col(static_cast<Index>(i)) *= factor(excitation_lines[i]);
}

// The responses' mean, the first of `lines`, where a band has taken it away.
void leave_mean_out(std::vector<Ensemble>& ensembles, std::vector<Index>& lines) {
  lines.erase(lines.begin());
  for (Ensemble& ensemble : ensembles)
    ensemble.response = ensemble.response.rightCols(ensemble.response.cols() - 1).eval();
}

std::size_t place(const std::vector<Index>& lines, Index line) {
  return static_cast<std::size_t>(std::find(lines.begin(), lines.end(), line) - lines.begin());
}

// Brings every ensemble to the same phases: the excitation's fundamental real and positive, and where that leaves a
// choice, as close to the first ensemble as it can be.
void align(std::vector<Ensemble>& ensembles, const Torus& torus, const LineLayout& layout,
           const std::vector<Index>& lines, const std::vector<Index>& excitation_lines, Index fundamental) {
  const auto excitation_column = static_cast<Index>(place(excitation_lines, fundamental));
  for (Ensemble& ensemble : ensembles) {
    const double phase = ensemble.excitation.rows() > 0 ? std::arg(ensemble.excitation(0, excitation_column)) : 0;
    if (layout.dimensions == 1) {
      turn_phases(ensemble, torus, lines, excitation_lines, {-phase / layout.divisor, 0});
      if (layout.divisor == 1) continue;
      int best = 0;
      double agreement = -INFINITY;
      for (int j = 0; j < layout.divisor; ++j) {
        Ensemble turned = ensemble;
        turn_phases(turned, torus, lines, excitation_lines, {two_pi * j / layout.divisor, 0});
        const double likeness = turned.response.conjugate().cwiseProduct(ensembles.front().response).sum().real();
        if (likeness > agreement) {
          agreement = likeness;
          best = j;
        }
      }
      if (&ensemble != &ensembles.front())
        turn_phases(ensemble, torus, lines, excitation_lines, {two_pi * best / layout.divisor, 0});
      continue;
    }
    // The line {1,0} real on the channel that sees it most; {0,1} then follows from the excitation's phase.
    const auto column = static_cast<Index>(place(lines, *torus.find({1, 0})));
    Index channel = 0;
    ensembles.front().response.col(column).cwiseAbs().maxCoeff(&channel);
    const double first = -std::arg(ensemble.response(channel, column));
    turn_phases(ensemble, torus, lines, excitation_lines, {first, -phase - layout.excitation[0] * first});
  }
}

MatrixXcd mean_of(const std::vector<Ensemble>& ensembles, MatrixXcd Ensemble::*part) {
  MatrixXcd sum = ensembles.front().*part;
  for (std::size_t e = 1; e < ensembles.size(); ++e) sum += ensembles[e].*part;
  return sum / static_cast<double>(ensembles.size());
}

enum class About { mean, straight_line };

// One ensemble's standard deviation of a real part about the mean of all or about a straight line in time.
MatrixXd scatter_of(const std::vector<Ensemble>& ensembles, MatrixXcd Ensemble::*part, const MatrixXcd& mean,
                    About about, const std::vector<Index>& lines) {
  const auto count = static_cast<double>(ensembles.size());
  MatrixXcd slope = MatrixXcd::Zero(mean.rows(), mean.cols());
  const auto time = [&](std::size_t e) { return static_cast<double>(e) - 0.5 * (count - 1); };
  if (about == About::straight_line)
    for (std::size_t e = 0; e < ensembles.size(); ++e)
      slope += time(e) / (count * (count * count - 1) / 12) * (ensembles[e].*part);
  MatrixXd sum = MatrixXd::Zero(mean.rows(), mean.cols());
  for (std::size_t e = 0; e < ensembles.size(); ++e)
    sum += (ensembles[e].*part - mean - time(e) * slope).cwiseAbs2();
  sum /= count - (about == About::mean ? 1 : 2);
  for (std::size_t l = 0; l < lines.size(); ++l)
    if (lines[l] != 0) sum.col(static_cast<Index>(l)) /= 2;  // of a real part
  return sum.cwiseSqrt();
}

Eigen::VectorXd noise_of(const std::vector<Ensemble>& ensembles) {
  Eigen::VectorXd squares = Eigen::VectorXd::Zero(ensembles.front().noise.size());
  for (const Ensemble& e : ensembles) squares += e.noise.cwiseAbs2();
  return (squares / static_cast<double>(ensembles.size())).cwiseSqrt();
}

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
  if (!(peak.probability < 1e-6)) return std::nullopt;
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
  const double guess = entry.excitation_frequency_hz
                           ? two_pi * *entry.excitation_frequency_hz
                           : spectral_peak(part.samples.col(channel), rate, 4, 1).frequency;
  ToneOptions options;
  const ToneFit fit = fit_harmonic_tone(part.samples.col(channel), rate, guess, options);
  if (fit.status == ToneStatus::ill_conditioned || std::abs(fit.frequency / guess - 1) > 0.1) return std::nullopt;
  if (!(std::abs(fit.amplitude(0, 0)) > present * fit.amplitude_sd(0, 0))) return std::nullopt;
  return fit.frequency;
}

// How a dwell's motion varies; nothing where its excitation does.
std::vector<Nonstationarity> nonstationarity_within(const DwellReader& reader, const Condition& c,
                                                    const std::vector<Index>& lines,
                                                    const std::array<double, 2>& base, double resolution,
                                                    const Torus& torus, const SensorModel& sensors) {
  std::vector<double> frequencies;
  for (const Index l : lines)
    if (l != 0) frequencies.push_back(DwellReader::frequency_of(torus, l, base));
  const auto channels = static_cast<Index>(sensors.responses.size() + sensors.excitations.size());
  std::map<Index, std::vector<MatrixXcd>> read;  // by line
  const auto through = [&](Index line, const Eigen::RowVectorXd& weights) {
    std::vector<MatrixXcd>& about = read[line];
    if (about.empty())
      about = reader.read_about(DwellReader::frequency_of(torus, line, base), frequencies, resolution);
    MatrixXcd seen(static_cast<Index>(about.size()), about.front().cols());
    for (std::size_t e = 0; e < about.size(); ++e)
      seen.row(static_cast<Index>(e)) = weights.cast<Complex>() * about[e];
    return nonstationarity_of(seen.col(0), seen.rightCols(seen.cols() - 1));
  };
  for (std::size_t j = 0; j < sensors.excitations.size(); ++j) {
    const auto channel = static_cast<Index>(sensors.responses.size() + j);
    const Nonstationarity excitation = through(c.fundamental, Eigen::RowVectorXd::Unit(channels, channel));
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

}  // namespace

std::optional<Dwell> observe_dwell(const Campaign& campaign, std::size_t index, const Record& record,
                                   const CompiledModel& model, const SensorModel& sensors,
                                   const std::vector<double>& natural_frequency, const Window& window,
                                   std::vector<std::string>& warnings) {
  const RecordEntry& entry = campaign.records[index];
  const auto leave_out = [&](const std::string& reason) {
    warnings.push_back(entry.file + ": " + reason + ", left out");
    return std::nullopt;
  };
  if (sensors.excitations.empty()) return leave_out("a dwell without an excitation channel");
  std::vector<std::size_t> channels = sensors.responses;
  channels.insert(channels.end(), sensors.excitations.begin(), sensors.excitations.end());
  const RecordPart part = part_of(record, channels, window);
  const double rate = record.sample_rate_hz;
  if (const auto nominal = entry.excitation_frequency_hz; nominal && !window.passes(two_pi * *nominal))
    return leave_out(fmt::format("its excitation at {:.4g} Hz is outside of the band", *nominal));
  if (part.samples.rows() < fewest_ensembles * fewest_samples)
    return leave_out("too short to be cut into ensembles");
  const auto omega = excitation_frequency(part, rate, sensors.responses.size(), entry);
  if (!omega) return leave_out("no steady excitation tone is found in it");

  Index length = entry.ensemble_s ? static_cast<Index>(std::lround(*entry.ensemble_s * rate)) : part.samples.rows();
  length = std::max<Index>(length, fewest_samples);
  if (part.samples.rows() / length < fewest_ensembles) length = part.samples.rows() / usual_ensembles;
  if (length < fewest_samples || static_cast<double>(length) / rate * *omega / two_pi < 12)
    return leave_out("too few turns of the excitation in an ensemble");
  const DwellReader reader(part, rate, sensors.responses.size(), length);
  const double resolution = two_pi * rate / static_cast<double>(length), nyquist = std::numbers::pi * rate;

  for (const LineLayout& layout : possible_layouts(natural_frequency, *omega)) {
    std::array<double, 2> base = {*omega / layout.divisor, 0};
    std::shared_ptr<const Torus> torus;
    if (layout.dimensions == 2) {
      const auto low = lower_frequency(part, rate, layout, natural_frequency, *omega, sensors.responses.size());
      if (!low) continue;
      base = {*low, *omega - layout.excitation[0] * *low};
      torus = std::make_shared<const Torus>(2, 3, 24);
    } else {
      torus = std::make_shared<const Torus>(1, std::max(6, 4 * layout.divisor), turn_points);
    }
    const Index fundamental = *torus->find(layout.excitation);
    std::vector<Index> lines = DwellReader::observable(*torus, base, resolution, nyquist, window);
    std::vector<Index> excitation_lines = {0};
    for (int n = 1; n <= 3; ++n) {
      const auto line = torus->find({n * layout.excitation[0], n * layout.excitation[1]});
      if (line && std::find(lines.begin(), lines.end(), *line) != lines.end()) excitation_lines.push_back(*line);
    }
    if (std::find(lines.begin(), lines.end(), fundamental) == lines.end()) continue;
    std::vector<Ensemble> ensembles = reader.read(*torus, lines, excitation_lines, base);
    if (!window.passes(0)) leave_mean_out(ensembles, lines);
    align(ensembles, *torus, layout, lines, excitation_lines, fundamental);

    Dwell dwell;
    Condition& c = dwell.condition;
    c.response = mean_of(ensembles, &Ensemble::response);
    c.excitation = mean_of(ensembles, &Ensemble::excitation);
    dwell.ensembles = ensembles.size();
    c.samples = static_cast<Index>(ensembles.size()) * length;
    dwell.degrees_of_freedom = static_cast<double>(ensembles.size() - 1);
    dwell.response_scatter = scatter_of(ensembles, &Ensemble::response, c.response, About::mean, lines);
    dwell.excitation_scatter =
        scatter_of(ensembles, &Ensemble::excitation, c.excitation, About::mean, excitation_lines);
    dwell.noise = noise_of(ensembles);
    const MatrixXd about_line = scatter_of(ensembles, &Ensemble::response, c.response, About::straight_line, lines);
    const Eigen::RowVectorXd line_noise =  // of a real part of half the peak
        window.noise_factor(rate) * dwell.noise.head(c.response.rows()).transpose() /
        std::sqrt(2 * static_cast<double>(length));

    bool whole = true;  // every subharmonic or pair of the layout is really there
    double drift = 0;
    for (const LineLayout::Resonance& resonance : layout.resonances) {
      const auto line = torus->find(resonance.line);
      if (!line || std::find(lines.begin(), lines.end(), *line) == lines.end()) continue;
      const auto column = static_cast<Index>(place(lines, *line));
      const Eigen::RowVectorXd weights = sensors.filter.row(static_cast<Index>(resonance.mode));
      const auto modal = [&](const MatrixXcd& response) {
        return (weights.cast<Complex>() * response.col(column))(0);
      };
      const double sd = weights.cwiseProduct(dwell.response_scatter.col(column).transpose()).norm();
      const double amplitude = std::abs(modal(c.response));
      const bool moves = amplitude > present * sd / std::sqrt(static_cast<double>(dwell.ensembles));
      if (!moves) {
        whole = false;
        c.resting.push_back({resonance.mode, *line});
        continue;
      }
      c.masters.push_back({resonance.mode, *line});
      std::vector<Complex> amplitudes;
      for (const Ensemble& e : ensembles) amplitudes.push_back(modal(e.response));
      const AmplitudeDrift found = amplitude_drift(amplitudes, weights.cwiseProduct(line_noise).norm(),
                                                   weights.cwiseProduct(about_line.col(column).transpose()).norm(),
                                                   static_cast<double>(length) / rate);
      const double change = std::abs(found.rate) * static_cast<double>(part.samples.rows()) / rate;
      if (found.p_value < drift_alarm) {
        drift = std::max(drift, change);
        c.drift_rate.push_back(found.rate);
        c.drift_rate_sd.push_back(found.sd);
      } else {
        c.drift_rate.emplace_back();
        c.drift_rate_sd.push_back(0);
      }
    }
    const bool bound = layout.dimensions == 2 || layout.divisor > 1;
    if (bound && (!whole || c.masters.empty())) continue;
    if (drift > largest_drift)
      return leave_out(fmt::format("it has not settled (its amplitude changes by {:.1f} %)", 100 * drift));

    if (drift > 0) {  // which is no lack of repeatability
      dwell.response_scatter = about_line;
      dwell.excitation_scatter =
          scatter_of(ensembles, &Ensemble::excitation, c.excitation, About::straight_line, excitation_lines);
      dwell.degrees_of_freedom -= 1;
    }
    c.record = index;
    c.fold = static_cast<int>(index);
    c.time_s = part.start_s - record.start_s + 0.5 * static_cast<double>(part.samples.rows()) / rate;
    c.torus = torus;
    c.rate = {Complex(0, base[0]), Complex(0, base[1])};
    c.fundamental = fundamental;
    c.lines = lines;
    c.excitation_lines = excitation_lines;
    if (layout.dimensions == 1)
      dwell.nonstationarity = nonstationarity_within(reader, c, lines, base, resolution, *torus, sensors);
    if (is_transient(dwell.nonstationarity)) return leave_out("it has not settled (what varies in it dies out)");
    return dwell;
  }
  return leave_out("its motion fits no resonance of model " + std::string(model.name));
}

}  // namespace secular

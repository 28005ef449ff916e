#include "motion/correction/replay.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>

#include "input/numerical_failure.hpp"
#include "measure/observe/decay_window.hpp"
#include "measure/observe/modal_projection.hpp"
#include "motion/correction/mean_motion.hpp"
#include "motion/correction/oscillation_state.hpp"
#include "motion/simulate/motion.hpp"
#include "numerics/hertz.hpp"
#include "numerics/in_parallel.hpp"

namespace secular {
namespace {

using Complex = std::complex<double>;

/// Radians of the fastest mode from sample to sample beyond which a method whose steps end at the samples is faster
/// than one with dense output.
constexpr double dense_samples = 0.157;

/// Of a row of a table, in place of samples that were measured: enough for lines up to a fifth of the rate, and for
/// a resolution that parts the third of an excitation's frequency from its neighbours by more than ten bins.
constexpr double samples_of_a_turn = 64, turns_of_a_row = 64;

/// For each thread; ensembles and stretches are short.
constexpr std::size_t records_ahead = 16;

/// A stretch of a decay is started again until its first window is met to this, relative.
constexpr int start_steps = 4;
constexpr double start_tolerance = 1e-4;
/// A start from which it runs away returns so far towards one from which it does not, so often.
constexpr double return_share = 0.9;
constexpr int start_returns = 12;

OscillationState between(const OscillationState& a, const OscillationState& b, double share) {
  OscillationState state = a;
  for (std::size_t k = 0; k < state.displacement.size(); ++k) {
    state.displacement[k] += share * (b.displacement[k] - a.displacement[k]);
    state.velocity[k] += share * (b.velocity[k] - a.velocity[k]);
  }
  return state;
}

class Replay {
 public:
  Replay(const Campaign& campaign, const ObservationSet& measured, const Eigen::VectorXd& parameters)
      : campaign_(campaign),
        measured_(measured),
        model_(*measured.model),
        parameters_(parameters),
        states_(model_, *measured.resonance),
        decay_windows_(campaign, model_, *measured.resonance, Window{}) {
    if (campaign.modal_basis)
      for (const std::vector<double>& row : campaign.modal_basis->mass_normalised_shapes) shapes_.push_back(row);
    if (measured.resonance->excited) excitations_ = excitation_channels(campaign, model_);
  }

  Record record(std::span<const Observation> observations, std::size_t index) const {
    return measured_.resonance->excited ? dwell(mean_motion(observations, model_, *measured_.resonance), index)
                                        : decay(observations.front(), observations.back(), index);
  }

 private:
  MotionSettings settings(const Observation& o, std::size_t index) const {
    MotionSettings s;
    double fastest = 0;
    for (const std::size_t k : decay_windows_.oscillating()) fastest = std::max(fastest, o.rate[k].imag());
    if (fastest > dense_samples * rate_of(o, index)) s.method = Integrator::dormand_prince_87;
    s.label = fmt::format("{}, replayed with the estimated parameters", campaign_.records[index].file);
    s.relative_tolerance = 1e-9;
    return s;
  }

  // Rows of tables have no samples of their own.
  double rate_of(const Observation& o, std::size_t index) const {
    return campaign_.records[index].row ? samples_of_a_turn * o.excitation_frequency[0] / two_pi
                                        : campaign_.sample_rate_hz;
  }

  Record empty(std::size_t samples, double start, double rate) const {
    Record r;
    r.start_s = start;
    r.sample_rate_hz = rate;
    r.channels.assign(campaign_.channels.size(), std::vector<double>(samples, 0.0));
    return r;
  }

  void store(const MotionSample& sample, std::size_t i, Record& record) const {
    const ModalProjection& projection = decay_windows_.projection();
    const std::vector<double>& modal = projection.derivatives == 2   ? sample.acceleration
                                       : projection.derivatives == 1 ? sample.velocity
                                                                     : sample.displacement;
    for (std::size_t c = 0; c < projection.channels.size(); ++c) {
      double value = 0;
      for (std::size_t k = 0; k < modal.size(); ++k)
        value += (campaign_.modal_basis ? shapes_[c][mode_column(k)] : (c == k ? 1.0 : 0.0)) * modal[k];
      record.channels[projection.channels[c]][i] = value;
    }
  }

  std::size_t mode_column(std::size_t k) const {
    const std::vector<std::string>& modes = campaign_.modal_basis->modes;
    return static_cast<std::size_t>(std::find(modes.begin(), modes.end(), model_.coordinates[k]) - modes.begin());
  }

  Record dwell(const Observation& o, std::size_t index) const {
    const double rate = rate_of(o, index);
    const double turns = campaign_.records[index].row ? turns_of_a_row : 200;
    const auto count = static_cast<std::size_t>(std::lround(
        campaign_.records[index].ensemble_s.value_or(turns * two_pi / o.excitation_frequency[0]) * rate));
    const ExcitationSignal signal = [&](double t, ExcitationSample* s) {
      for (std::size_t j = 0; j < o.forcing.size(); ++j) {
        const double w = o.excitation_frequency[j];
        const Complex wave = o.forcing[j] * std::polar(1.0, w * t);
        s[j] = {wave.real(), -w * wave.imag(), -w * w * wave.real()};
      }
    };
    const double begin = -0.5 * static_cast<double>(count - 1) / rate;  // phases count from the centre
    const OscillationState state = states_.at(parameters_, o, begin);
    MotionState moving{state.displacement, state.velocity};
    Record record = empty(count, 0, rate);
    std::size_t i = 0;
    integrate_motion({model_, parameters_.data(), signal}, {begin, begin, 1 / rate, count}, settings(o, index),
                     moving, [&](const MotionSample& sample) { store(sample, i++, record); });
    ExcitationSample sample[8];
    for (std::size_t n = 0; n < count; ++n) {
      signal(begin + static_cast<double>(n) / rate, sample);
      for (std::size_t j = 0; j < excitations_.size(); ++j) record.channels[excitations_[j]][n] = sample[j].value;
    }
    return record;
  }

  // From the first window's begin to the last one's end, started so that the first window shows what was measured
  // in it. A free decay has as many initial values as its modes have amplitudes and phases: nothing has to settle.
  Record decay(const Observation& first, const Observation& last, std::size_t index) const {
    const double rate = campaign_.sample_rate_hz;
    const auto half = [&](const Observation& o) { return 0.5 * (std::round(o.length_s * rate) - 1) / rate; };
    const double begin = first.centre_s - half(first);
    const ExcitationSignal silent = [&](double, ExcitationSample* s) {
      for (std::size_t j = 0; j < model_.excitations.size(); ++j) s[j] = {};
    };
    const auto motion = [&](const OscillationState& state, double seconds) {
      MotionState moving{state.displacement, state.velocity};
      const auto count = static_cast<std::size_t>(std::lround(seconds * rate)) + 1;
      Record record = empty(count, begin, rate);
      std::size_t i = 0;
      integrate_motion({model_, parameters_.data(), silent}, {0, 0, 1 / rate, count}, settings(first, index),
                       moving, [&](const MotionSample& sample) { store(sample, i++, record); });
      return record;
    };
    OscillationState start = states_.at(parameters_, first, -half(first)), possible = at_rest(model_);
    int returns = 0;
    for (int step = 0; step < start_steps;) {
      Observation seen;
      try {
        seen = decay_windows_.fit_again(motion(start, 2 * half(first)), first);
      } catch (const NumericalFailure&) {
        // A window near where a softening spring gives way, over which amplitudes change a lot, has its start
        // beyond.
        if (++returns > start_returns) throw;
        start = between(possible, start, return_share);
        continue;
      }
      possible = start;
      ++step;
      double missed = 0;
      for (const std::size_t k : decay_windows_.oscillating()) {
        if (first.growth_sd[k] < 0 || seen.growth_sd[k] < 0) continue;
        const Complex wanted = first.amplitude[k] - seen.amplitude[k];
        const Complex more = wanted * std::exp(-first.rate[k] * half(first));
        start.displacement[k] += 2 * more.real();
        start.velocity[k] += 2 * (first.rate[k] * more).real();
        missed = std::max(missed, std::abs(wanted) / std::abs(first.amplitude[k]));
      }
      if (missed < start_tolerance) break;
    }
    return motion(start, last.centre_s + half(last) - begin);
  }

  const Campaign& campaign_;
  const ObservationSet& measured_;
  const CompiledModel& model_;
  const Eigen::VectorXd& parameters_;
  OscillationStates states_;
  DecayWindows decay_windows_;
  std::vector<std::vector<double>> shapes_;
  std::vector<std::size_t> excitations_;
};

/// Replays records in the order in which they are asked for, a few ahead on all threads.
class ReplayedRecords {
 public:
  ReplayedRecords(const Campaign& campaign, const ObservationSet& measured, const Eigen::VectorXd& parameters,
                  unsigned threads)
      : measured_(measured), replay_(campaign, measured, parameters), threads_(std::max(1U, threads)) {
    for (std::size_t i = 0; i < measured.observations.size(); ++i) {
      const Observation& o = measured.observations[i];
      // A decay starts anew in every stretch: it stays with what was measured, across knocks too.
      const Observation* before = i > 0 ? &measured.observations[i - 1] : nullptr;
      const bool same =
          before && before->record == o.record && (measured.resonance->excited || before->condition == o.condition);
      if (!same) spans_.push_back({i, i});
      spans_.back().end = i + 1;
    }
  }

  std::size_t count() const { return spans_.size(); }
  std::size_t original(std::size_t i) const { return measured_.observations[spans_[i].begin].record; }
  /// Index after the last observation of span i.
  std::size_t end(std::size_t i) const { return spans_[i].end; }

  /// From any thread.
  Record replay(std::size_t i) const {
    const Span& span = spans_[i];
    return replay_.record(std::span(measured_.observations).subspan(span.begin, span.end - span.begin),
                          original(i));
  }

  /// The same, with those that follow: for one thread that reads in order.
  Record read(std::size_t i) {
    if (i < begin_ || i >= begin_ + ahead_.size()) fill(i);
    return ahead_[i - begin_];
  }

 private:
  struct Span {
    std::size_t begin, end;
  };

  void fill(std::size_t begin) {
    begin_ = begin;
    ahead_.clear();
    ahead_.resize(std::min(records_ahead * threads_, spans_.size() - begin));
    in_parallel(ahead_.size(), threads_, [&](std::size_t i) { ahead_[i] = replay(begin_ + i); });
  }

  const ObservationSet& measured_;
  Replay replay_;
  unsigned threads_;
  std::vector<Span> spans_;  // of each record (stretch of a decay) with observations, which stand together
  std::size_t begin_ = 0;
  std::vector<Record> ahead_;
};

}  // namespace

ObservationSet observe_replay(const Campaign& campaign, const ObservationSet& measured,
                              const Eigen::VectorXd& parameters, unsigned threads) {
  ReplayedRecords replayed(campaign, measured, parameters, threads);
  // Every measured observation takes the exact values and keeps its noise.
  ObservationSet result = measured;
  result.warnings.clear();
  result.observations.clear();
  const auto take = [&](const Observation& seen, const Observation& exact) {
    result.observations.push_back(seen);
    take_motion(exact, result.observations.back());
  };
  if (!measured.resonance->excited) {
    const DecayWindows windows(campaign, *measured.model, *measured.resonance, Window{});
    std::size_t next = 0;
    for (std::size_t i = 0; i < replayed.count(); ++i) {
      const Record record = replayed.read(i);
      for (; next < replayed.end(i); ++next)
        take(measured.observations[next], windows.fit_again(record, measured.observations[next]));
    }
    return result;
  }
  Campaign reduced = campaign;
  reduced.records.clear();
  std::vector<std::size_t> original;
  for (std::size_t i = 0; i < replayed.count(); ++i) {
    original.push_back(replayed.original(i));
    reduced.records.push_back(campaign.records[original.back()]);
  }
  const RecordReader read = [&](std::size_t i) { return replayed.replay(i); };
  Window window;
  window.threads = threads;
  const ObservationSet exact =
      observe_dwells(reduced, read, *measured.model, *measured.resonance, window, DwellMotion::transient);
  for (const Observation& seen : measured.observations)
    for (const Observation& o : exact.observations)
      if (original[o.record] == seen.record) {
        take(seen, o);
        break;
      }
  return result;
}

}  // namespace secular

#include "simulate/replay.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <exception>
#include <mutex>
#include <numbers>
#include <thread>

#include "estimator/identification/modal_projection.hpp"
#include "estimator/identification/mode_frequencies.hpp"
#include "input/input_error.hpp"
#include "simulate/motion.hpp"

namespace secular {
namespace {

using Complex = std::complex<double>;

/// A dwell starts at the measured motion, near the model's own steady one. What its state leaves out (harmonics
/// beyond those measured) dies out or joins the modes within these cycles; the modes may go on changing slowly.
constexpr double settle_cycles = 30;

class Replay {
 public:
  Replay(const Campaign& campaign, const ObservationSet& measured, const Eigen::VectorXd& parameters)
      : campaign_(campaign),
        measured_(measured),
        model_(*measured.model),
        parameters_(parameters),
        projection_(modal_projection(campaign, model_)),
        modes_(mode_frequencies(model_, *measured.resonance)) {
    for (std::size_t k = 0; k < model_.modes(); ++k)
      if (modes_.oscillates[k]) oscillating_.push_back(k);
    if (campaign.modal_basis)
      for (const std::vector<double>& row : campaign.modal_basis->mass_normalised_shapes) shapes_.push_back(row);
    if (measured.resonance->excited) excitations_ = excitation_channels(campaign, model_);
  }

  Record record(const Observation& first, const Observation& last, std::size_t index) const {
    return measured_.resonance->excited ? dwell(first, index) : decay(first, last, index);
  }

 private:
  MotionSettings settings(std::size_t index) const {
    MotionSettings s;
    s.label = fmt::format("{}, replayed with the estimated parameters", campaign_.records[index].file);
    s.relative_tolerance = 1e-9;
    return s;
  }

  Record empty(std::size_t samples, double start) const {
    Record r;
    r.start_s = start;
    r.sample_rate_hz = campaign_.sample_rate_hz;
    r.channels.assign(campaign_.channels.size(), std::vector<double>(samples, 0.0));
    return r;
  }

  void store(const MotionSample& sample, std::size_t i, Record& record) const {
    const std::vector<double>& modal = projection_.derivatives == 2   ? sample.acceleration
                                       : projection_.derivatives == 1 ? sample.velocity
                                                                      : sample.displacement;
    for (std::size_t c = 0; c < projection_.channels.size(); ++c) {
      double value = 0;
      for (std::size_t k = 0; k < modal.size(); ++k)
        value += (campaign_.modal_basis ? shapes_[c][mode_column(k)] : (c == k ? 1.0 : 0.0)) * modal[k];
      record.channels[projection_.channels[c]][i] = value;
    }
  }

  std::size_t mode_column(std::size_t k) const {
    const std::vector<std::string>& modes = campaign_.modal_basis->modes;
    return static_cast<std::size_t>(std::find(modes.begin(), modes.end(), model_.coordinates[k]) - modes.begin());
  }

  // State of the measured oscillation `earlier` seconds before the observation's centre.
  void initial_state(const Observation& o, double earlier, std::vector<double>& q, std::vector<double>& v) const {
    q.assign(model_.modes(), 0);
    v.assign(model_.modes(), 0);
    for (std::size_t k = 0; k < model_.modes(); ++k) {
      const Complex amplitude = o.amplitude[k] * std::exp(-o.rate[k] * earlier);
      q[k] += 2 * amplitude.real();
      v[k] += 2 * (o.rate[k] * amplitude).real();
    }
    if (!measured_.resonance->excited) return;
    for (std::size_t b = 0; b < measured_.resonance->blocks.size(); ++b) {
      const RegressorBlock& block = measured_.resonance->blocks[b];
      if (block.kind != BlockKind::harmonic || !(o.harmonic_sd[b] >= 0)) continue;
      double frequency = 0;
      for (std::size_t i = 0; i < block.phase.size(); ++i)
        frequency +=
            block.phase[i] * (i < model_.modes() ? o.rate[i].imag() : o.excitation_frequency[i - model_.modes()]);
      if (frequency == 0) continue;  // with the sensor's offset in it
      const auto k = static_cast<std::size_t>(block.mode);
      const Complex amplitude = o.harmonic[b] * std::exp(Complex(0, -frequency * earlier));
      q[k] += 2 * amplitude.real();
      v[k] -= 2 * frequency * amplitude.imag();
    }
  }

  double slowest(const Observation& o) const {
    double frequency = INFINITY;
    for (const std::size_t k : oscillating_) frequency = std::min(frequency, o.rate[k].imag());
    return frequency;
  }

  Record dwell(const Observation& o, std::size_t index) const {
    const double rate = campaign_.sample_rate_hz;
    const auto count = static_cast<std::size_t>(std::lround(
        campaign_.records[index].ensemble_s.value_or(200 * 2 * std::numbers::pi / o.excitation_frequency[0]) *
        rate));
    const ExcitationSignal signal = [&](double t, ExcitationSample* s) {
      for (std::size_t j = 0; j < o.forcing.size(); ++j) {
        const double w = o.excitation_frequency[j];
        const Complex wave = o.forcing[j] * std::polar(1.0, w * t);
        s[j] = {wave.real(), -w * wave.imag(), -w * w * wave.real()};
      }
    };
    std::vector<double> q, v;
    initial_state(o, 0, q, v);
    const double settle = settle_cycles * 2 * std::numbers::pi / slowest(o);
    Record record = empty(count, 0);
    std::size_t i = 0;
    integrate_motion(model_, parameters_.data(), signal, 0, q, v, settle, 1 / rate, count, settings(index),
                     [&](const MotionSample& sample) { store(sample, i++, record); });
    ExcitationSample sample[8];
    for (std::size_t n = 0; n < count; ++n) {
      signal(settle + static_cast<double>(n) / rate, sample);
      for (std::size_t j = 0; j < excitations_.size(); ++j) record.channels[excitations_[j]][n] = sample[j].value;
    }
    return record;
  }

  Record decay(const Observation& first, const Observation& last, std::size_t index) const {
    const double rate = campaign_.sample_rate_hz;
    std::vector<double> q, v;
    // Some periods earlier and longer than what was seen, so that as many windows fit in after the start is found.
    const double before = 2.5 * 2 * std::numbers::pi / slowest(first);
    const double after = 4 * 2 * std::numbers::pi / slowest(last);
    initial_state(first, before, q, v);
    const auto count = static_cast<std::size_t>((last.centre_s - first.centre_s + before + after) * rate);
    const ExcitationSignal silent = [&](double, ExcitationSample* s) {
      for (std::size_t j = 0; j < model_.excitations.size(); ++j) s[j] = {};
    };
    Record record = empty(count, first.centre_s - before);
    std::size_t i = 0;
    integrate_motion(model_, parameters_.data(), silent, 0, q, v, 0, 1 / rate, count, settings(index),
                     [&](const MotionSample& sample) { store(sample, i++, record); });
    return record;
  }

  const Campaign& campaign_;
  const ObservationSet& measured_;
  const CompiledModel& model_;
  const Eigen::VectorXd& parameters_;
  ModalProjection projection_;
  ModeFrequencies modes_;
  std::vector<std::size_t> oscillating_;
  std::vector<std::vector<double>> shapes_;
  std::vector<std::size_t> excitations_;
};

/// Replays records in the order in which they are asked for, a few ahead on all threads.
class ReplayedRecords {
 public:
  ReplayedRecords(const Campaign& campaign, const ObservationSet& measured, const Eigen::VectorXd& parameters,
                  unsigned threads)
      : replay_(campaign, measured, parameters),
        threads_(std::max(1U, threads)),
        for_each_thread_(measured.resonance->excited ? 16 : 1) {
    for (std::size_t i = 0; i < measured.observations.size(); ++i) {
      const Observation& o = measured.observations[i];
      if (spans_.empty() || spans_.back().first->record != o.record) spans_.push_back({&o, &o});
      spans_.back().last = &o;
    }
  }

  std::size_t count() const { return spans_.size(); }
  std::size_t original(std::size_t i) const { return spans_[i].first->record; }

  Record read(std::size_t i) {
    if (i < begin_ || i >= begin_ + ahead_.size()) fill(i);
    return ahead_[i - begin_];
  }

 private:
  struct Span {
    const Observation *first, *last;
  };

  void fill(std::size_t begin) {
    begin_ = begin;
    ahead_.clear();
    ahead_.resize(std::min(for_each_thread_ * threads_, spans_.size() - begin));
    std::atomic<std::size_t> next{0};
    std::mutex guard;
    std::exception_ptr failure;
    const auto work = [&] {
      for (std::size_t i = next++; i < ahead_.size(); i = next++) try {
          const Span& span = spans_[begin_ + i];
          ahead_[i] = replay_.record(*span.first, *span.last, span.first->record);
        } catch (...) {
          const std::lock_guard lock(guard);
          if (!failure) failure = std::current_exception();
        }
    };
    {
      std::vector<std::jthread> workers;
      for (unsigned t = 1; t < threads_; ++t) workers.emplace_back(work);
      work();
    }
    if (failure) std::rethrow_exception(failure);
  }

  Replay replay_;
  unsigned threads_;
  std::size_t for_each_thread_;  // one decay; the ensembles of dwells are short
  std::vector<Span> spans_;      // of each record with observations, which stand together
  std::size_t begin_ = 0;
  std::vector<Record> ahead_;
};

}  // namespace

ObservationSet observe_replay(const Campaign& campaign, const ObservationSet& measured,
                              const Eigen::VectorXd& parameters, unsigned threads) {
  ReplayedRecords replayed(campaign, measured, parameters, threads);
  Campaign reduced = campaign;
  reduced.records.clear();
  std::vector<std::size_t> original;
  for (std::size_t i = 0; i < replayed.count(); ++i) {
    original.push_back(replayed.original(i));
    reduced.records.push_back(campaign.records[original.back()]);
  }
  const RecordReader read = [&](std::size_t i) { return replayed.read(i); };
  // Records come in their order, a few ahead: the threads are those that replay them.
  const ObservationSet exact =
      measured.resonance->excited
          ? observe_dwells(reduced, read, *measured.model, *measured.resonance, {}, DwellMotion::transient)
          : observe_free_decays(reduced, read, *measured.model, *measured.resonance, {});
  const ModeFrequencies modes = mode_frequencies(*measured.model, *measured.resonance);
  std::size_t own = 0;  // the mode that a decay is followed in
  while (own + 1 < modes.oscillates.size() && !modes.oscillates[own]) ++own;
  // Every measured observation takes the exact values seen nearest to it in the same record, and keeps its noise.
  ObservationSet result = measured;
  result.warnings.clear();
  std::vector<Observation> kept;
  for (const Observation& seen : measured.observations) {
    const Observation* nearest = nullptr;
    for (const Observation& o : exact.observations) {
      if (original[o.record] != seen.record) continue;
      if (!nearest || (!measured.resonance->excited &&
                       std::abs(std::abs(o.amplitude[own]) - std::abs(seen.amplitude[own])) <
                           std::abs(std::abs(nearest->amplitude[own]) - std::abs(seen.amplitude[own]))))
        nearest = &o;
    }
    if (!nearest) continue;
    Observation mixed = seen;
    mixed.excitation_frequency = nearest->excitation_frequency;
    mixed.forcing = nearest->forcing;
    mixed.amplitude = nearest->amplitude;
    mixed.rate = nearest->rate;
    mixed.harmonic = nearest->harmonic;
    kept.push_back(std::move(mixed));
  }
  result.observations = std::move(kept);
  return result;
}

}  // namespace secular

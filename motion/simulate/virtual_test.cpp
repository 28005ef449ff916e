#include "motion/simulate/virtual_test.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <numbers>
#include <utility>

#include "input/input_error.hpp"
#include "input/numerical_failure.hpp"
#include "motion/simulate/anti_alias_filter.hpp"
#include "motion/simulate/excitation_signal.hpp"
#include "motion/simulate/motion.hpp"
#include "motion/simulate/noise.hpp"
#include "motion/simulate/sensor_fault.hpp"
#include "numerics/hertz.hpp"
#include "numerics/in_parallel.hpp"

namespace secular {
namespace {

// One record to compute; a chain is computed in order by one thread.
struct Task {
  std::size_t record = 0;
  const DwellProgramme* dwell = nullptr;
  const FreeDecayProgramme* decay = nullptr;
  const SignalProgramme* signal = nullptr;
  std::vector<double> frequency_hz, amplitude;  // of a dwell: [excitation]
  double started_s = 0;
};
using Chain = std::vector<Task>;

class VirtualTest {
 public:
  VirtualTest(const Experiment& experiment, const CompiledModel& model, std::uint64_t seed)
      : experiment_(experiment), model_(model), seed_(seed) {
    describe_channels();
    plan();
  }

  Campaign run(unsigned threads, const RecordSink& sink, const Progress& progress) {
    sink_ = sink;
    std::atomic<std::size_t> done{0};
    in_parallel(chains_.size(), threads, [&](std::size_t c) {
      run_chain(chains_[c], [&] {
        const std::size_t finished = ++done;
        if (progress) progress(finished, campaign_.records.size());
      });
    });
    return std::move(campaign_);
  }

 private:
  void describe_channels() {
    campaign_.name = experiment_.name;
    campaign_.sample_rate_hz = experiment_.sample_rate_hz;
    for (const SimulatedChannel& excitation : experiment_.excitations)
      campaign_.channels.push_back(excitation.channel);
    for (const SimulatedChannel& response : experiment_.responses) campaign_.channels.push_back(response.channel);
    campaign_.modal_basis = experiment_.modal_basis;
  }

  void plan() {
    double clock = 0;
    const auto add = [&](RecordEntry entry, Task task, bool carries) {
      task.record = campaign_.records.size();
      task.started_s = clock;
      entry.file = fmt::format("records/{:04}.csv", task.record + 1);
      entry.started_s = clock;
      campaign_.records.push_back(std::move(entry));
      if (carries && !chains_.empty())
        chains_.back().push_back(task);
      else
        chains_.push_back({task});
    };
    for (const DwellProgramme& dwell : experiment_.dwells) {
      bool first = true;
      for (const std::vector<double>& amplitude : dwell.amplitudes)
        for (const std::vector<double>& frequency : dwell.frequencies_hz) {
          clock += dwell.settle_s;
          RecordEntry entry;
          entry.kind = RecordKind::dwell;
          entry.excitation_frequency_hz = frequency.front();
          entry.excitation_amplitude = amplitude.front();
          entry.ensemble_s = dwell.ensemble_s;
          entry.group = dwell.group;
          add(std::move(entry), {0, &dwell, nullptr, nullptr, frequency, amplitude, 0},
              dwell.carry_state && !first);
          clock += dwell.ensembles * dwell.ensemble_s;
          first = false;
        }
    }
    for (const FreeDecayProgramme& decay : experiment_.free_decays) {
      RecordEntry entry;
      entry.kind = RecordKind::free_decay;
      entry.group = decay.group;
      add(std::move(entry), {0, nullptr, &decay, nullptr, {}, {}, 0}, false);
      clock += decay.duration_s;
    }
    for (const SignalProgramme& signal : experiment_.signals) {
      static constexpr RecordKind kinds[] = {RecordKind::sweep, RecordKind::impact, RecordKind::broadband};
      clock += signal.settle_s;
      RecordEntry entry;
      entry.kind = kinds[static_cast<std::size_t>(signal.kind)];
      entry.group = signal.group;
      add(std::move(entry), {0, nullptr, nullptr, &signal, {}, {}, 0}, false);
      clock += signal.duration_s;
    }
  }

  // State that one record hands to the next of its chain.
  struct Course {
    MotionState state;
    std::vector<double> phase;  // [excitation]
  };

  template <class Finished>
  void run_chain(const Chain& chain, const Finished& finished) {
    Course course;
    bool first = true;
    for (const Task& task : chain) {
      if (task.decay) {
        course.state.displacement = task.decay->initial_displacement;
        course.state.velocity = task.decay->initial_velocity;
        run_decay(task, course);
      } else if (task.signal) {
        course.state.displacement = task.signal->initial_displacement;
        course.state.velocity.assign(model_.modes(), 0.0);
        run_signal(task, course);
      } else {
        if (first) {
          course.state.displacement = task.dwell->initial_displacement;
          course.state.velocity.assign(model_.modes(), 0.0);
          course.phase = task.dwell->phases;
          course.phase.resize(experiment_.excitations.size(), 0.0);
        }
        run_dwell(task, course);
      }
      first = false;
      finished();
    }
  }

  void run_decay(const Task& task, Course& course) {
    const auto count =
        static_cast<std::size_t>(std::floor(task.decay->duration_s * experiment_.sample_rate_hz)) + 1;
    const ExcitationSignal silent = [&](double, ExcitationSample* samples) {
      for (std::size_t j = 0; j < model_.excitations.size(); ++j) samples[j] = {};
    };
    store(task, recorded(task, silent, course, {.count = count}));
  }

  // Shakers distort the first excitation.
  std::vector<double> shaker_harmonics(std::size_t excitation) const {
    return excitation == 0 ? experiment_.shaker_harmonics : std::vector<double>{};
  }

  // Moves the excitations' phases on, so that the next dwell goes on without a jump.
  void run_dwell(const Task& task, Course& course) {
    std::vector<ExcitationSignal> waves;
    for (std::size_t j = 0; j < course.phase.size(); ++j)
      waves.push_back(
          harmonic_wave(two_pi * task.frequency_hz[j], task.amplitude[j], course.phase[j], shaker_harmonics(j)));
    const ExcitationSignal signal = side_by_side(std::move(waves));
    const double rate = experiment_.sample_rate_hz;
    const auto count = static_cast<std::size_t>(task.dwell->ensembles) *
                       static_cast<std::size_t>(std::lround(task.dwell->ensemble_s * rate));
    store(task, recorded(task, signal, course, {.first = task.dwell->settle_s, .count = count}));
    const double end = task.dwell->settle_s + static_cast<double>(count - 1) / rate;
    for (std::size_t j = 0; j < course.phase.size(); ++j)
      course.phase[j] = std::remainder(two_pi * task.frequency_hz[j] * end + course.phase[j], two_pi);
  }

  void run_signal(const Task& task, Course& course) {
    const SignalProgramme& p = *task.signal;
    const auto count = static_cast<std::size_t>(std::floor(p.duration_s * experiment_.sample_rate_hz)) + 1;
    std::vector<ExcitationSignal> steady, moving;
    if (p.kind == SignalProgramme::Kind::sweep) {
      // Steady at the first frequencies until time 0, with phase 0 there.
      for (std::size_t j = 0; j < p.amplitude.size(); ++j) {
        const double rate = (p.to_hz[j] - p.from_hz[j]) / p.duration_s;
        steady.push_back(harmonic_wave(two_pi * p.from_hz[j], p.amplitude[j], 0, shaker_harmonics(j)));
        moving.push_back(linear_sweep(p.from_hz[j], rate, p.amplitude[j], shaker_harmonics(j)));
      }
      const ExcitationSignal before = side_by_side(std::move(steady)), sweep = side_by_side(std::move(moving));
      const ExcitationSignal signal = [&](double time, ExcitationSample* samples) {
        (time < 0 ? before : sweep)(time, samples);
      };
      store(task, recorded(task, signal, course, {.from = -p.settle_s, .count = count}));
      return;
    }
    const bool impact = p.kind == SignalProgramme::Kind::impact;
    for (std::size_t j = 0; j < p.amplitude.size(); ++j)
      moving.push_back(impact ? half_sine_pulse(p.amplitude[j], p.at_s, p.width_s)
                              : random_phase_multisine(p.low_hz, p.high_hz, p.lines, p.amplitude[j], p.seed + j));
    store(task, recorded(task, side_by_side(std::move(moving)), course,
                         {.first = p.settle_s, .count = count, .largest_step = impact ? p.width_s / 8 : 0}));
  }

  // Integration from `from`, `count` samples at the recorded rate from `first` on.
  struct Recording {
    double from = 0, first = 0;
    std::size_t count = 0;
    double largest_step = 0;  // MotionSettings::largest_step
  };

  // What the sensors see, filtered.
  Record recorded(const Task& task, const ExcitationSignal& signal, Course& course,
                  const Recording& recording) const {
    const auto& [from, first, count, largest_step] = recording;
    const std::size_t excitations = experiment_.excitations.size();
    const std::size_t oversampling = experiment_.anti_alias ? experiment_.anti_alias->oversampling : 1;
    const double rate = experiment_.sample_rate_hz * static_cast<double>(oversampling);
    // Samples before the first, on which the filters settle.
    const auto lead = static_cast<std::size_t>(std::floor(std::min(first - from, filter_memory_s()) * rate));
    MotionSettings settings = experiment_.motion;
    settings.largest_step = largest_step;
    settings.clock_origin = task.started_s - first;
    settings.level = level(task);
    settings.label = fmt::format("{}, record {}", experiment_.file, task.record + 1);
    std::vector<ChannelChain> chains;
    for (const SimulatedChannel& excitation : experiment_.excitations)
      chains.emplace_back(excitation, experiment_.anti_alias, rate);
    for (const SimulatedChannel& response : experiment_.responses)
      chains.emplace_back(response, experiment_.anti_alias, rate);
    Record record;
    record.sample_rate_hz = experiment_.sample_rate_hz;
    record.channels.assign(chains.size(), std::vector<double>(count));
    std::size_t i = 0;
    integrate_motion(
        {model_, experiment_.parameters.data(), signal},
        {from, first - static_cast<double>(lead) / rate, 1 / rate, lead + (count - 1) * oversampling + 1}, settings,
        course.state, [&](const MotionSample& sample) {
          const bool keep = i >= lead && (i - lead) % oversampling == 0;
          for (std::size_t c = 0; c < chains.size(); ++c) {
            const double seen = c < excitations ? sample.excitation[c].value
                                                : measured(experiment_.responses[c - excitations], sample);
            const double value = chains[c](seen);
            if (keep) record.channels[c][(i - lead) / oversampling] = value;
          }
          ++i;
        });
    return record;
  }

  // Amplitude of a harmonic as strong as the first excitation.
  static double level(const Task& task) {
    if (task.dwell) return task.amplitude.front();
    if (task.decay || task.signal->kind == SignalProgramme::Kind::impact) return 0;
    const SignalProgramme& p = *task.signal;
    return (p.kind == SignalProgramme::Kind::sweep ? 1 : std::numbers::sqrt2) * p.amplitude.front();
  }

  // Time after which the filters have forgotten how they began, to 1e-8 or so.
  double filter_memory_s() const {
    double longest = experiment_.anti_alias ? 40 / experiment_.anti_alias->cut_off_hz : 0;
    const auto coupling = [&](const SimulatedChannel& channel) {
      if (channel.high_pass_hz > 0) longest = std::max(longest, 3 / channel.high_pass_hz);
    };
    for (const SimulatedChannel& excitation : experiment_.excitations) coupling(excitation);
    for (const SimulatedChannel& response : experiment_.responses) coupling(response);
    return longest;
  }

  // Filters between one sensor and its samples. What is measured before the first sample: rest, or the displacement
  // that the motion starts with.
  class ChannelChain {
   public:
    ChannelChain(const SimulatedChannel& channel, const std::optional<AntiAliasFilter>& anti_alias, double rate)
        : held_(
              channel.channel.role == ChannelRole::response &&
              (channel.channel.quantity == Quantity::displacement || channel.channel.quantity == Quantity::angle)) {
      if (channel.high_pass_hz > 0) filters_.push_back(FilterCascade::high_pass(channel.high_pass_hz, rate));
      if (anti_alias) filters_.emplace_back(*anti_alias, rate);
    }
    double operator()(double value) {
      for (FilterCascade& filter : filters_) {
        if (!started_ && held_) filter.settle(value);
        value = filter(value);
      }
      started_ = true;
      return value;
    }

   private:
    std::vector<FilterCascade> filters_;
    bool held_ = false, started_ = false;
  };

  static double measured(const SimulatedChannel& response, const MotionSample& sample) {
    const Quantity quantity = response.channel.quantity;
    const std::vector<double>& modal = quantity == Quantity::acceleration ? sample.acceleration
                                       : quantity == Quantity::velocity   ? sample.velocity
                                                                          : sample.displacement;
    double sum = 0;
    for (std::size_t k = 0; k < modal.size(); ++k) sum += response.shape[k] * modal[k];
    if (response.base != 0) sum += response.base * sample.excitation[0].value;
    return sum;
  }

  // Faults of the sensors, noise and quantisation, then into the campaign.
  void store(const Task& task, Record record) {
    std::vector<std::string> names;
    for (const Channel& channel : campaign_.channels) names.push_back(channel.name);
    const std::size_t excitations = experiment_.excitations.size();
    apply_sensor_faults(experiment_.faults, names, excitations > 0, record);
    for (std::size_t c = 0; c < record.channels.size(); ++c) {
      const SimulatedChannel& sensor =
          c < excitations ? experiment_.excitations[c] : experiment_.responses[c - excitations];
      NoiseStream noise(seed_, task.record, c);
      for (double& x : record.channels[c]) {
        if (sensor.noise_sd > 0) x += sensor.noise_sd * noise.gaussian();
      }
      clip(experiment_.faults, campaign_.channels[c].name, record.channels[c]);
      for (double& x : record.channels[c]) {
        if (sensor.quantisation > 0) x = sensor.quantisation * std::round(x / sensor.quantisation);
      }
    }
    sink_(campaign_, campaign_.records[task.record], std::move(record));
  }

  const Experiment& experiment_;
  const CompiledModel& model_;
  std::uint64_t seed_;
  std::vector<Chain> chains_;
  Campaign campaign_;
  RecordSink sink_;
};

}  // namespace

Campaign run_virtual_test(const Experiment& experiment, const CompiledModel& model, std::uint64_t seed,
                          unsigned threads, const RecordSink& sink, const Progress& progress) {
  try {
    return VirtualTest(experiment, model, seed).run(threads, sink, progress);
  } catch (const NumericalFailure& failure) {
    if (failure.ending() != Ending::ran_away) throw;
    throw InputError("", "", failure.what());  // see NumericalFailure: the experiment is what can be changed
  }
}

}  // namespace secular

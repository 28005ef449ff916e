#include "simulate/virtual_test.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <exception>
#include <mutex>
#include <numbers>
#include <thread>
#include <utility>

#include "simulate/excitation_signal.hpp"
#include "simulate/motion.hpp"
#include "simulate/noise.hpp"
#include "simulate/sensor_fault.hpp"

namespace secular {
namespace {

// One record to compute; a chain is computed in order by one thread.
struct Task {
  std::size_t record = 0;
  const DwellProgramme* dwell = nullptr;
  const FreeDecayProgramme* decay = nullptr;
  const SignalProgramme* signal = nullptr;
  double frequency_hz = 0, amplitude = 0;
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

  SimulatedCampaign run(unsigned threads, const Progress& progress) {
    result_.samples.resize(result_.campaign.records.size());
    std::atomic<std::size_t> next{0}, done{0};
    std::mutex guard;
    std::exception_ptr failure;
    const auto work = [&] {
      for (std::size_t c = next++; c < chains_.size(); c = next++) {
        try {
          run_chain(chains_[c], [&] {
            const std::size_t finished = ++done;
            if (progress) progress(finished, result_.samples.size());
          });
        } catch (...) {
          const std::lock_guard lock(guard);
          if (!failure) failure = std::current_exception();
          next = chains_.size();
        }
      }
    };
    {
      std::vector<std::jthread> workers;
      for (unsigned i = 1; i < std::max(1U, threads); ++i) workers.emplace_back(work);
      work();
    }
    if (failure) std::rethrow_exception(failure);
    return std::move(result_);
  }

 private:
  void describe_channels() {
    Campaign& campaign = result_.campaign;
    campaign.name = experiment_.name;
    campaign.sample_rate_hz = experiment_.sample_rate_hz;
    if (experiment_.excitation) campaign.channels.push_back(experiment_.excitation->channel);
    for (const SimulatedChannel& response : experiment_.responses) campaign.channels.push_back(response.channel);
    campaign.modal_basis = experiment_.modal_basis;
  }

  void plan() {
    double clock = 0;
    const auto add = [&](RecordEntry entry, Task task, bool carries) {
      task.record = result_.campaign.records.size();
      task.started_s = clock;
      entry.file = fmt::format("records/{:04}.csv", task.record + 1);
      entry.started_s = clock;
      result_.campaign.records.push_back(std::move(entry));
      if (carries && !chains_.empty())
        chains_.back().push_back(task);
      else
        chains_.push_back({task});
    };
    for (const DwellProgramme& dwell : experiment_.dwells) {
      bool first = true;
      for (const double amplitude : dwell.amplitudes)
        for (const double frequency : dwell.frequencies_hz) {
          clock += dwell.settle_s;
          RecordEntry entry;
          entry.kind = RecordKind::dwell;
          entry.excitation_frequency_hz = frequency;
          entry.excitation_amplitude = amplitude;
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
      add(std::move(entry), {0, nullptr, &decay, nullptr, 0, 0, 0}, false);
      clock += decay.duration_s;
    }
    for (const SignalProgramme& signal : experiment_.signals) {
      static constexpr RecordKind kinds[] = {RecordKind::sweep, RecordKind::impact, RecordKind::broadband};
      clock += signal.settle_s;
      RecordEntry entry;
      entry.kind = kinds[static_cast<std::size_t>(signal.kind)];
      entry.group = signal.group;
      add(std::move(entry), {0, nullptr, nullptr, &signal, 0, 0, 0}, false);
      clock += signal.duration_s;
    }
  }

  template <class Finished>
  void run_chain(const Chain& chain, const Finished& finished) {
    std::vector<double> displacement, velocity;
    double phase = 0;
    bool first = true;
    for (const Task& task : chain) {
      if (task.decay) {
        displacement = task.decay->initial_displacement;
        velocity = task.decay->initial_velocity;
        run_decay(task, displacement, velocity);
      } else if (task.signal) {
        displacement = task.signal->initial_displacement;
        velocity.assign(model_.modes(), 0.0);
        run_signal(task, displacement, velocity);
      } else {
        if (first) {
          displacement = task.dwell->initial_displacement;
          velocity.assign(model_.modes(), 0.0);
        }
        phase = run_dwell(task, displacement, velocity, phase);
      }
      first = false;
      finished();
    }
  }

  Record empty_record(std::size_t samples) const {
    Record record;
    record.sample_rate_hz = experiment_.sample_rate_hz;
    record.channels.assign(result_.campaign.channels.size(), std::vector<double>(samples));
    return record;
  }

  void run_decay(const Task& task, std::vector<double>& displacement, std::vector<double>& velocity) {
    const auto count =
        static_cast<std::size_t>(std::floor(task.decay->duration_s * experiment_.sample_rate_hz)) + 1;
    Record record = empty_record(count);
    const ExcitationSignal silent = [&](double, ExcitationSample* samples) {
      for (std::size_t j = 0; j < model_.excitations.size(); ++j) samples[j] = {};
    };
    integrate(task, silent, 0, displacement, velocity, 0, count, record);
    if (experiment_.excitation) std::fill(record.channels[0].begin(), record.channels[0].end(), 0.0);
    store(task, std::move(record));
  }

  // Returns the excitation's phase at the end, so that the next dwell goes on without a jump.
  double run_dwell(const Task& task, std::vector<double>& displacement, std::vector<double>& velocity,
                   double phase) {
    const double omega = 2 * std::numbers::pi * task.frequency_hz;
    const double amplitude = task.amplitude;
    const ExcitationSignal signal = harmonic_wave(omega, amplitude, phase, experiment_.shaker_harmonics);
    const double rate = experiment_.sample_rate_hz;
    const auto count = static_cast<std::size_t>(task.dwell->ensembles) *
                       static_cast<std::size_t>(std::lround(task.dwell->ensemble_s * rate));
    Record record = empty_record(count);
    integrate(task, signal, 0, displacement, velocity, task.dwell->settle_s, count, record);
    record_excitation(signal, task.dwell->settle_s, record);
    store(task, std::move(record));
    const double end = task.dwell->settle_s + static_cast<double>(count - 1) / rate;
    return std::remainder(omega * end + phase, 2 * std::numbers::pi);
  }

  void run_signal(const Task& task, std::vector<double>& displacement, std::vector<double>& velocity) {
    const SignalProgramme& p = *task.signal;
    const auto count = static_cast<std::size_t>(std::floor(p.duration_s * experiment_.sample_rate_hz)) + 1;
    Record record = empty_record(count);
    if (p.kind == SignalProgramme::Kind::sweep && p.settle_s > 0) {
      // Steady at the first frequency; the sweep then starts with the phase that this ends with, zero.
      const double omega = 2 * std::numbers::pi * p.low_hz;
      const ExcitationSignal steady =
          harmonic_wave(omega, p.amplitude, -omega * p.settle_s, experiment_.shaker_harmonics);
      Record unused = empty_record(1);
      integrate(task, steady, 0, displacement, velocity, p.settle_s, 1, unused);
    }
    const bool starts_settled = p.kind == SignalProgramme::Kind::sweep;
    const double first = starts_settled ? 0 : p.settle_s;
    const ExcitationSignal signal =
        p.kind == SignalProgramme::Kind::sweep
            ? linear_sweep(p.low_hz, p.rate_hz_per_s, p.amplitude, experiment_.shaker_harmonics)
        : p.kind == SignalProgramme::Kind::impact
            ? half_sine_pulse(p.amplitude, p.at_s, p.width_s)
            : random_phase_multisine(p.low_hz, p.high_hz, p.lines, p.amplitude, p.seed);
    integrate(task, signal, 0, displacement, velocity, first, count, record,
              p.kind == SignalProgramme::Kind::impact ? p.width_s / 8 : 0);
    record_excitation(signal, first, record);
    store(task, std::move(record));
  }

  void record_excitation(const ExcitationSignal& signal, double first, Record& record) const {
    ExcitationSample sample;
    for (std::size_t i = 0; i < record.channels[0].size(); ++i) {
      signal(first + static_cast<double>(i) / experiment_.sample_rate_hz, &sample);
      record.channels[0][i] = sample.value;
    }
  }

  void integrate(const Task& task, const ExcitationSignal& signal, double from, std::vector<double>& displacement,
                 std::vector<double>& velocity, double first, std::size_t count, Record& record,
                 double largest_step = 0) const {
    const std::size_t offset = experiment_.excitation ? 1 : 0;
    MotionSettings settings;
    settings.largest_step = largest_step;
    settings.label = fmt::format("{}, record {}", experiment_.file, task.record + 1);
    std::size_t i = 0;
    integrate_motion(model_, experiment_.parameters.data(), signal, from, displacement, velocity, first,
                     1 / experiment_.sample_rate_hz, count, settings, [&](const MotionSample& sample) {
                       for (std::size_t r = 0; r < experiment_.responses.size(); ++r)
                         record.channels[offset + r][i] = measured(r, sample);
                       ++i;
                     });
  }

  double measured(std::size_t r, const MotionSample& sample) const {
    const Quantity quantity = experiment_.responses[r].channel.quantity;
    const std::vector<double>& modal = quantity == Quantity::acceleration ? sample.acceleration
                                       : quantity == Quantity::velocity   ? sample.velocity
                                                                          : sample.displacement;
    if (!experiment_.modal_basis) return modal[r];
    double sum = 0;
    for (std::size_t k = 0; k < modal.size(); ++k)
      sum += experiment_.modal_basis->mass_normalised_shapes[r][k] * modal[k];
    return sum;
  }

  // Faults of the sensors, noise and quantisation, then into the campaign.
  void store(const Task& task, Record record) {
    std::vector<std::string> names;
    for (const Channel& channel : result_.campaign.channels) names.push_back(channel.name);
    apply_sensor_faults(experiment_.faults, names, experiment_.excitation.has_value(), record);
    for (std::size_t c = 0; c < record.channels.size(); ++c) {
      const bool excitation = experiment_.excitation && c == 0;
      const SimulatedChannel& sensor =
          excitation ? *experiment_.excitation : experiment_.responses[c - (experiment_.excitation ? 1 : 0)];
      NoiseStream noise(seed_, task.record, c);
      for (double& x : record.channels[c]) {
        if (sensor.noise_sd > 0) x += sensor.noise_sd * noise.gaussian();
      }
      clip(experiment_.faults, result_.campaign.channels[c].name, record.channels[c]);
      for (double& x : record.channels[c]) {
        if (sensor.quantisation > 0) x = sensor.quantisation * std::round(x / sensor.quantisation);
      }
    }
    result_.samples[task.record] = std::move(record);
  }

  const Experiment& experiment_;
  const CompiledModel& model_;
  std::uint64_t seed_;
  std::vector<Chain> chains_;
  SimulatedCampaign result_;
};

}  // namespace

SimulatedCampaign run_virtual_test(const Experiment& experiment, const CompiledModel& model, std::uint64_t seed,
                                   unsigned threads, const Progress& progress) {
  return VirtualTest(experiment, model, seed).run(threads, progress);
}

}  // namespace secular

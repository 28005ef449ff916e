// What an experiment file says is wrong: shaker, sensor faults, effects of the catalogue.
#include <algorithm>
#include <cmath>

#include "motion/simulate/experiment_parts.hpp"
#include "numerics/hertz.hpp"

namespace secular {
namespace {

SensorFault sensor_fault(const TomlTable& table, ChannelFault kind, const std::string& channel,
                         const Experiment& experiment) {
  SensorFault fault{kind, channel, 0};
  bool known = false;
  for (const SimulatedChannel& excitation : experiment.excitations)
    known = known || excitation.channel.name == fault.channel;
  for (const SimulatedChannel& response : experiment.responses)
    known = known || response.channel.name == fault.channel;
  if (!known) table.fail("channel", "'" + fault.channel + "' is no channel of this experiment");
  fault.strength = table.number("strength");
  if (fault.kind == ChannelFault::clipping && fault.strength <= 0)
    table.fail("strength", "is not positive", "the level at which the channel saturates");
  if (fault.kind == ChannelFault::skew && std::abs(fault.strength) * experiment.sample_rate_hz > 1000)
    table.fail("strength", "is more than 1000 samples", "seconds");
  if (fault.kind == ChannelFault::cross_axis && experiment.excitations.empty())
    table.fail("channel", "there is no excitation to pick up", "describe it in [excitation]");
  return fault;
}

ChannelFault fault_named(const TomlTable& table, const EffectCatalogue& catalogue) {
  const std::string name = table.string("effect");
  const Effect* effect = catalogue.find(name);
  if (effect && effect->kind == Effect::Kind::channel_fault) return effect->fault;
  std::vector<std::string_view> known;
  for (const Effect& e : catalogue.effects)
    if (e.kind == Effect::Kind::channel_fault) known.push_back(e.name);
  table.fail("effect", "is '" + name + "'", "one of " + listed(known));
}

// The stated shapes of two modes turned into each other by an angle.
void mix_shapes(const TomlTable& table, const ExperimentEffect& effect, const Target& target,
                Experiment& experiment) {
  if (!experiment.modal_basis || target.modes < 2)
    table.fail("name", "mode_shape_error needs a modal basis of two modes or more",
               "give [modal_basis] or the structure's bodies");
  const auto index = [&](const char* key, const std::string& coordinate, std::size_t otherwise) {
    if (coordinate.empty()) return otherwise;
    const auto found = std::find(target.coordinates.begin(), target.coordinates.end(), coordinate);
    if (found == target.coordinates.end())
      table.fail(key, "'" + coordinate + "' is no coordinate of the model",
                 "its coordinates are " + listed(target.coordinates));
    return static_cast<std::size_t>(found - target.coordinates.begin());
  };
  const std::size_t k = index("mode", effect.mode, 0), j = index("other", effect.other, k == 0 ? 1 : 0);
  if (j == k) table.fail("other", "is the same mode", "two modes");
  const double c = std::cos(effect.strength), s = std::sin(effect.strength);
  for (std::vector<double>& row : experiment.modal_basis->mass_normalised_shapes) {
    const double first = row[k], second = row[j];
    row[k] = c * first + s * second;
    row[j] = c * second - s * first;
  }
}

// What the simulation has to supply beside the equations of motion.
void supply_signal(const TomlTable& table, const ExperimentEffect& effect, const InstalledEffect& installed,
                   MotionSettings& motion) {
  const double shape = effect.shape.empty() ? 0 : effect.shape.back();
  switch (installed.law.kind) {
    case ForceLaw::Kind::none:
      break;
    case ForceLaw::Kind::time:
      motion.clocks.push_back(installed.signal);
      break;
    case ForceLaw::Kind::slider:
      motion.slip_elements.push_back({installed.mode, installed.signal, shape});
      break;
    case ForceLaw::Kind::spread_slider:
    case ForceLaw::Kind::smooth_slider:
      table.fail("name", "'" + effect.name + "' has a memory that is not integrated in time",
                 "a single spring and slider is");
    case ForceLaw::Kind::relaxation:
      motion.relaxing_elements.push_back({installed.mode, installed.signal, shape});
      break;
    case ForceLaw::Kind::level:
      motion.levels.push_back(installed.signal);
      break;
    case ForceLaw::Kind::state:
      motion.law_elements.push_back({installed.mode, installed.signal, installed.law.value, shape});
      break;
  }
}

void show_extra_mode(const TomlTable& table, const ExperimentEffect& effect, const InstalledEffect& installed,
                     Experiment& experiment) {
  if (effect.list.size() != experiment.responses.size())
    table.fail("shape", "has " + std::to_string(effect.list.size()) + " numbers",
               "one for each of the " + std::to_string(experiment.responses.size()) + " responses");
  for (std::size_t r = 0; r < effect.list.size(); ++r) {
    std::vector<double>& shape = experiment.responses[r].shape;
    shape.resize(std::max(shape.size(), installed.added_mode + 1), 0.0);
    shape[installed.added_mode] = effect.list[r];
  }
}

}  // namespace

void read_shaker(const TomlTable& root, const Target& target, Experiment& experiment) {
  if (!root.has("shaker")) return;
  const TomlTable table = root.table("shaker");
  table.refuse_unknown_keys({"harmonics", "armature_hz", "armature_damping", "feedback"});
  if (table.has("harmonics")) experiment.shaker_harmonics = table.numbers("harmonics");
  if (experiment.shaker_harmonics.size() > 20) table.fail("harmonics", "has more than 20 entries");
  if (!table.has("armature_hz")) {
    for (const char* const key : {"armature_damping", "feedback"})
      if (table.has(key)) table.fail(key, "stands without armature_hz", "the armature's natural frequency in Hz");
    return;
  }
  if (experiment.excitations.empty())
    table.fail("armature_hz", "there is no excitation", "describe it in [excitation]");
  Armature armature;
  armature.omega = two_pi * positive(table, "armature_hz");
  armature.damping = positive(table, "armature_damping");
  armature.feedback = by_mode(table, "feedback", target);
  experiment.motion.armature = std::move(armature);
}

void read_faults_and_effects(const TomlTable& root, const Target& target, const EffectCatalogue& catalogue,
                             Experiment& experiment) {
  for (const TomlTable& table : root.tables("fault")) {
    table.refuse_unknown_keys({"effect", "channel", "strength"});
    experiment.faults.push_back(
        sensor_fault(table, fault_named(table, catalogue), table.string("channel"), experiment));
  }
  const std::vector<TomlTable> tables = root.tables("effect");
  std::size_t next = 0;
  for (std::size_t i = 0; i < tables.size(); ++i) {
    const ExperimentEffect& effect = target.effects[i];
    switch (effect.kind) {
      case Effect::Kind::term:
      case Effect::Kind::open_law:
        supply_signal(tables[i], effect, target.installed[next++], experiment.motion);
        break;
      case Effect::Kind::extra_mode:
        show_extra_mode(tables[i], effect, target.installed[next++], experiment);
        break;
      case Effect::Kind::shaker_harmonics: {
        std::vector<double>& harmonics = experiment.shaker_harmonics;
        if (effect.list.size() > 20) tables[i].fail("harmonics", "has more than 20 entries");
        harmonics.resize(std::max(harmonics.size(), effect.list.size()), 0.0);
        for (std::size_t n = 0; n < effect.list.size(); ++n) harmonics[n] += effect.strength * effect.list[n];
        break;
      }
      case Effect::Kind::channel_fault:
        experiment.faults.push_back(sensor_fault(tables[i], effect.fault, effect.channel, experiment));
        break;
      case Effect::Kind::mode_shape_error:
        mix_shapes(tables[i], effect, target, experiment);
        break;
      case Effect::Kind::parameters:
        break;
    }
  }
}

}  // namespace secular

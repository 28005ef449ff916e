#include "simulate/experiment.hpp"

#include <algorithm>
#include <cmath>

#include "estimator/campaign/names.hpp"
#include "estimator/campaign/unit.hpp"
#include "input/input_error.hpp"
#include "input/toml_table.hpp"

namespace secular {
namespace {

std::string listed(std::span<const std::string_view> names) {
  std::string text;
  for (const std::string_view name : names) text += (text.empty() ? "" : ", ") + std::string(name);
  return text;
}

Eigen::VectorXd read_parameters(const TomlTable& table, const CompiledModel& model) {
  std::vector<std::string_view> known;
  for (const CompiledSymbol& symbol : model.symbols) known.push_back(symbol.name);
  table.refuse_unknown_keys(known);
  Eigen::VectorXd values(static_cast<Eigen::Index>(model.symbols.size()));
  for (std::size_t p = 0; p < model.symbols.size(); ++p) {
    const auto index = static_cast<Eigen::Index>(p);
    values(index) = table.has(known[p]) ? table.number(known[p]) : model.nominal[p];
    if (std::isnan(values(index))) table.fail(known[p], "is missing", "this model's symbols are " + listed(known));
    if (p < model.modes() && values(index) <= 0)
      table.fail(known[p], "is not positive", "a natural frequency in rad/s");
  }
  return values;
}

double not_negative(const TomlTable& table, std::string_view key) {
  const double value = table.optional_number(key).value_or(0);
  if (value < 0) table.fail(key, "is negative", "zero or a positive number was expected");
  return value;
}

SimulatedChannel read_channel(const TomlTable& table, ChannelRole role) {
  SimulatedChannel channel;
  channel.channel.name = table.string("name");
  channel.channel.role = role;
  const auto quantity = parse_quantity(table.string("quantity"));
  if (!quantity)
    table.fail("quantity", "is '" + table.string("quantity") + "'", std::string(quantity_list) + " was expected");
  channel.channel.quantity = *quantity;
  channel.channel.unit = table.string_or("unit", si_unit(*quantity));
  const std::string fault = unit_fault(*quantity, channel.channel.unit);
  if (!fault.empty()) table.fail("unit", fault);
  channel.noise_sd = not_negative(table, "noise_sd");
  channel.quantisation = not_negative(table, "quantisation");
  return channel;
}

void read_responses(const TomlTable& root, const CompiledModel& model, Experiment& experiment) {
  for (const TomlTable& table : root.tables("response")) {
    table.refuse_unknown_keys({"name", "quantity", "unit", "noise_sd", "quantisation", "coordinate"});
    SimulatedChannel channel = read_channel(table, ChannelRole::response);
    const Quantity quantity = channel.channel.quantity;
    const bool kinematic = quantity == Quantity::acceleration || quantity == Quantity::velocity ||
                           quantity == Quantity::displacement || quantity == Quantity::angle;
    if (!kinematic)
      table.fail("quantity", "is " + to_string(quantity),
                 "a simulated response is an acceleration, velocity, displacement or angle");
    if (table.has("coordinate")) {
      channel.coordinate = table.string("coordinate");
      if (std::find(model.coordinates.begin(), model.coordinates.end(), channel.coordinate) ==
          model.coordinates.end())
        table.fail("coordinate", "'" + channel.coordinate + "' is no coordinate of the model",
                   "its coordinates are " + listed(model.coordinates));
    }
    experiment.responses.push_back(std::move(channel));
  }
  if (experiment.responses.empty())
    root.fail("response", "there are no [[response]] channels", "describe at least one sensor");
  if (!root.has("modal_basis")) {
    if (experiment.responses.size() != model.modes())
      root.fail("response",
                "there are " + std::to_string(experiment.responses.size()) + " responses for " +
                    std::to_string(model.modes()) + " coordinates",
                "without [modal_basis] every response measures one coordinate, in order");
    for (std::size_t k = 0; k < model.modes(); ++k) {
      const std::string coordinate(model.coordinates[k]);
      if (experiment.responses[k].coordinate.empty()) experiment.responses[k].coordinate = coordinate;
      if (experiment.responses[k].coordinate != coordinate)
        root.fail("response", "responses are not in the order of the coordinates",
                  "their order is " + listed(model.coordinates));
    }
    return;
  }
  const TomlTable table = root.table("modal_basis");
  table.refuse_unknown_keys({"mass_normalised_shapes"});
  ModalBasis basis;
  for (const SimulatedChannel& channel : experiment.responses) basis.channels.push_back(channel.channel.name);
  for (const std::string_view coordinate : model.coordinates) basis.modes.emplace_back(coordinate);
  basis.mass_normalised_shapes = table.number_rows("mass_normalised_shapes");
  bool fits = basis.mass_normalised_shapes.size() == experiment.responses.size();
  for (const std::vector<double>& row : basis.mass_normalised_shapes) fits = fits && row.size() == model.modes();
  if (!fits)
    table.fail("mass_normalised_shapes", "has the wrong shape",
               std::to_string(experiment.responses.size()) + " rows (responses) of " +
                   std::to_string(model.modes()) + " numbers (modes) were expected");
  experiment.modal_basis = std::move(basis);
}

std::vector<double> by_mode(const TomlTable& table, std::string_view key, const CompiledModel& model) {
  if (!table.has(key)) return std::vector<double>(model.modes(), 0.0);
  std::vector<double> values = table.numbers(key);
  if (values.size() != model.modes())
    table.fail(key, "has " + std::to_string(values.size()) + " numbers",
               "one for every coordinate: " + listed(model.coordinates));
  return values;
}

double positive(const TomlTable& table, std::string_view key, std::optional<double> fallback = {}) {
  const double value = fallback && !table.has(key) ? *fallback : table.number(key);
  if (value <= 0) table.fail(key, "is not positive", "a positive number was expected");
  return value;
}

double frequency(const TomlTable& table, std::string_view key, double sample_rate_hz) {
  const double value = table.number(key);
  if (value <= 0 || value >= 0.5 * sample_rate_hz)
    table.fail(key, "is outside (0, half the sample rate)", "a frequency that the record can hold");
  return value;
}

SignalProgramme read_sweep(const TomlTable& table, double sample_rate_hz) {
  table.refuse_unknown_keys(
      {"from_hz", "to_hz", "rate_hz_per_s", "amplitude", "settle_s", "initial_displacement", "group"});
  SignalProgramme sweep;
  sweep.kind = SignalProgramme::Kind::sweep;
  sweep.low_hz = frequency(table, "from_hz", sample_rate_hz);
  sweep.high_hz = frequency(table, "to_hz", sample_rate_hz);
  if (sweep.low_hz == sweep.high_hz) table.fail("to_hz", "equals from_hz", "a sweep goes somewhere");
  sweep.rate_hz_per_s = std::copysign(positive(table, "rate_hz_per_s"), sweep.high_hz - sweep.low_hz);
  sweep.duration_s = (sweep.high_hz - sweep.low_hz) / sweep.rate_hz_per_s;
  sweep.amplitude = positive(table, "amplitude");
  sweep.settle_s = positive(table, "settle_s", 60.0);
  return sweep;
}

SignalProgramme read_impact(const TomlTable& table) {
  table.refuse_unknown_keys({"peak", "at_s", "width_s", "duration_s", "initial_displacement", "group"});
  SignalProgramme impact;
  impact.kind = SignalProgramme::Kind::impact;
  impact.amplitude = positive(table, "peak");
  impact.at_s = not_negative(table, "at_s");
  impact.width_s = positive(table, "width_s");
  impact.duration_s = positive(table, "duration_s");
  return impact;
}

SignalProgramme read_broadband(const TomlTable& table, double sample_rate_hz) {
  table.refuse_unknown_keys(
      {"low_hz", "high_hz", "lines", "rms", "seed", "settle_s", "duration_s", "initial_displacement", "group"});
  SignalProgramme broadband;
  broadband.kind = SignalProgramme::Kind::broadband;
  broadband.low_hz = frequency(table, "low_hz", sample_rate_hz);
  broadband.high_hz = frequency(table, "high_hz", sample_rate_hz);
  if (broadband.high_hz <= broadband.low_hz) table.fail("high_hz", "is not above low_hz", "a band was expected");
  const std::int64_t lines = table.has("lines") ? table.integer("lines") : 200;
  if (lines < 2 || lines > 10000) table.fail("lines", "is out of range", "2 to 10000 cosines");
  broadband.lines = static_cast<std::size_t>(lines);
  const std::int64_t seed = table.has("seed") ? table.integer("seed") : 1;
  if (seed < 0) table.fail("seed", "is negative", "zero or a positive integer");
  broadband.seed = static_cast<std::uint64_t>(seed);
  broadband.amplitude = positive(table, "rms");
  broadband.settle_s = not_negative(table, "settle_s");
  broadband.duration_s = positive(table, "duration_s");
  return broadband;
}

void read_signals(const TomlTable& root, const CompiledModel& model, Experiment& experiment) {
  const auto add = [&](const TomlTable& table, const SignalProgramme& programme) {
    if (!experiment.excitation)
      table.fail("group", "an excited record needs an excitation channel", "describe it in [excitation]");
    if (model.excitations.size() != 1)
      table.fail("group", "the model has several excitations", "records are simulated for one excitation");
    experiment.signals.push_back(programme);
    experiment.signals.back().initial_displacement = by_mode(table, "initial_displacement", model);
    experiment.signals.back().group = table.string_or("group", "");
  };
  for (const TomlTable& table : root.tables("sweep")) add(table, read_sweep(table, experiment.sample_rate_hz));
  for (const TomlTable& table : root.tables("impact")) add(table, read_impact(table));
  for (const TomlTable& table : root.tables("broadband"))
    add(table, read_broadband(table, experiment.sample_rate_hz));
}

void read_faults(const TomlTable& root, Experiment& experiment) {
  static const std::map<std::string, SensorFault::Kind> kinds = {
      {"sensor_gain", SensorFault::Kind::gain},
      {"sensor_offset", SensorFault::Kind::offset},
      {"sensor_cross_axis", SensorFault::Kind::cross_axis},
      {"channel_skew", SensorFault::Kind::skew},
      {"clipping", SensorFault::Kind::clipping}};
  if (root.has("shaker")) {
    const TomlTable table = root.table("shaker");
    table.refuse_unknown_keys({"harmonics"});
    experiment.shaker_harmonics = table.numbers("harmonics");
    if (experiment.shaker_harmonics.size() > 20) table.fail("harmonics", "has more than 20 entries");
  }
  for (const TomlTable& table : root.tables("fault")) {
    table.refuse_unknown_keys({"effect", "channel", "strength"});
    SensorFault fault;
    const auto kind = kinds.find(table.string("effect"));
    if (kind == kinds.end())
      table.fail("effect", "is '" + table.string("effect") + "'",
                 "sensor_gain, sensor_offset, sensor_cross_axis, channel_skew or clipping");
    fault.kind = kind->second;
    fault.channel = table.string("channel");
    bool known = experiment.excitation && experiment.excitation->channel.name == fault.channel;
    for (const SimulatedChannel& response : experiment.responses)
      known = known || response.channel.name == fault.channel;
    if (!known) table.fail("channel", "'" + fault.channel + "' is no channel of this experiment");
    fault.strength = table.number("strength");
    if (fault.kind == SensorFault::Kind::clipping && fault.strength <= 0)
      table.fail("strength", "is not positive", "the level at which the channel saturates");
    if (fault.kind == SensorFault::Kind::skew && std::abs(fault.strength) * experiment.sample_rate_hz > 1000)
      table.fail("strength", "is more than 1000 samples", "seconds");
    if (fault.kind == SensorFault::Kind::cross_axis && !experiment.excitation)
      table.fail("effect", "needs an excitation channel", "describe it in [excitation]");
    experiment.faults.push_back(std::move(fault));
  }
}

}  // namespace

std::string experiment_model(const std::filesystem::path& path) {
  return TomlTable::from_file(path).string("model");
}

Experiment read_experiment(const std::filesystem::path& path, const CompiledModel& model) {
  const TomlTable root = TomlTable::from_file(path);
  root.refuse_unknown_keys({"schema", "name", "source", "model", "parameters", "sample_rate_hz", "excitation",
                            "response", "modal_basis", "dwell", "free_decay", "sweep", "impact", "broadband",
                            "shaker", "fault"});
  if (root.integer("schema") != 1) root.fail("schema", "is not 1", "this program reads schema 1");
  Experiment experiment;
  experiment.file = path.string();
  experiment.name = root.string("name");
  experiment.model = root.string("model");
  experiment.parameters = read_parameters(root.table("parameters"), model);
  experiment.sample_rate_hz = positive(root, "sample_rate_hz");
  if (root.has("excitation")) {
    const TomlTable table = root.table("excitation");
    table.refuse_unknown_keys({"name", "quantity", "unit", "noise_sd", "quantisation"});
    if (model.excitations.empty()) root.fail("excitation", "the model has no excitation", "remove this table");
    experiment.excitation = read_channel(table, ChannelRole::excitation);
  }
  read_responses(root, model, experiment);
  for (const TomlTable& table : root.tables("dwell")) {
    table.refuse_unknown_keys({"frequencies_hz", "amplitudes", "ensembles", "ensemble_s", "settle_s", "carry_state",
                               "initial_displacement", "group"});
    if (!experiment.excitation)
      table.fail("frequencies_hz", "a dwell needs an excitation channel", "describe it in [excitation]");
    if (model.excitations.size() != 1)
      table.fail("frequencies_hz", "the model has several excitations", "dwells are simulated for one excitation");
    DwellProgramme dwell;
    dwell.frequencies_hz = table.numbers("frequencies_hz");
    dwell.amplitudes = table.numbers("amplitudes");
    for (const double f : dwell.frequencies_hz)
      if (f <= 0 || f >= 0.5 * experiment.sample_rate_hz)
        table.fail("frequencies_hz", "holds a frequency outside (0, half the sample rate)", "correct it");
    for (const double a : dwell.amplitudes)
      if (a <= 0) table.fail("amplitudes", "holds an amplitude that is not positive", "correct it");
    if (dwell.frequencies_hz.empty() || dwell.amplitudes.empty())
      table.fail("amplitudes", "nothing to run", "give at least one frequency and amplitude");
    dwell.ensembles = static_cast<int>(table.has("ensembles") ? table.integer("ensembles") : 1);
    if (dwell.ensembles < 1 || dwell.ensembles > 10000) table.fail("ensembles", "is out of range", "1 to 10000");
    dwell.ensemble_s = positive(table, "ensemble_s", 4.0);
    dwell.settle_s = positive(table, "settle_s", 60.0);
    dwell.carry_state = table.boolean_or("carry_state", false);
    dwell.initial_displacement = by_mode(table, "initial_displacement", model);
    dwell.group = table.string_or("group", "");
    experiment.dwells.push_back(std::move(dwell));
  }
  for (const TomlTable& table : root.tables("free_decay")) {
    table.refuse_unknown_keys({"initial_displacement", "initial_velocity", "duration_s", "group"});
    FreeDecayProgramme decay;
    decay.initial_displacement = by_mode(table, "initial_displacement", model);
    decay.initial_velocity = by_mode(table, "initial_velocity", model);
    decay.duration_s = positive(table, "duration_s");
    decay.group = table.string_or("group", "");
    experiment.free_decays.push_back(std::move(decay));
  }
  read_signals(root, model, experiment);
  read_faults(root, experiment);
  if (experiment.dwells.empty() && experiment.free_decays.empty() && experiment.signals.empty())
    root.fail("dwell", "nothing to run", "add a [[dwell]], [[free_decay]], [[sweep]], [[impact]] or [[broadband]]");
  return experiment;
}

}  // namespace secular

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

}  // namespace

std::string experiment_model(const std::filesystem::path& path) {
  return TomlTable::from_file(path).string("model");
}

Experiment read_experiment(const std::filesystem::path& path, const CompiledModel& model) {
  const TomlTable root = TomlTable::from_file(path);
  root.refuse_unknown_keys({"schema", "name", "source", "model", "parameters", "sample_rate_hz", "excitation",
                            "response", "modal_basis", "dwell", "free_decay"});
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
  if (experiment.dwells.empty() && experiment.free_decays.empty())
    root.fail("dwell", "nothing to run", "add a [[dwell]] or a [[free_decay]]");
  return experiment;
}

}  // namespace secular

// Sensors of an experiment file: channels, where they sit or which shapes they see, filters.
#include <algorithm>
#include <cmath>

#include "input/nearest_word.hpp"
#include "measure/formats/quantity.hpp"
#include "measure/formats/unit.hpp"
#include "motion/simulate/experiment_parts.hpp"
#include "motion/simulate/sensor_placement.hpp"

namespace secular {
namespace {

// Shapes of the model's own modes by [modal_basis].
std::vector<std::vector<double>> listed_shapes(const TomlTable& root, const Target& target, std::size_t responses) {
  const TomlTable table = root.table("modal_basis");
  table.refuse_unknown_keys({"mass_normalised_shapes"});
  std::vector<std::vector<double>> shapes = table.number_rows("mass_normalised_shapes");
  bool fits = shapes.size() == responses;
  for (const std::vector<double>& row : shapes) fits = fits && row.size() == target.modes;
  if (!fits)
    table.fail("mass_normalised_shapes", "has the wrong shape",
               std::to_string(responses) + " rows (responses) of " + std::to_string(target.modes) +
                   " numbers (modes) were expected");
  return shapes;
}

// Without mode shapes every response measures one coordinate, in order.
void bind_coordinates(const TomlTable& root, const Target& target, Experiment& experiment) {
  if (experiment.responses.size() != target.modes)
    root.fail("response",
              "there are " + std::to_string(experiment.responses.size()) + " responses for " +
                  std::to_string(target.modes) + " coordinates",
              "without [modal_basis] every response measures one coordinate, in order");
  for (std::size_t k = 0; k < target.modes; ++k) {
    SimulatedChannel& response = experiment.responses[k];
    const std::string coordinate(target.coordinates[k]);
    if (response.coordinate.empty()) response.coordinate = coordinate;
    if (response.coordinate != coordinate)
      root.fail("response", "responses are not in the order of the coordinates",
                "their order is " + listed(target.coordinates));
    response.shape.assign(target.modes, 0.0);
    response.shape[k] = 1;
  }
}

void state_modal_basis(const Target& target, Experiment& experiment) {
  ModalBasis basis;
  for (const SimulatedChannel& channel : experiment.responses) {
    basis.channels.push_back(channel.channel.name);
    basis.mass_normalised_shapes.push_back(channel.shape);
  }
  for (const std::string_view coordinate : target.coordinates) basis.modes.emplace_back(coordinate);
  experiment.modal_basis = std::move(basis);
}

}  // namespace

SimulatedChannel read_channel(const TomlTable& table, ChannelRole role) {
  SimulatedChannel channel;
  channel.channel.name = table.string("name");
  channel.channel.role = role;
  const auto quantity = parse_quantity(table.string("quantity"));
  if (!quantity)
    table.fail("quantity", "is '" + table.string("quantity") + "'",
               remedy_for_word(std::string(quantity_list) + " was expected", table.string("quantity"),
                               words_of(quantity_names)));
  channel.channel.quantity = *quantity;
  channel.channel.unit = table.string_or("unit", si_unit(*quantity));
  const std::string fault = unit_fault(*quantity, channel.channel.unit);
  if (!fault.empty()) table.fail("unit", fault);
  channel.noise_sd = not_negative(table, "noise_sd");
  channel.quantisation = not_negative(table, "quantisation");
  channel.high_pass_hz = not_negative(table, "high_pass_hz");
  return channel;
}

void read_responses(const TomlTable& root, const Target& target, Experiment& experiment) {
  const Structure structure = read_structure(root, target.modes);
  for (const TomlTable& table : root.tables("response")) {
    table.refuse_unknown_keys({"name", "quantity", "unit", "noise_sd", "quantisation", "high_pass_hz", "coordinate",
                               "body", "position", "orientation"});
    SimulatedChannel channel = read_channel(table, ChannelRole::response);
    const Quantity quantity = channel.channel.quantity;
    const bool kinematic = quantity == Quantity::acceleration || quantity == Quantity::velocity ||
                           quantity == Quantity::displacement || quantity == Quantity::angle;
    if (!kinematic)
      table.fail("quantity", "is " + to_string(quantity),
                 "a simulated response is an acceleration, velocity, displacement or angle");
    if (table.has("coordinate")) {
      channel.coordinate = table.string("coordinate");
      if (std::find(target.coordinates.begin(), target.coordinates.end(), channel.coordinate) ==
          target.coordinates.end())
        table.fail("coordinate", "'" + channel.coordinate + "' is no coordinate of the model",
                   "its coordinates are " + listed(target.coordinates));
    }
    if (structure.bodies.empty() != !table.has("body"))
      table.fail(table.has("body") ? "body" : "name", table.has("body") ? "there is no [[body]]" : "has no `body`",
                 "with bodies every response has body, position and orientation");
    if (table.has("body")) {
      Placement placement = read_placement(table, structure);
      channel.shape = std::move(placement.shape);
      if (std::abs(placement.base) > 1e-12 && quantity != Quantity::acceleration)
        table.fail("orientation", "sees the base's motion", "such a sensor must be an accelerometer");
      channel.base = placement.base;
    }
    experiment.responses.push_back(std::move(channel));
  }
  if (experiment.responses.empty())
    root.fail("response", "there are no [[response]] channels", "describe at least one sensor");
  if (!structure.bodies.empty()) {
    if (root.has("modal_basis"))
      root.fail("modal_basis", "stands beside [[body]]", "the shapes follow from the bodies");
    if (experiment.responses.size() >= target.modes) state_modal_basis(target, experiment);
  } else if (root.has("modal_basis")) {
    const auto shapes = listed_shapes(root, target, experiment.responses.size());
    for (std::size_t r = 0; r < shapes.size(); ++r) experiment.responses[r].shape = shapes[r];
    state_modal_basis(target, experiment);
  } else {
    bind_coordinates(root, target, experiment);
  }
}

void read_anti_alias(const TomlTable& root, Experiment& experiment) {
  if (!root.has("anti_alias")) return;
  const TomlTable table = root.table("anti_alias");
  table.refuse_unknown_keys({"filter", "poles", "cut_off_hz", "oversampling"});
  AntiAliasFilter filter;
  const std::string kind = table.string("filter");
  if (kind != "butterworth" && kind != "elliptic")
    table.fail("filter", "is '" + kind + "'", "butterworth or elliptic was expected");
  filter.kind = kind == "elliptic" ? AntiAliasFilter::Kind::elliptic : AntiAliasFilter::Kind::butterworth;
  const std::int64_t poles = table.has("poles") ? table.integer("poles") : 8;
  if (poles < 2 || poles > 12 || poles % 2 != 0) table.fail("poles", "is out of range", "2, 4, ... 12");
  filter.poles = static_cast<std::size_t>(poles);
  filter.cut_off_hz = frequency(table, "cut_off_hz", experiment.sample_rate_hz);
  const std::int64_t oversampling = table.has("oversampling") ? table.integer("oversampling") : 8;
  if (oversampling < 2 || oversampling > 64) table.fail("oversampling", "is out of range", "2 to 64");
  filter.oversampling = static_cast<std::size_t>(oversampling);
  experiment.anti_alias = filter;
}

}  // namespace secular

#include "motion/simulate/experiment_effects.hpp"

#include <algorithm>
#include <string_view>

#include "numerics/hertz.hpp"

namespace secular {
namespace {

using Kind = Effect::Kind;

const Effect& named(const TomlTable& table, const std::string& name, const EffectCatalogue& catalogue) {
  const Effect* effect = catalogue.find(name);
  if (effect && effect->kind != Kind::open_law) return *effect;
  std::string known;
  for (const Effect& e : catalogue.effects)
    if (e.kind != Kind::open_law) known += (known.empty() ? "" : ", ") + e.name;
  table.fail("name", "'" + name + "' is no effect of the catalogue", "known are " + known);
}

double shape_parameter(const TomlTable& table, std::string_view key) {
  const double value = table.number(key);
  if (value <= 0) table.fail(key, "is not positive", "a positive number");
  return value;
}

void read_term(const TomlTable& table, const Effect& row, ExperimentEffect& effect) {
  const bool couples = row.forms.front().couples(), several = couples && row.forms.size() > 1;
  const std::int64_t form = several && table.has("form") ? table.integer("form") : 0;
  if (form < 0 || form >= static_cast<std::int64_t>(row.forms.size()))
    table.fail("form", "is " + std::to_string(form), "the catalogue counts an effect's forms from 0");
  const EffectForm& term = row.forms[static_cast<std::size_t>(form)];
  std::vector<std::string> keys = term.parameter_names();
  keys.erase(keys.begin());  // the strength has a key of its own
  std::vector<std::string_view> allowed = {"name", "strength", "mode"};
  if (couples) allowed.push_back("other");
  if (several) allowed.push_back("form");
  allowed.insert(allowed.end(), keys.begin(), keys.end());
  table.refuse_unknown_keys(allowed);
  effect.mode = table.string_or("mode", "");
  if (couples) effect.other = table.string_or("other", "");
  if (several && table.has("form")) effect.form = std::to_string(form);
  if (!effect.form.empty() && effect.other.empty()) table.fail("form", "stands without `other`", "name both modes");
  for (const std::string& key : keys) {
    const double value = shape_parameter(table, key), most = term.shape(effect.shape.size()).most;
    if (most > 0 && value > most)
      table.fail(key, "is too large", "a number up to " + std::to_string(static_cast<int>(most)));
    effect.shape.push_back(value);
  }
}

ExperimentEffect read_effect(const TomlTable& table, const EffectCatalogue& catalogue) {
  ExperimentEffect effect;
  effect.name = table.string("name");
  const Effect& row = named(table, effect.name, catalogue);
  effect.kind = row.kind;
  effect.fault = row.fault;
  effect.file = table.file();
  effect.line = table.line_of("name");
  switch (row.kind) {
    case Kind::open_law:
    case Kind::term:
      read_term(table, row, effect);
      break;
    case Kind::extra_mode:
      table.refuse_unknown_keys({"name", "strength", "frequency_hz", "damping", "shape"});
      effect.shape = {two_pi * shape_parameter(table, "frequency_hz"), table.number("damping")};
      if (effect.shape[1] < 0) table.fail("damping", "is negative", "zero or a positive number");
      effect.list = table.numbers("shape");
      break;
    case Kind::shaker_harmonics:
      table.refuse_unknown_keys({"name", "strength", "harmonics"});
      effect.list = table.has("harmonics") ? table.numbers("harmonics") : std::vector<double>{1.0};
      break;
    case Kind::channel_fault:
      table.refuse_unknown_keys({"name", "strength", "channel"});
      effect.channel = table.string("channel");
      break;
    case Kind::mode_shape_error:
      table.refuse_unknown_keys({"name", "strength", "mode", "other"});
      effect.mode = table.string_or("mode", "");
      effect.other = table.string_or("other", "");
      break;
    case Kind::parameters:
      table.refuse_unknown_keys({"name", "strength", "symbol"});
      effect.symbol = table.string("symbol");
      break;
  }
  effect.strength = table.number("strength");
  if (!effect.other.empty() && effect.mode.empty()) table.fail("other", "stands without `mode`", "name both modes");
  return effect;
}

}  // namespace

std::vector<ExperimentEffect> read_experiment_effects(const TomlTable& root, const EffectCatalogue& catalogue) {
  std::vector<ExperimentEffect> result;
  for (const TomlTable& table : root.tables("effect")) result.push_back(read_effect(table, catalogue));
  return result;
}

std::vector<ExperimentEffect> read_experiment_effects(const std::filesystem::path& path,
                                                      const EffectCatalogue& catalogue) {
  return read_experiment_effects(TomlTable::from_file(path), catalogue);
}

}  // namespace secular

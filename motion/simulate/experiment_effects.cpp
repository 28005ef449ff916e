#include "motion/simulate/experiment_effects.hpp"

#include <algorithm>
#include <array>
#include <string_view>

#include "numerics/hertz.hpp"

namespace secular {
namespace {

using Kind = ExperimentEffect::Kind;

/// An effect's name and the keys it takes besides name and strength.
struct EffectKeys {
  std::string_view name;
  Kind kind = Kind::motion;
  bool couples = false;                        ///< has `other`
  std::array<std::string_view, 2> shape = {};  ///< positive shape parameters, in the catalogue's order
  std::string_view extra = {};                 ///< one more key
};

constexpr auto effects = std::to_array<EffectKeys>({
    {"viscous_damping"},
    {"quadratic_damping"},
    {"cubic_damping"},
    {"coulomb_friction"},
    {"amplitude_dependent_damping"},
    {"quadratic_stiffness"},
    {"cubic_stiffness"},
    {"quintic_stiffness"},
    {"bilinear_stiffness"},
    {"freeplay", Kind::motion, false, {"gap"}},
    {"quadratic_inertia"},
    {"cubic_inertia"},
    {"hysteresis", Kind::motion, false, {"slip"}},
    {"direct_excitation"},
    {"parametric_excitation"},
    {"damping_coupling", Kind::motion, true},
    {"quadratic_coupling", Kind::motion, true},
    {"cubic_coupling", Kind::motion, true, {}, "form"},
    {"parametric_coupling", Kind::motion, true},
    {"extra_mode", Kind::motion, false, {"frequency_hz", "damping"}, "shape"},
    {"natural_frequency_drift"},
    {"shaker_harmonics", Kind::shaker_harmonics, false, {}, "harmonics"},
    {"sensor_gain", Kind::sensor_fault},
    {"sensor_offset", Kind::sensor_fault},
    {"sensor_cross_axis", Kind::sensor_fault},
    {"channel_skew", Kind::sensor_fault},
    {"clipping", Kind::sensor_fault},
    {"mode_shape_error", Kind::mode_shape_error, true},
    {"parameters", Kind::parameters, false, {}, "symbol"},
});

ExperimentEffect read_effect(const TomlTable& table) {
  ExperimentEffect effect;
  effect.name = table.string("name");
  const auto keys =
      std::find_if(effects.begin(), effects.end(), [&](const EffectKeys& e) { return e.name == effect.name; });
  if (keys == effects.end()) {
    std::string known;
    for (const EffectKeys& e : effects) known += (known.empty() ? "" : ", ") + std::string(e.name);
    table.fail("name", "'" + effect.name + "' is no effect of the catalogue", "known are " + known);
  }
  effect.kind = keys->kind;
  effect.file = table.file();
  effect.line = table.line_of("name");
  const bool of_mode = (effect.kind == Kind::motion && effect.name != "extra_mode") || keys->couples;
  std::vector<std::string_view> allowed = {"name", "strength"};
  if (of_mode) allowed.push_back("mode");
  if (keys->couples) allowed.push_back("other");
  if (effect.kind == Kind::sensor_fault) allowed.push_back("channel");
  for (const std::string_view key : keys->shape)
    if (!key.empty()) allowed.push_back(key);
  if (!keys->extra.empty()) allowed.push_back(keys->extra);
  table.refuse_unknown_keys(allowed);
  effect.strength = table.number("strength");
  if (of_mode) effect.mode = table.string_or("mode", "");
  if (keys->couples) effect.other = table.string_or("other", "");
  if (!effect.other.empty() && effect.mode.empty()) table.fail("other", "stands without `mode`", "name both modes");
  if (effect.kind == Kind::sensor_fault) effect.channel = table.string("channel");
  if (keys->extra == "symbol") effect.symbol = table.string("symbol");
  if (keys->extra == "form" && table.has("form")) effect.form = std::to_string(table.integer("form"));
  for (const std::string_view key : keys->shape) {
    if (key.empty()) continue;
    const double value = table.number(key);
    if (value < 0 || (value == 0 && key != "damping")) table.fail(key, "is not positive", "a positive number");
    effect.shape.push_back(key == "frequency_hz" ? two_pi * value : value);
  }
  if (keys->extra == "shape") effect.list = table.numbers("shape");
  if (keys->extra == "harmonics")
    effect.list = table.has("harmonics") ? table.numbers("harmonics") : std::vector<double>{1.0};
  return effect;
}

}  // namespace

std::vector<ExperimentEffect> read_experiment_effects(const TomlTable& root) {
  std::vector<ExperimentEffect> result;
  for (const TomlTable& table : root.tables("effect")) result.push_back(read_effect(table));
  return result;
}

std::vector<ExperimentEffect> read_experiment_effects(const std::filesystem::path& path) {
  return read_experiment_effects(TomlTable::from_file(path));
}

}  // namespace secular

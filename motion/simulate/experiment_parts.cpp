#include "motion/simulate/experiment_parts.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace secular {

std::string listed(std::span<const std::string_view> names) {
  return fmt::format("{}", fmt::join(names, ", "));
}

Target target_of(const TomlTable& root, const CompiledModel& model, std::span<const InstalledEffect> installed,
                 const EffectCatalogue& catalogue) {
  Target target{model, installed, read_experiment_effects(root, catalogue), model.modes(), model.excitations.size(),
                {}};
  std::size_t motions = 0;
  for (const ExperimentEffect& effect : target.effects) {
    if (!effect.is_motion()) continue;
    if (motions == installed.size())
      throw InputError(effect.file, "line " + std::to_string(effect.line), effect.name + " is not in the model",
                       "equations of motion that hold this effect");
    const InstalledEffect& in = installed[motions++];
    if (in.added_mode != InstalledEffect::none) --target.modes;
    if (in.signal != InstalledEffect::none) --target.excitations;
  }
  target.coordinates.assign(model.coordinates.begin(),
                            model.coordinates.begin() + static_cast<std::ptrdiff_t>(target.modes));
  return target;
}

std::vector<double> by_mode(const TomlTable& table, std::string_view key, const Target& target) {
  std::vector<double> values(target.model.modes(), 0.0);
  if (!table.has(key)) return values;
  const std::vector<double> given = table.numbers(key);
  if (given.size() != target.modes)
    table.fail(key, "has " + std::to_string(given.size()) + " numbers",
               "one for every coordinate: " + listed(target.coordinates));
  std::copy(given.begin(), given.end(), values.begin());
  return values;
}

double positive(const TomlTable& table, std::string_view key, std::optional<double> fallback) {
  const double value = fallback && !table.has(key) ? *fallback : table.number(key);
  if (value <= 0) table.fail(key, "is not positive", "a positive number was expected");
  return value;
}

double not_negative(const TomlTable& table, std::string_view key) {
  const double value = table.optional_number(key).value_or(0);
  if (value < 0) table.fail(key, "is negative", "zero or a positive number was expected");
  return value;
}

double frequency(const TomlTable& table, std::string_view key, double sample_rate_hz) {
  const double value = table.number(key);
  if (value <= 0 || value >= 0.5 * sample_rate_hz)
    table.fail(key, "is outside (0, half the sample rate)", "a frequency that the record can hold");
  return value;
}

}  // namespace secular

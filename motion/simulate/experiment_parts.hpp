#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "input/input_error.hpp"
#include "input/toml_table.hpp"
#include "motion/simulate/experiment.hpp"

// Parts of read_experiment.
namespace secular {

/// The model as its file describes it, and what the experiment's motion effects have put behind that.
struct Target {
  const CompiledModel& model;
  std::span<const InstalledEffect> installed;
  std::vector<ExperimentEffect> effects;  ///< all of the file
  std::size_t modes = 0, excitations = 0;
  std::vector<std::string_view> coordinates;

  std::span<const std::string_view> excitation_names() const { return model.excitations.first(excitations); }
};

/// Throws InputError if `installed` lacks a motion effect of the file.
Target target_of(const TomlTable& root, const CompiledModel& model, std::span<const InstalledEffect> installed,
                 const EffectCatalogue& catalogue);

/// Calls use(effect, installed) for every motion effect.
template <class Use>
void each_motion_effect(const Target& target, const Use& use) {
  std::size_t next = 0;
  for (const ExperimentEffect& effect : target.effects)
    if (effect.is_motion()) use(effect, target.installed[next++]);
}

/// "a, b, c".
std::string listed(std::span<const std::string_view> names);

/// One number for every coordinate of the model; modes that effects add get 0. All 0 without the key.
std::vector<double> by_mode(const TomlTable& table, std::string_view key, const Target& target);
/// A number above zero (the key must be there without a fallback), and one not below it (0 without the key). Throw
/// InputError.
double positive(const TomlTable& table, std::string_view key, std::optional<double> fallback = {});
double not_negative(const TomlTable& table, std::string_view key);
/// In Hz, within what a record can hold.
double frequency(const TomlTable& table, std::string_view key, double sample_rate_hz);

/// Channels, mode shapes, filters: experiment_sensors.cpp.
SimulatedChannel read_channel(const TomlTable& table, ChannelRole role);
void read_responses(const TomlTable& root, const Target& target, Experiment& experiment);
void read_anti_alias(const TomlTable& root, Experiment& experiment);

/// [shaker], [[fault]], [[effect]]: experiment_faults.cpp. After channels and shapes.
void read_shaker(const TomlTable& root, const Target& target, Experiment& experiment);
void read_faults_and_effects(const TomlTable& root, const Target& target, const EffectCatalogue& catalogue,
                             Experiment& experiment);

}  // namespace secular

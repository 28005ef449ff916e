#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "effects/catalogue.hpp"
#include "input/toml_table.hpp"

namespace secular {

/// One [[effect]] of an experiment file: an effect of the catalogue switched on with a strength, which is an angle
/// of mode_shape_error, and the relative error of `parameters`.
struct ExperimentEffect {
  Effect::Kind kind = Effect::Kind::term;
  ChannelFault fault = ChannelFault::none;
  std::string name;
  std::string mode, other;  ///< coordinates; empty where the file names none
  std::string form;         ///< which term, of effects that have several; empty: the first
  double strength = 0;
  std::vector<double> shape;  ///< shape parameters, in the order of the catalogue
  std::vector<double> list;   ///< shaker_harmonics: amplitudes for strength 1; extra_mode: what every response sees
  std::string channel, symbol;
  std::string file;
  std::uint32_t line = 0;

  /// A term of the equations of motion, or a whole mode.
  bool is_motion() const { return kind == Effect::Kind::term || kind == Effect::Kind::extra_mode; }
};

/// A motion effect as it stands in the model: its symbols (strength first, then shape parameters), and the indices
/// of what it acts on or has added; none where that is not of this effect.
struct InstalledEffect {
  static constexpr std::size_t none = static_cast<std::size_t>(-1);
  std::vector<std::string> parameters;
  std::size_t mode = none;
  std::size_t signal = none;      ///< excitation whose signal the simulation supplies, by `law`
  std::size_t added_mode = none;  ///< extra_mode
  ForceLaw law = {};
};

/// The [[effect]] tables in file order. Throws InputError for names that are not in the catalogue (listing those
/// that are), for keys that an effect does not have and for one that it lacks.
std::vector<ExperimentEffect> read_experiment_effects(const TomlTable& root, const EffectCatalogue& catalogue);
/// Those of a file, before its model is known.
std::vector<ExperimentEffect> read_experiment_effects(const std::filesystem::path& path,
                                                      const EffectCatalogue& catalogue = effect_catalogue());

}  // namespace secular

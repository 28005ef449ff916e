#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "input/toml_table.hpp"

namespace secular {

/// One [[effect]] of an experiment file: an effect of the catalogue switched on with a strength.
struct ExperimentEffect {
  enum class Kind {
    motion,            ///< a term of the equations of motion, or a whole mode
    shaker_harmonics,  ///< `list`: amplitudes at 2, 3, ... times the frequency for strength 1
    sensor_fault,      ///< of `channel`
    mode_shape_error,  ///< the campaign's shapes of two modes are turned into each other by `strength` rad
    parameters,        ///< the model's number `symbol` is off by the factor 1 + strength
  };
  Kind kind = Kind::motion;
  std::string name;
  std::string mode, other;  ///< coordinates; empty where the file names none
  std::string form;         ///< which term, of effects that have several; empty: the first
  double strength = 0;
  std::vector<double> shape;  ///< shape parameters, in the order of the catalogue
  std::vector<double> list;   ///< harmonics; extra_mode: what every response sees of it
  std::string channel, symbol;
  std::string file;
  std::uint32_t line = 0;
};

/// A motion effect as it stands in the model: its symbols (strength first, then shape parameters), and the indices
/// of what it acts on or has added; none where that is not of this effect.
struct InstalledEffect {
  static constexpr std::size_t none = static_cast<std::size_t>(-1);
  std::vector<std::string> parameters;
  std::size_t mode = none;
  std::size_t memory = none;      ///< excitation whose signal the simulation supplies
  std::size_t added_mode = none;  ///< extra_mode
};

/// The [[effect]] tables in file order. Throws InputError for names that are not in the catalogue (listing those
/// that are), for keys that an effect does not have and for one that it lacks.
std::vector<ExperimentEffect> read_experiment_effects(const TomlTable& root);
std::vector<ExperimentEffect> read_experiment_effects(const std::filesystem::path& path);

}  // namespace secular

// A libFuzzer target for experiment files, read for a model of two modes and one excitation that has the symbols of
// the shipped ones. Build as in reader_fuzz.cpp, then
//   build/fuzz/tests/fuzz/experiment_fuzz -max_len=8192 -max_total_time=600 -dict=tests/fuzz/experiment.dict
//   NEW_FOLDER models/experiments tests/fuzz/corpus/experiment

#include <unistd.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string_view>
#include <vector>

#include "input/input_error.hpp"
#include "motion/simulate/experiment.hpp"
#include "motion/simulate/experiment_effects.hpp"

namespace {

constexpr std::string_view coordinates[] = {"v", "w"}, excitations[] = {"F"}, frequencies[] = {"Omega"};
constexpr secular::CompiledSymbol symbols[] = {{"omega0", {}}, {"omega1", {}}, {"mu1", {}},
                                               {"alpha3", {}}, {"eta1", {}},   {"coulomb", {}}};
constexpr double nominal[] = {77.85, 150, 0.2, 1e4, 1, 0};

secular::CompiledModel model() {
  secular::CompiledModel model{};
  model.name = "two_mass_mode1";
  model.coordinates = coordinates;
  model.excitations = excitations;
  model.excitation_frequencies = frequencies;
  model.symbols = symbols;
  model.nominal = nominal;
  return model;
}

void read(const std::filesystem::path& path) {
  secular::experiment_model(path);
  // Every effect of the motion stands in the model as a term of the first mode.
  std::vector<secular::InstalledEffect> installed;
  for (const secular::ExperimentEffect& effect : secular::read_experiment_effects(path))
    if (effect.is_motion()) installed.push_back({{"coulomb"}, 0});
  secular::read_experiment(path, model(), installed);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const std::filesystem::path file =
      std::filesystem::temp_directory_path() / ("secular_experiment_fuzz." + std::to_string(::getpid()) + ".toml");
  std::ofstream(file, std::ios::binary)
      .write(reinterpret_cast<const char*>(data), static_cast<std::streamsize>(size));
  try {
    read(file);
  } catch (const secular::InputError&) {  // the only exception that may come out
  }
  return 0;
}

// What `cmake --install --component program` (the package `secular`) puts somewhere runs from there.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

#include "tests/app/duffing_decay.hpp"
#include "tests/app/program_run.hpp"
#include "tests/places.hpp"
#include "tests/process_folder.hpp"

namespace secular {
namespace {

namespace fs = std::filesystem;
using testing_support::Outcome;
using testing_support::run_program;
using testing_support::RunOptions;
using testing_support::text_of;

// Models of one's own are compiled with the headers that came with the program, and interpreted where there is no
// compiler; both come to the same.
TEST(InstalledProgram, IdentifiesAModelOfOnesOwnWithAndWithoutACompiler) {
  const fs::path folder = testing_support::process_folder() / "installed",
                 build = fs::path(testing_support::program()).parent_path().parent_path();
  fs::create_directories(folder / "bare");
  const std::string install = "cmake --install " + build.string() + " --component program --prefix " +
                              (folder / "usr").string() + " > /dev/null";
  ASSERT_EQ(std::system(install.c_str()), 0) << install;
  for (const char* const text :
       {"share/man/man1/secular.1", "share/bash-completion/completions/secular",
        "share/zsh/vendor-completions/_secular", "share/fish/vendor_completions.d/secular.fish",
        "share/doc/secular/docs/glossary.md"})
    EXPECT_GT(fs::file_size(folder / "usr" / text), 1000U) << text;

  std::string model = text_of(testing_support::source_folder() / "models/duffing.toml");
  model.replace(model.find("\"duffing\""), 9, "\"my_duffing\"");
  std::ofstream(folder / "my_duffing.toml") << model;
  std::ofstream(folder / "decay.toml") << testing_support::duffing_decay();
  RunOptions installed;
  installed.program = (folder / "usr/bin/secular").string();
  const std::string cache = "XDG_CACHE_HOME=" + folder.string();
  const auto identified = [&](const std::string& environment, const std::string& out) {
    installed.environment = cache + " " + environment;
    const Outcome run =
        run_program(folder, "identify decay --model my_duffing.toml --case free -o " + out, installed);
    EXPECT_EQ(run.status, 0) << run.errors;
    EXPECT_EQ(run.errors.find("nterpreted") == std::string::npos, environment.empty()) << run.errors;
    return nlohmann::json::parse(text_of(folder / out / "estimate.json")).at("estimates");
  };
  installed.environment = cache;
  ASSERT_EQ(run_program(folder, "simulate decay.toml -o decay", installed).status, 0);
  const nlohmann::json compiled = identified("", "compiled"),
                       interpreted = identified("PATH=" + (folder / "bare").string(), "interpreted");
  ASSERT_EQ(compiled.size(), interpreted.size());
  for (std::size_t i = 0; i < compiled.size(); ++i)
    for (const char* const number : {"value", "sd"})
      if (compiled[i].at(number).is_number()) {
        const double expected = compiled[i].at(number).get<double>();
        EXPECT_NEAR(interpreted[i].at(number).get<double>(), expected, 1e-9 * std::abs(expected))
            << compiled[i].at("name");
      }
  fs::remove_all(folder);
}

}  // namespace
}  // namespace secular

#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

#include "tests/app/program_run.hpp"
#include "tests/process_folder.hpp"

namespace secular::testing_support {

/// A folder for as long as a test runs, and the program run in it, what it prints kept.
class DiagnosedFolder : public testing::Test {
 protected:
  void SetUp() override { std::filesystem::create_directories(folder_); }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  std::string path(const std::string& name) const { return (folder_ / name).string(); }

  int run(const std::string& arguments) const { return run_with_shared_cache(folder_, arguments).status; }

  /// What the last command printed.
  std::string printed() const { return text_of(folder_ / "stdout.txt") + text_of(folder_ / "stderr.txt"); }

  /// diagnosis.json of the folder's campaign with its model.toml; null where the program fails.
  nlohmann::json diagnosis(const std::string& options = "") const {
    if (run("diagnose " + path("campaign") + " --model " + path("model.toml") + " " + options + " --force -o " +
            path("out")) != 0)
      return {};
    std::ifstream in(folder_ / "out/diagnosis.json");
    return nlohmann::json::parse(in);
  }

  const std::filesystem::path folder_ =
      process_folder() / testing::UnitTest::GetInstance()->current_test_info()->name();
};

}  // namespace secular::testing_support

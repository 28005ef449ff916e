#pragma once

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

#include "tests/process_folder.hpp"

namespace secular::testing_support {

/// A folder for as long as a test runs, and the program run in it with a cache of its own, what it prints kept.
class DiagnosedFolder : public testing::Test {
 protected:
  void SetUp() override { std::filesystem::create_directories(folder_ / "cache"); }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  std::string path(const std::string& name) const { return (folder_ / name).string(); }

  int run(const std::string& arguments) const {
    return std::system(("XDG_CACHE_HOME=" + path("cache") + " " + SECULAR_PROGRAM + " " + arguments + " > " +
                        path("out.txt") + " 2>&1")
                           .c_str());
  }

  /// What the last command printed.
  std::string printed() const {
    std::ifstream in(folder_ / "out.txt");
    return {std::istreambuf_iterator<char>(in), {}};
  }

  /// diagnosis.json of the folder's campaign with its model.toml; null where the program fails.
  nlohmann::json diagnosis(const std::string& options = "") const {
    if (run("diagnose " + path("campaign") + " --model " + path("model.toml") + " " + options + " -o " +
            path("out")) != 0)
      return {};
    std::ifstream in(folder_ / "out/diagnosis.json");
    return nlohmann::json::parse(in);
  }

  const std::filesystem::path folder_ =
      process_folder() / testing::UnitTest::GetInstance()->current_test_info()->name();
};

}  // namespace secular::testing_support

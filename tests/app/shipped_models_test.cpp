#include "jobs/shared/shipped_models.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include "input/input_error.hpp"
#include "tests/places.hpp"
#include "tests/process_folder.hpp"

namespace secular::app {
namespace {

namespace fs = std::filesystem;

/// A folder of its own that SECULAR_MODELS names.
class ShippedModels : public testing::Test {
 protected:
  void SetUp() override {
    fs::create_directories(folder_ / "experiments");
    std::ofstream(folder_ / "own_model.toml") << "schema = 1\n";
    std::ofstream(folder_ / "experiments" / "own_test.toml") << "schema = 1\n";
  }
  void TearDown() override {
    ::unsetenv("SECULAR_MODELS");
    fs::remove_all(folder_);
  }
  fs::path folder_ = testing_support::process_folder() / "models";
};

TEST_F(ShippedModels, TheSourceTreesModelsAreFoundByName) {
  const fs::path expected = testing_support::source_folder() / "models" / "two_mass_mode1.toml";
  EXPECT_TRUE(fs::equivalent(resolve_model("two_mass_mode1"), expected));
  const std::vector<std::string> names = shipped_models();
  EXPECT_TRUE(std::is_sorted(names.begin(), names.end()));
  EXPECT_NE(std::find(names.begin(), names.end(), "two_mass_mode1"), names.end());
}

TEST_F(ShippedModels, APathIsTakenAsItIs) {
  const std::string path = (folder_ / "own_model.toml").string();
  EXPECT_EQ(resolve_model(path), path);
}

TEST_F(ShippedModels, TheEnvironmentComesFirst) {
  ::setenv("SECULAR_MODELS", folder_.c_str(), 1);
  EXPECT_EQ(resolve_model("own_model"), folder_ / "own_model.toml");
  EXPECT_EQ(resolve_model("experiments/own_test"), folder_ / "experiments" / "own_test.toml");
  EXPECT_EQ(shipped_models(), std::vector<std::string>{"own_model"});
  EXPECT_TRUE(fs::exists(resolve_model("two_mass_mode1"))) << "the other folders are still searched";
}

TEST_F(ShippedModels, AnUnknownNameListsTheShippedOnes) {
  for (const std::string& name : {std::string("no_such_model"), std::string(), folder_.string()}) try {
      resolve_model(name);
      FAIL() << name;
    } catch (const InputError& error) {
      EXPECT_EQ(error.file(), name);
      EXPECT_NE(error.right().find("two_mass_mode1"), std::string::npos) << error.what();
    }
}

TEST_F(ShippedModels, APathOfTheCallersFolderIsNoNameOfAShippedOne) {
  for (const std::string name : {"./own_modl", "../models/own_modl", "experiments/../own_modl"}) try {
      ::setenv("SECULAR_MODELS", folder_.c_str(), 1);
      resolve_model(name);
      FAIL() << name;
    } catch (const InputError& error) {
      EXPECT_EQ(error.wrong(), "neither a file nor the name of a shipped model") << name;
      EXPECT_EQ(error.right().rfind("shipped models: own_model", 0), 0U) << error.what();
    }
}

}  // namespace
}  // namespace secular::app

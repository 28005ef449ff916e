#include "report/whole_file.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "input/input_error.hpp"
#include "tests/process_folder.hpp"

namespace secular::report {
namespace {

namespace fs = std::filesystem;

class WholeFile : public testing::Test {
 protected:
  void SetUp() override { fs::create_directories(folder_); }
  void TearDown() override { fs::remove_all(folder_); }
  static std::string read(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
  }
  std::size_t files() const { return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder_), {})); }
  fs::path folder_ = testing_support::process_folder() / "whole-file";
};

TEST_F(WholeFile, ReplacesTheOldContent) {
  const std::string large(3'000'000, 'x');
  write_whole_file(folder_ / "a.txt", large);
  EXPECT_EQ(read(folder_ / "a.txt"), large);
  write_whole_file(folder_ / "a.txt", std::string("short\0text", 10));
  EXPECT_EQ(read(folder_ / "a.txt"), std::string("short\0text", 10));
  EXPECT_EQ(files(), 1u);
}

TEST_F(WholeFile, AFailureLeavesNothingAndNamesTheFile) {
  fs::create_directories(folder_ / "taken" / "inside");
  try {
    write_whole_file(folder_ / "taken", "text");
    FAIL() << "a folder was overwritten";
  } catch (const InputError& error) {
    EXPECT_EQ(error.file(), (folder_ / "taken").string());
  }
  EXPECT_EQ(files(), 1u);
  EXPECT_THROW(write_whole_file(folder_ / "missing" / "a.txt", "text"), InputError);
}

}  // namespace
}  // namespace secular::report

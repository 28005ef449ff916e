// Folders that appear whole or not at all.
#include "input/whole_folder.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <string>
#include <utility>

#include "input/input_error.hpp"
#include "tests/process_folder.hpp"

namespace secular {
namespace {

namespace fs = std::filesystem;

class WholeFolders : public testing::Test {
 protected:
  void SetUp() override { fs::create_directories(folder_); }
  void TearDown() override { fs::remove_all(folder_); }

  static void fill(const WholeFolder& folder, std::string text) {
    folder.write("a/b.txt", [&text] { return std::exchange(text, {}); });
  }
  std::string read(const std::string& name) const {
    std::ifstream stream(folder_ / name);
    return {std::istreambuf_iterator<char>(stream), {}};
  }
  std::size_t entries() const {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder_), fs::directory_iterator()));
  }

  fs::path folder_ = testing_support::process_folder() / "whole_folders";
};

TEST_F(WholeFolders, TakeAPlaceThatIsFreeOrEmpty) {
  for (const char* const name : {"new", "deep/er", "empty"}) {
    if (name == std::string("empty")) fs::create_directory(folder_ / name);
    WholeFolder folder(folder_ / name);
    fill(folder, "text");
    EXPECT_FALSE(fs::exists(folder_ / name / "a"));
    folder.finish();
    EXPECT_EQ(read(std::string(name) + "/a/b.txt"), "text");
  }
  EXPECT_EQ(entries(), 3U);
}

TEST_F(WholeFolders, ReplaceAnotherOneWhenToldTo) {
  fs::create_directory(folder_ / "old");
  std::ofstream(folder_ / "old/note.txt") << "old";
  {
    WholeFolder folder(folder_ / "old");
    fill(folder, "new");
    EXPECT_THROW(folder.finish(), InputError);
  }
  EXPECT_EQ(read("old/note.txt"), "old");
  EXPECT_EQ(entries(), 1U);
  fs::create_directory_symlink(folder_ / "old", folder_ / "link");
  WholeFolder folder(folder_ / "link");
  fill(folder, "new");
  folder.finish(true);
  EXPECT_TRUE(fs::is_symlink(folder_ / "link"));
  EXPECT_FALSE(fs::exists(folder_ / "old/note.txt"));
  EXPECT_EQ(read("old/a/b.txt"), "new");
  EXPECT_EQ(entries(), 2U);
}

TEST_F(WholeFolders, LeaveNothingUnlessFinished) {
  {
    const WholeFolder folder(folder_ / "deep/er/never");
    fill(folder, "text");
    EXPECT_EQ(entries(), 1U);
  }
  EXPECT_EQ(entries(), 0U);
  std::ofstream(folder_ / "file") << "mine";
  {
    WholeFolder folder(folder_ / "file");
    fill(folder, "text");
    EXPECT_THROW(folder.finish(true), InputError);
  }
  EXPECT_EQ(read("file"), "mine");
  EXPECT_EQ(entries(), 1U);
}

}  // namespace
}  // namespace secular

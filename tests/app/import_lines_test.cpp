// The import lines of docs/your_own_data.md, run as they stand there.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "tests/app/program_run.hpp"
#include "tests/places.hpp"
#include "tests/process_folder.hpp"

namespace secular {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> import_lines() {
  std::ifstream page(testing_support::source_folder() / "docs/your_own_data.md");
  std::vector<std::string> lines;
  bool inside = false;
  for (std::string line; std::getline(page, line);) {
    if (line.starts_with("#")) inside = line == "### Import lines";
    if (inside && line.starts_with("secular import ")) lines.push_back(line.substr(8));
  }
  return lines;
}

TEST(ImportLines, OfTheDocumentationAreRight) {
  const fs::path faults = testing_support::source_folder() / "../shared/faults";
  if (!fs::exists(faults)) GTEST_SKIP() << "../shared/faults is not there";
  const std::vector<std::string> lines = import_lines();
  EXPECT_GT(lines.size(), 15U);
  const fs::path folder = testing_support::process_folder() / "secular_import_lines";
  fs::create_directories(folder);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    std::string line = lines[i];
    line.insert(line.find(' ') + 1, faults.string() + "/");
    const std::string out = "-o " + (folder / std::to_string(i)).string();
    line.replace(line.find("-o out"), 6, out);
    const testing_support::Outcome outcome = testing_support::run_program(folder, line);
    EXPECT_EQ(outcome.status, 0) << lines[i] << "\n" << outcome.errors;
    EXPECT_TRUE(fs::exists(folder / std::to_string(i) / "campaign.toml")) << lines[i];
  }
  fs::remove_all(folder);
}

}  // namespace
}  // namespace secular

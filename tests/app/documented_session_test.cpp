// docs/first_steps.md as a reader types it: files are written, commands run, and what they print is what the page
// shows.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

#include "tests/app/program_run.hpp"
#include "tests/places.hpp"
#include "tests/process_folder.hpp"

namespace secular {
namespace {

namespace fs = std::filesystem;

// ```toml beam.toml is a file of that name, ```sh holds commands, ```text what the commands before it print.
struct PageBlock {
  std::string kind, file;
  std::vector<std::string> lines;
};

std::vector<PageBlock> blocks_of(const fs::path& page) {
  std::ifstream in(page);
  std::vector<PageBlock> blocks;
  bool inside = false;
  for (std::string line; std::getline(in, line);) {
    if (!line.starts_with("```")) {
      if (inside) blocks.back().lines.push_back(line);
      continue;
    }
    inside = !inside;
    if (!inside) continue;
    PageBlock block;
    std::istringstream(line.substr(3)) >> block.kind >> block.file;
    blocks.push_back(block);
  }
  return blocks;
}

std::vector<std::string> words_of(const std::string& line) {
  std::istringstream in(line);
  return {std::istream_iterator<std::string>(in), {}};
}

// One unit of a number's last digit: "4.0015(13)e+06," has 100.
double last_digit(const std::string& mantissa, const std::string& exponent) {
  const std::size_t point = mantissa.find('.');
  const double decimals = point == std::string::npos ? 0 : static_cast<double>(mantissa.size() - point - 1);
  return std::pow(10, (exponent.empty() ? 0 : std::stod(exponent)) - decimals);
}

// The same word, or the same but for one unit of a number's last digit, as another processor may round it.
bool prints_as(const std::string& shown, const std::string& printed) {
  if (shown == printed) return true;
  static const std::regex number(R"(([\[]?)(-?[0-9]+(?:\.[0-9]+)?)(?:\(([0-9]+)\))?(?:e([-+][0-9]+))?([\],;:]*))");
  std::smatch a, b;
  if (!std::regex_match(shown, a, number) || !std::regex_match(printed, b, number)) return false;
  if (a[1] != b[1] || a[4] != b[4] || a[5] != b[5] || a[3].matched != b[3].matched) return false;
  if (a[3].matched && std::abs(std::stod(a[3]) - std::stod(b[3])) > 1) return false;
  const double exponent = a[4].matched ? std::stod(a[4]) : 0;
  return std::abs(std::stod(a[2]) - std::stod(b[2])) * std::pow(10, exponent) <= 1.01 * last_digit(a[2], a[4]);
}

bool prints_line_as(const std::string& shown, const std::string& printed) {
  const std::vector<std::string> a = words_of(shown), b = words_of(printed);
  return std::ranges::equal(a, b, prints_as);
}

// Every line shown is one that was printed, in this order; others may stand between.
void expect_printed(const PageBlock& shown, const std::string& output) {
  std::istringstream in(output);
  for (const std::string& line : shown.lines) {
    if (line == "...") continue;
    std::string printed;
    bool found = false;
    while (!found && std::getline(in, printed)) found = prints_line_as(line, printed);
    ASSERT_TRUE(found) << "the page shows\n" << line << "\nand the program prints\n" << output;
  }
}

TEST(DocumentedSession, NumbersMayDifferInTheLastDigit) {
  EXPECT_TRUE(prints_line_as("mu   0.5999(25) 1/s", "mu 0.6000(24) 1/s"));
  EXPECT_FALSE(prints_line_as("mu   0.5999(25) 1/s", "mu 0.6002(25) 1/s"));
  EXPECT_TRUE(prints_line_as("a 4.0015(13)e+06, closes", "a 4.0014(13)e+06, closes"));
  EXPECT_FALSE(prints_line_as("a 4.0015(13)e+06", "a 4.0015(13)e+05"));
  EXPECT_FALSE(prints_line_as("no gap", "gap"));
}

TEST(SlowDocumentedSession, FirstStepsPrintWhatThePageShows) {
  const fs::path folder = testing_support::process_folder() / "first_steps";
  fs::remove_all(folder);
  fs::create_directories(folder);
  std::string printed;
  std::size_t commands = 0, shown = 0;
  for (const PageBlock& block : blocks_of(testing_support::source_folder() / "docs/first_steps.md")) {
    if (!block.file.empty()) {
      std::ofstream file(folder / block.file);
      for (const std::string& line : block.lines) file << line << '\n';
    } else if (block.kind == "sh") {
      printed.clear();
      for (const std::string& line : block.lines) {
        ASSERT_TRUE(line.starts_with("secular ")) << line;
        const testing_support::Outcome run = testing_support::run_with_shared_cache(folder, line.substr(8));
        ASSERT_EQ(run.status, 0) << line << '\n' << run.errors;
        printed += run.output;
        ++commands;
      }
    } else if (block.kind == "text") {
      expect_printed(block, printed);
      ++shown;
    }
  }
  EXPECT_GE(commands, 6U);
  EXPECT_GE(shown, 5U);
  fs::remove_all(folder);
}

}  // namespace
}  // namespace secular

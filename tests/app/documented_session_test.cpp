// README and the pages of docs/ as a reader types them: files are written, commands run, and what they print is
// what the page shows. What is run, and what is not, stands in docs/README.md.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <ostream>
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

// ```toml beam.toml is a file of that name (or adds to it), ```sh holds commands, ```text what the commands before
// it print. ```sh elsewhere needs files, time or a machine that this test has not. <!-- sh begins what only the
// test types: files that the page takes for granted.
struct PageBlock {
  std::string kind, word;
  std::vector<std::string> lines;

  bool is_file() const { return word.find('.') != std::string::npos; }
  bool is_run() const { return kind == "sh" && word != "elsewhere"; }
};

std::vector<PageBlock> blocks_of(const fs::path& page) {
  std::ifstream in(page);
  std::vector<PageBlock> blocks;
  std::string end;
  for (std::string line; std::getline(in, line);) {
    if (!end.empty()) {
      if (line.starts_with(end))
        end.clear();
      else
        blocks.back().lines.push_back(line);
      continue;
    }
    const bool hidden = line == "<!-- sh";
    if (!hidden && !line.starts_with("```")) continue;
    end = hidden ? "-->" : "```";
    PageBlock block;
    std::istringstream(line.substr(hidden ? 5 : 3)) >> block.kind >> block.word;
    blocks.push_back(block);
  }
  return blocks;
}

// Lines that end with a backslash go on; what follows a # is a remark.
std::vector<std::string> commands_of(const PageBlock& block) {
  static const std::regex remark(R"(\s+#\s.*$)");
  std::vector<std::string> commands;
  bool goes_on = false;
  for (std::string line : block.lines) {
    line = std::regex_replace(line, remark, "");
    const bool more = line.ends_with('\\');
    if (more) line.pop_back();
    if (goes_on)
      commands.back() += line;
    else if (!line.empty())
      commands.push_back(line);
    goes_on = more;
  }
  return commands;
}

// Of the program, and no form: a word in capitals stands for something of the reader's.
bool can_be_typed(const std::string& command) {
  static const std::regex in_capitals(R"((^|[^A-Za-z])[A-Z]{3,}([^A-Za-z0-9]|$))");
  return command.starts_with("secular ") && !std::regex_search(command, in_capitals);
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

// Pages whose commands go on with one another's results, in this order, in one folder.
struct Session {
  const char* name;
  std::vector<const char*> pages;
};

void PrintTo(const Session& session, std::ostream* out) {
  *out << session.name;
}

const std::vector<Session>& sessions() {
  static const std::vector<Session> all = {
      {"FirstSteps", {"docs/first_steps.md"}},
      {"Readme", {"README.md", "docs/predicting.md"}},
      {"Chapter5", {"docs/planning_a_test.md", "docs/thesis_procedures.md"}},
      {"ModelsAndFiles", {"docs/new_resonance_case.md", "docs/verifying_a_source.md", "docs/your_own_data.md"}},
  };
  return all;
}

// Written by programs that other tests run: commands with data that are not in the repository, and of the build.
bool is_written_by_a_program(const fs::path& page) {
  return page.filename() == "measured.md" || page.filename() == "thresholds.md";
}

TEST(DocumentedSession, EveryPageWithCommandsIsInASession) {
  const fs::path source = testing_support::source_folder();
  std::vector<fs::path> pages = {source / "README.md"};
  for (const auto& entry : fs::directory_iterator(source / "docs"))
    if (entry.path().extension() == ".md") pages.push_back(entry.path());
  EXPECT_GT(pages.size(), 20U);
  for (const fs::path& page : pages) {
    if (is_written_by_a_program(page)) continue;
    bool in_session = false;
    for (const Session& session : sessions())
      for (const char* name : session.pages) in_session = in_session || source / name == page;
    std::size_t commands = 0;
    for (const PageBlock& block : blocks_of(page))
      if (block.is_run()) {
        const std::vector<std::string> all = commands_of(block);
        commands += static_cast<std::size_t>(std::ranges::count_if(all, can_be_typed));
      }
    EXPECT_EQ(in_session, commands > 0) << page << " has " << commands << " commands that can be typed";
  }
}

TEST(DocumentedSession, FormsAreNotTyped) {
  EXPECT_TRUE(
      can_be_typed("secular import run.mat -o out --time 'data(:,1)' --channel tip:response --criterion D"));
  EXPECT_TRUE(can_be_typed("secular import SNLS80mV.csv -o out"));
  EXPECT_FALSE(can_be_typed("secular identify CAMPAIGN --model my_beam -o out"));
  EXPECT_FALSE(can_be_typed("secular import $DATA/run.mat -o out"));
  EXPECT_FALSE(can_be_typed("cmake --preset release"));
  const PageBlock block{"sh", "", {"secular derive a \\", "  --case b   # remark", "secular plan x#y"}};
  EXPECT_EQ(commands_of(block), (std::vector<std::string>{"secular derive a   --case b", "secular plan x#y"}));
}

class SlowDocumentedSession : public testing::TestWithParam<Session> {
 protected:
  void type(const fs::path& page);

  const fs::path folder_ = testing_support::process_folder() / GetParam().name;
  std::map<std::string, std::string> typed_;  // command to what it printed: another page has its results then
};

void SlowDocumentedSession::type(const fs::path& page) {
  SCOPED_TRACE(page.string());
  std::string printed;
  for (const PageBlock& block : blocks_of(page)) {
    if (block.is_file()) {
      std::ofstream file(folder_ / block.word, std::ios::app);
      for (const std::string& line : block.lines) file << line << '\n';
    } else if (block.is_run()) {
      printed.clear();
      for (const std::string& command : commands_of(block)) {
        if (command.starts_with("cp ")) {
          ASSERT_EQ(std::system(("cd " + folder_.string() + " && " + command).c_str()), 0) << command;
          continue;
        }
        if (!can_be_typed(command)) continue;
        if (const auto known = typed_.find(command); known != typed_.end()) {
          printed += known->second;
          continue;
        }
        const testing_support::Outcome run = testing_support::run_with_shared_cache(folder_, command.substr(8));
        ASSERT_EQ(run.status, 0) << command << '\n' << run.errors;
        printed += run.output;
        typed_[command] = run.output;
      }
    } else if (block.kind == "text") {
      expect_printed(block, printed);
      if (HasFatalFailure()) return;
    }
  }
}

TEST_P(SlowDocumentedSession, PrintsWhatPagesShow) {
  fs::remove_all(folder_);
  fs::create_directories(folder_);
  for (const char* page : GetParam().pages) ASSERT_NO_FATAL_FAILURE(type(testing_support::source_folder() / page));
  EXPECT_GE(typed_.size(), 4U);
  fs::remove_all(folder_);
}

INSTANTIATE_TEST_SUITE_P(Pages, SlowDocumentedSession, testing::ValuesIn(sessions()),
                         [](const auto& tested) { return std::string(tested.param.name); });

}  // namespace
}  // namespace secular

// `secular help`, the page of the manual and completions say what `--help` of the commands says.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "app/shared/commands.hpp"
#include "tests/app/program_run.hpp"
#include "tests/places.hpp"
#include "tests/process_folder.hpp"

namespace secular::app {
namespace {

namespace fs = std::filesystem;
using testing_support::Outcome;

std::vector<std::string> command_words() {
  std::vector<std::string> names = {"", "blind generate", "blind score"};
  for (const Command& command : all_commands) names.emplace_back(command.name);
  return names;
}

std::string printed(const std::string& arguments) {
  const Outcome run = testing_support::run_program(testing_support::process_folder(), arguments);
  EXPECT_EQ(run.status, 0) << arguments << run.errors;
  return run.output;
}

// The long options that a text of `--help` lists.
std::vector<std::string> options_in(const std::string& help) {
  std::vector<std::string> options;
  std::istringstream lines(help);
  for (std::string line; std::getline(lines, line);) {
    const std::size_t at = line.find("--");
    const bool is_option = line.starts_with("  -") && at < 6;
    if (is_option) options.push_back(line.substr(at, line.find_first_of(" ,", at) - at));
  }
  return options;
}

TEST(Help, OfACommandIsItsHelp) {
  for (const std::string& command : command_words())
    EXPECT_EQ(printed("help " + command), printed(command + " --help"));
}

TEST(Help, OfAnUnknownCommandSaysWhatMayBeMeant) {
  const Outcome run = testing_support::run_program(testing_support::process_folder(), "help blind genrate");
  EXPECT_EQ(run.status, 2);
  EXPECT_EQ(run.errors, "secular: genrate is no command of `secular blind`; did you mean generate?\n");
}

std::string as_in_manual(std::string text) {
  for (std::size_t dash = text.find('-'); dash != std::string::npos; dash = text.find('-', dash + 2))
    text.insert(dash, "\\");
  return text;
}

TEST(Help, ThePageOfTheManualHasEveryOption) {
  const std::string page = printed("help --manual");
  for (const std::string& command : command_words()) {
    const std::size_t from = command.empty() ? 0 : page.find(".SS secular " + as_in_manual(command) + "\n");
    ASSERT_NE(from, std::string::npos) << command;
    const std::string section = page.substr(from, page.find("\n.SS ", from + 1) - from);
    for (const std::string& option : options_in(printed(command + " --help")))
      EXPECT_NE(section.find(as_in_manual(option)), std::string::npos) << command << " " << option;
  }
}

// What bash would offer for a line, its last word being typed.
std::string offered(const fs::path& script, const std::string& line) {
  const fs::path out = testing_support::process_folder() / "offered";
  const std::string call = "bash -c '. " + script.string() + "; COMP_WORDS=(" + line +
                           "); COMP_CWORD=$((${#COMP_WORDS[@]}-1)); _secular; echo \"${COMPREPLY[*]}\"' > " +
                           out.string() + " 2>/dev/null";
  EXPECT_EQ(std::system(call.c_str()), 0) << call;
  std::ifstream file(out);
  std::string words;
  std::getline(file, words);
  return words;
}

TEST(Help, BashOffersCommandsOptionsValuesAndModels) {
  const fs::path script = testing_support::process_folder() / "completion.bash";
  std::ofstream(script) << printed("help --completion bash");
  EXPECT_EQ(offered(script, "secular de"), "derive");
  EXPECT_EQ(offered(script, "secular blind ge"), "generate");
  EXPECT_EQ(offered(script, "secular blind generate --set \"\""), "short full");
  EXPECT_EQ(offered(script, "secular identify c --by \"\""), "full-equations modulation-equations both-equations");
  EXPECT_EQ(offered(script, "secular identify c --model mathieu"), "mathieu_duffing");
  EXPECT_EQ(offered(script, "secular derive pend"), "pendulum");
  EXPECT_EQ(offered(script, "secular derive pendulum --case pend"), "");
  EXPECT_EQ(offered(script, "secular help bl"), "blind");
  for (const std::string& command : command_words()) {
    const std::string words = " " + offered(script, "secular " + command + " --") + " ";
    for (const std::string& option : options_in(printed(command + " --help")))
      EXPECT_NE(words.find(" " + option + " "), std::string::npos) << command << " " << option;
  }
}

// Where these programs are, they take what is printed for them.
TEST(Help, OtherReadersTakeTheirTexts) {
  struct Reader {
    const char *program, *arguments, *check;
  };
  const fs::path file = testing_support::process_folder() / "text";
  int there = 0;
  for (const Reader& reader :
       {Reader{"zsh", "--completion zsh", "zsh -n "}, Reader{"fish", "--completion fish", "fish -n "},
        Reader{"groff", "--manual", "groff -man -Tutf8 -ww -z "}}) {
    if (std::system((std::string("command -v ") + reader.program + " >/dev/null").c_str()) != 0) continue;
    ++there;
    std::ofstream(file) << printed(std::string("help ") + reader.arguments);
    const std::string said = file.string() + ".said";
    EXPECT_EQ(std::system((reader.check + file.string() + " >" + said + " 2>&1").c_str()), 0) << reader.program;
    EXPECT_EQ(fs::file_size(said), 0U) << reader.program;
  }
  if (there == 0) GTEST_SKIP() << "none of zsh, fish and groff is installed";
}

}  // namespace
}  // namespace secular::app

// A report's own command line.
#include <gtest/gtest.h>

#include <CLI/App.hpp>
#include <algorithm>
#include <sstream>
#include <string>
#include <vector>

#include "app/shared/command_line.hpp"

namespace secular::app {
namespace {

/// A program with options of every kind.
struct Program {
  CLI::App root{"", "secular"};
  CLI::App* command = root.add_subcommand("work", "");
  std::string campaign, pattern;
  std::vector<std::string> names, vary, without;
  double from = 0;
  unsigned threads = 1;
  bool hz = false, json = false;

  Program() {
    command->add_option("CAMPAIGN", campaign)->required();
    command->add_option("--records", pattern);
    command->add_option("--from", from);
    command->add_option("--name", names);
    command->add_option("--vary", vary)->expected(3);
    command->add_option("--without", without)->allow_extra_args(false);
    command->add_flag("--hz", hz);
    command->add_flag("--json", json);
    command->add_option("--threads", threads);
  }

  std::string line_of(std::vector<std::string> arguments) {
    std::reverse(arguments.begin(), arguments.end());  // as CLI11 takes them
    root.parse(arguments);
    return command_line_of(*command);
  }
};

TEST(CommandLineOf, HoldsWhatWasGivenAndNothingElse) {
  EXPECT_EQ(Program().line_of({"work", "test"}), "secular work test");
  EXPECT_EQ(Program().line_of({"work", "--from", "0.5", "--hz", "test"}), "secular work test --from 0.5 --hz");
  EXPECT_EQ(Program().line_of({"work", "test", "--json", "--threads", "4"}), "secular work test");
}

TEST(CommandLineOf, QuotesWhatAShellWouldChange) {
  EXPECT_EQ(Program().line_of({"work", "my test", "--records", "records/*.csv"}),
            "secular work 'my test' --records 'records/*.csv'");
  EXPECT_EQ(Program().line_of({"work", "it's"}), "secular work 'it'\\''s'");
}

TEST(CommandLineOf, GivesSeveralValuesAsTheOptionTakesThem) {
  EXPECT_EQ(Program().line_of({"work", "test", "--name", "a", "--name", "b"}), "secular work test --name a b");
  EXPECT_EQ(Program().line_of({"work", "test", "--vary", "Omega", "1", "2"}), "secular work test --vary Omega 1 2");
  EXPECT_EQ(Program().line_of({"work", "--without", "a", "--without", "b", "test"}),
            "secular work test --without a --without b");
}

// The line is itself a command, and the same one.
TEST(CommandLineOf, IsItsOwnRepetition) {
  const std::string line =
      Program().line_of({"work", "test", "--hz", "--vary", "F", "-1", "2", "--without", "x", "--name", "a", "b"});
  std::istringstream words(line.substr(std::string("secular ").size()));
  std::vector<std::string> arguments;
  for (std::string word; words >> word;) arguments.push_back(word);
  EXPECT_EQ(Program().line_of(arguments), line);
}

}  // namespace
}  // namespace secular::app

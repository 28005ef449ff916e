// `secular verify` as its user sees it: a page of errata, and a source of one's own.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "tests/app/program_run.hpp"
#include "tests/process_folder.hpp"

namespace secular {
namespace {

using testing_support::Outcome;

class VerifyCommand : public testing::Test {
 protected:
  Outcome run(const std::string& arguments) const { return testing_support::run_program(folder_, arguments); }
  // A source with one sum, printed with this sign, and the verdict that is recorded for it.
  void write_source(const std::string& sign, const std::string& verdict) const {
    std::ofstream(folder_ / "own.toml") << "schema = 1\nname = \"own\"\nsource = \"A paper\"\n[[identity]]\n"
                                           "equation = \"3\"\nprinted = \"(a + b)^2 = a^2 "
                                        << sign << " 2*a*b + b^2\"\ncorrected = \"(a + b)^2 = a^2 + 2*a*b + b^2\"\n"
                                        << "reason = \"a sign\"\nverdict = \"" << verdict << "\"\n";
  }
  std::filesystem::path folder_ = testing_support::process_folder();
};

TEST_F(VerifyCommand, ErrataHaveTermAndEvidence) {
  write_source("-", "misprint");
  const Outcome page = run("verify --source own.toml --errata --quiet");
  EXPECT_EQ(page.status, 0) << page.errors;
  for (const char* part : {"# Errata", "A paper", "### 3", "- term: `-2*a*b`, right `+2*a*b`", "- where: a sign",
                           "- evidence: at random values"})
    EXPECT_NE(page.output.find(part), std::string::npos) << part << "\n" << page.output;
  EXPECT_EQ(page.output.find("left out"), std::string::npos) << page.output;
  EXPECT_NE(page.output.find("- at random values of its symbols alone: 1\n"), std::string::npos) << page.output;
  const Outcome without = run("verify --source own.toml --errata --quiet --without-proofs");
  EXPECT_NE(without.output.find("was left out (`--without-proofs`)"), std::string::npos) << without.output;
  EXPECT_EQ(run("verify --source own.toml --errata --json").status, 2);
}

TEST_F(VerifyCommand, StatusIsWhetherEveryVerdictIsTheRecordedOne) {
  write_source("+", "misprint");  // right as printed
  EXPECT_EQ(run("verify --source own.toml --quiet").status, 1);
  write_source("+", "confirmed");
  EXPECT_EQ(run("verify --source own.toml --quiet").status, 0);
  write_source("-", "confirmed");
  const Outcome json = run("verify --source own.toml --quiet --json");
  EXPECT_EQ(json.status, 1);
  EXPECT_NE(json.output.find("\"term\""), std::string::npos) << json.output;
}

TEST_F(VerifyCommand, ASourceWithoutStatementsIsRefused) {
  std::ofstream(folder_ / "own.toml") << "schema = 1\nname = \"own\"\nsource = \"A paper\"\n";
  const Outcome empty = run("verify --source own.toml --quiet");
  EXPECT_EQ(empty.status, 2);
  EXPECT_NE(empty.errors.find("nothing to verify"), std::string::npos) << empty.errors;
}

}  // namespace
}  // namespace secular

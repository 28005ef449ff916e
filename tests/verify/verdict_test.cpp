#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "input/input_error.hpp"
#include "tests/places.hpp"
#include "tests/process_folder.hpp"
#include "thesis/verify/verification.hpp"

namespace secular::verify {
namespace {

const std::filesystem::path models = testing_support::source_folder() / "models";

Model shipped(const std::string& name) {
  return read_model(models / (name + ".toml"));
}

std::string source_text() {
  std::ifstream file(models / "printed" / "fahey2000.toml");
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

PrintedSource changed_source(const std::string& from, const std::string& to) {
  std::string text = source_text();
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  text.replace(at, from.size(), to);
  const std::filesystem::path path = testing_support::process_folder() / "secular_changed_source.toml";
  std::ofstream(path) << text;
  PrintedSource source = read_printed_source(path);
  std::filesystem::remove(path);
  return source;
}

std::vector<Verdict> verdicts_without_proofs(const PrintedSource& source) {
  VerificationSettings settings;
  settings.proofs = false;
  return verify_source(source, shipped, settings);
}

const Verdict& of(const std::vector<Verdict>& verdicts, const std::string& equation, const std::string& part = {}) {
  const auto found = std::find_if(verdicts.begin(), verdicts.end(), [&](const Verdict& v) {
    return v.equation == equation && (part.empty() || v.part == part);
  });
  EXPECT_NE(found, verdicts.end()) << equation;
  return *found;
}

TEST(Verdicts, AreTheRecordedOnes) {
  const PrintedSource source = read_printed_source(models / "printed" / "fahey2000.toml");
  const std::vector<Verdict> verdicts = verdicts_without_proofs(source);
  EXPECT_GT(verdicts.size(), 70U);
  for (const Verdict& v : verdicts)
    EXPECT_TRUE(v.as_recorded()) << v.equation << " " << v.part << ": " << v.verdict;
}

// Everything the source derives in chapters 5 and 6 has a statement.
TEST(Verdicts, CoverTheDerivation) {
  const PrintedSource source = read_printed_source(models / "printed" / "fahey2000.toml");
  for (const char* equation :
       {"5.6",  "5.7",  "5.8",  "5.10", "5.11", "5.12", "5.13", "5.14", "5.15", "5.16", "5.17", "5.19",
        "5.20", "5.22", "5.23", "5.24", "5.25", "5.26", "5.27", "5.28", "6.10", "6.11", "6.12", "6.13",
        "6.14", "6.15", "6.18", "6.19", "6.20", "6.21", "6.22", "6.23", "6.24", "6.25", "6.26", "6.27",
        "6.30", "6.31", "6.32", "6.33", "6.34", "6.36", "6.37", "6.38", "6.39", "6.40"})
    EXPECT_TRUE(std::any_of(source.statements.begin(), source.statements.end(), [&](const PrintedStatement& s) {
      return s.equation == equation;
    })) << equation;
  for (int n = 1; n <= 12; ++n)
    EXPECT_TRUE(std::any_of(source.statements.begin(), source.statements.end(), [&](const PrintedStatement& s) {
      return s.name == "Gamma_" + std::to_string(n) && s.kind == "definition";
    })) << n;
}

// A single changed sign or factor is no longer confirmed, and not taken for the recorded misprint either.
TEST(Verdicts, NoticeAChangedPrint) {
  const struct {
    const char *from, *to, *equation, *part;
  } changes[] = {
      {"omega0*da = -omega0*mu1*a", "omega0*da = -2*omega0*mu1*a", "5.19", ""},
      {"- alpha21*v11^2 - 2*alpha22*v11*v21", "+ alpha21*v11^2 - 2*alpha22*v11*v21", "6.12", ""},
      {"printed = \"eta22^2/(2*(Omega^2 - 4*omega2^2))\"", "printed = \"eta22^2/(4*(Omega^2 - 4*omega2^2))\"",
       "6.27", "Gamma_10"},
      {"a1*cos(omega1*t + beta1) - eps*(((alpha21", "a1*cos(omega1*t + beta1) + eps*(((alpha21", "6.36", ""},
      {"solve_for = [\"mu1\", \"sigma\"]\nprinted = \"eta_e^2*F^2",
       "solve_for = [\"mu1\", \"sigma\"]\nprinted = \"2*eta_e^2*F^2", "5.25", ""},
  };
  for (const auto& change : changes) {
    const std::vector<Verdict> verdicts = verdicts_without_proofs(changed_source(change.from, change.to));
    const Verdict& verdict = of(verdicts, change.equation, change.part);
    EXPECT_EQ(verdict.verdict, "unresolved") << change.equation;
    EXPECT_FALSE(verdict.as_recorded()) << change.equation;
  }
}

TEST(Verdicts, ComplainAboutAnUnknownSymbol) {
  const PrintedSource source = changed_source("omega0*da = -omega0*mu1*a", "omega0*da = -omega0*mu9*a");
  try {
    verdicts_without_proofs(source);
    FAIL() << "accepted";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("mu9"), std::string::npos) << error.what();
    EXPECT_NE(std::string(error.what()).find("line"), std::string::npos) << error.what();
  }
}

// Every misprint that a measurement can decide is decided by the integrated equations: the corrected form's error
// falls at least half an order faster than the printed one's.
TEST(SlowVerdicts, MisprintsAreProvedByTheFullEquations) {
  const PrintedSource source = read_printed_source(models / "printed" / "fahey2000.toml");
  int proofs = 0;
  for (const Verdict& v : verify_source(source, shipped)) {
    EXPECT_TRUE(v.proved) << v.equation << " " << v.part << ": " << v.proof;
    proofs += v.proof.empty() ? 0 : 1;
  }
  EXPECT_GE(proofs, 10);
}

}  // namespace
}  // namespace secular::verify

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <set>
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
  EXPECT_GT(verdicts.size(), 200U);
  for (const Verdict& v : verdicts)
    EXPECT_TRUE(v.as_recorded()) << v.equation << " " << v.part << ": " << v.verdict;
}

bool covers(const PrintedSource& source, const std::string& equation) {
  const auto same = [&](const auto& one) { return one.equation == equation; };
  return std::any_of(source.statements.begin(), source.statements.end(), same) ||
         std::any_of(source.identities.begin(), source.identities.end(), same) ||
         std::any_of(source.matrices.begin(), source.matrices.end(), same);
}

// Everything that chapters 5 and 6 number has a statement, but (5.33), which is (5.32) once more, and the
// regressions (5.35) and (5.37), whose rows are (5.34) and (5.36), and (6.42), the residual of (6.41).
TEST(Verdicts, CoverTheDerivation) {
  const PrintedSource source = read_printed_source(models / "printed" / "fahey2000.toml");
  const std::set<std::string> elsewhere = {"5.33", "5.35", "5.37", "6.42"};
  for (const auto& [chapter, last] : {std::pair{5, 40}, std::pair{6, 52}})
    for (int n = 1; n <= last; ++n) {
      const std::string equation = std::to_string(chapter) + "." + std::to_string(n);
      EXPECT_NE(covers(source, equation), elsewhere.contains(equation)) << equation;
    }
  for (const char* equation :
       {"2.2",  "2.7",  "2.17", "2.18", "2.19", "2.20", "3.4",  "3.8", "3.12",      "4.16", "4.22",
        "4.25", "4.28", "4.49", "A.4",  "A.5",  "A.8",  "A.14", "B.9", "Table B.1", "C.5"})
    EXPECT_TRUE(covers(source, equation)) << equation;
  for (const char* table : {"2.3", "2.7", "5.4", "D.2", "D.3", "D.4", "D.5"})
    EXPECT_TRUE(std::any_of(source.arithmetic.begin(), source.arithmetic.end(), [&](const PrintedArithmetic& a) {
      return a.table == table;
    })) << table;
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
      {"- eps*delta2*D0(v)^2 - eps^2*delta3", "- eps^2*delta2*D0(v)^2 - eps^2*delta3", "5.2", ""},
      {"\"v0 + eps*v1 + eps^2*v2\"", "\"v0 + eps*v1 + eps^2*v1\"", "5.3", ""},
      {"+ 2*eps^2*D0(D2(v))", "+ eps^2*D0(D2(v))", "5.4", "second derivative by time"},
      {"\"Omega = 2*omega0 + eps^2*sigma\"", "\"Omega = 2*omega0 + eps*sigma\"", "5.5", ""},
      {"\"1/2*a*cis(beta)\"", "\"a*cis(beta)\"", "5.18", ""},
      {"printed = \"sigma - 2*beta\"", "printed = \"sigma - beta\"", "5.21", ""},
      {"printed = \"sigma - beta1 - beta2\"", "printed = \"sigma - beta1 + beta2\"", "6.35", ""},
      {"printed = \"transpose(P)*P = unit(3)\"", "printed = \"P*transpose(P) = unit(3)\"", "3.7", ""},
  };
  for (const auto& change : changes) {
    const std::vector<Verdict> verdicts = verdicts_without_proofs(changed_source(change.from, change.to));
    const Verdict& verdict = of(verdicts, change.equation, change.part);
    EXPECT_EQ(verdict.verdict, "unresolved") << change.equation;
    EXPECT_FALSE(verdict.as_recorded()) << change.equation;
  }
}

// Of the estimates that (5.38) gives, the lump of Table 5.2 keeps its sign and eta1 alone changes it.
TEST(Verdicts, OfTable52OneEstimateChangesSign) {
  const std::string lump = "line(v, 2*omega0) = (alpha2", eta = "line(v, omega0)^2 - eta1";
  const auto verdict = [](const PrintedSource& source) {
    return of(verdicts_without_proofs(source), "5.38", "a row, in Fourier coefficients of the response").verdict;
  };
  EXPECT_EQ(verdict(read_printed_source(models / "printed" / "fahey2000.toml")), "misprint");
  const std::string both = source_text();
  const std::size_t corrected = both.find("corrected = \"" + lump);
  ASSERT_NE(corrected, std::string::npos);
  EXPECT_EQ(verdict(changed_source("corrected = \"" + lump, "corrected = \"line(v, 2*omega0) = -(alpha2")),
            "unresolved");
  EXPECT_EQ(verdict(changed_source(eta, "line(v, omega0)^2 + eta1")), "unresolved");
}

// An amplitude twice as large quarters alpha_e and mu3, halves the quadratic lump, and doubles eta1 unless the
// excitation is doubled, which halves eta_e: Tables 5.2 to 5.4 do the first and the third alone.
TEST(Verdicts, Tables52To54ContradictOneAnother) {
  const std::vector<Verdict> verdicts =
      verdicts_without_proofs(read_printed_source(models / "printed" / "fahey2000.toml"));
  const auto found = [&](const std::string& entry) {
    for (const Verdict& v : verdicts)
      if (v.equation == "Table 5.4" && v.part.starts_with(entry)) return v.verdict;
    return std::string("no such entry");
  };
  EXPECT_EQ(found("alpha_e, a quarter"), "agrees");
  EXPECT_EQ(found("quadratic lump, half"), "agrees");
  EXPECT_EQ(found("mu3, with an amplitude twice"), "disagrees");
  EXPECT_EQ(found("eta1, with response amplitudes twice"), "disagrees");
  EXPECT_EQ(found("eta_e, with response amplitudes and excitation twice"), "disagrees");
  EXPECT_NEAR(42.5 / 10.62, 4, 0.01);            // alpha_e
  EXPECT_NEAR(19.18 * 1.922 / 36.87, 1, 0.001);  // mu3: not 4
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

// A misprint says what decides it; what no integration decides has that said.
TEST(Verdicts, SayTheirEvidence) {
  const std::vector<Verdict> verdicts =
      verdicts_without_proofs(read_printed_source(models / "printed" / "fahey2000.toml"));
  for (const Verdict& v : verdicts)
    EXPECT_EQ(v.evidence.empty(), v.verdict != "misprint" && v.verdict != "convention");
  EXPECT_EQ(of(verdicts, "5.8").evidence, "symbol by symbol alone");
  EXPECT_NE(of(verdicts, "5.17").evidence.find("left out"), std::string::npos);
  EXPECT_EQ(of(verdicts, "4.16").evidence, "at random values of its symbols alone");
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

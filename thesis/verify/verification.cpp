#include "thesis/verify/verification.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <list>
#include <memory>
#include <tuple>

#include "input/input_error.hpp"
#include "thesis/verify/changed_term.hpp"
#include "thesis/verify/convergence_proof.hpp"
#include "thesis/verify/identity_check.hpp"
#include "thesis/verify/lagrangian_symmetry.hpp"
#include "thesis/verify/statement_check.hpp"
#include "thesis/verify/table_arithmetic.hpp"

namespace secular::verify {
namespace {

// A chapter with its derivation and the check that uses both.
struct OpenChapter {
  const PrintedChapter* chapter = nullptr;
  std::unique_ptr<Model> model;
  std::unique_ptr<Derivation> derivation;
  std::unique_ptr<StatementCheck> check;
  std::unique_ptr<Laboratory> laboratory;
};

std::string one_line(const std::string& text) {
  std::string result;
  for (const char c : text)
    if (c != '\n')
      result += c;
    else if (!result.empty() && result.back() != ' ')
      result += ' ';
  while (result.ends_with(' ')) result.pop_back();
  return result;
}

Verdict judged(const PrintedStatement& statement, const OpenChapter& open, const PrintedSource& source,
               bool proofs) {
  Verdict verdict;
  verdict.equation = statement.equation;
  verdict.part = statement.part;
  verdict.kind = statement.kind;
  verdict.recorded = statement.verdict;
  verdict.remark = statement.remark;
  verdict.printed = one_line(statement.printed.text);
  if (open.check->holds(statement, statement.printed)) {
    verdict.verdict = "confirmed";
    return verdict;
  }
  if (!statement.corrected || !open.check->holds(statement, *statement.corrected)) {
    verdict.verdict = "unresolved";
    return verdict;
  }
  verdict.verdict = statement.verdict == "convention" ? "convention" : "misprint";
  verdict.reason = statement.reason;
  verdict.corrected = one_line(statement.corrected->text);
  std::tie(verdict.term_printed, verdict.term_right) = changed_term(verdict.printed, verdict.corrected);
  const bool second = verdict.verdict == "misprint" && can_be_measured(statement);
  verdict.evidence = verdict.verdict == "convention" ? "symbol by symbol" : "symbol by symbol alone";
  if (!second) return verdict;
  verdict.evidence = "symbol by symbol; the integration of the equations of motion was left out";
  if (!proofs) return verdict;
  const auto inside = std::find_if(
      source.statements.begin(), source.statements.end(),
      [&](const PrintedStatement& s) { return s.equation == statement.inside && s.kind == "modulation"; });
  if (statement.kind == "definition" && inside == source.statements.end())
    statement.place.fail("inside", "names no modulation equation",
                         "give the equation that the definition stands in");
  const ConvergenceProof proof =
      prove(*open.laboratory, statement, inside == source.statements.end() ? nullptr : &*inside);
  verdict.proof = proof.text();
  verdict.proved = proof.decides_for_correction;
  verdict.evidence = verdict.proved ? "symbol by symbol, and by the integrated equations of motion"
                                    : "symbol by symbol; the integrated equations of motion do not decide";
  return verdict;
}

Verdict judged(const PrintedIdentity& identity) {
  Verdict verdict;
  verdict.equation = identity.equation;
  verdict.part = identity.part;
  verdict.kind = "identity";
  verdict.recorded = identity.verdict;
  verdict.remark = identity.remark;
  verdict.printed = one_line(identity.printed.text);
  const IdentityCheck printed = check_identity(identity, identity.printed);
  verdict.verdict = printed.holds ? "confirmed" : "unresolved";
  if (printed.holds) return verdict;
  if (!printed.why.empty()) verdict.reason = "as printed " + printed.why;
  if (!identity.corrected) return verdict;
  const IdentityCheck corrected = check_identity(identity, *identity.corrected);
  if (!corrected.holds) {
    if (!corrected.why.empty())
      verdict.reason += (verdict.reason.empty() ? "" : "; ") + ("as corrected " + corrected.why);
    return verdict;
  }
  verdict.verdict = identity.verdict == "convention" ? "convention" : "misprint";
  verdict.reason = identity.reason;
  verdict.corrected = one_line(identity.corrected->text);
  std::tie(verdict.term_printed, verdict.term_right) = changed_term(verdict.printed, verdict.corrected);
  verdict.evidence = "at random values of its symbols alone";
  verdict.proof =
      (printed.why.empty() ? fmt::format("the printed sides differ by {:.2g} of their terms", printed.largest)
                           : "as printed " + printed.why) +
      fmt::format(", the corrected ones by {:.0e}", corrected.largest);
  return verdict;
}

Verdict judged(const PrintedMatrix& matrix) {
  Verdict verdict;
  verdict.equation = matrix.equation;
  verdict.part = matrix.part;
  verdict.kind = "matrix";
  verdict.recorded = matrix.verdict;
  const std::vector<std::string> wrong = wrong_entries(matrix);
  verdict.verdict = wrong.empty() ? "agrees" : "disagrees";
  verdict.reason = matrix.formula.text + " from the rounded entries";
  for (const std::string& one : wrong) verdict.reason += "; " + one;
  if (!matrix.reason.empty()) verdict.reason += "; " + matrix.reason;
  return verdict;
}

Verdict judged(const PrintedArithmetic& arithmetic) {
  const ArithmeticCheck check = check_arithmetic(arithmetic);
  Verdict verdict;
  const bool is_text = arithmetic.table.starts_with("section ");
  verdict.equation = is_text ? arithmetic.table : "Table " + arithmetic.table;
  verdict.printed = arithmetic.printed;
  verdict.part = arithmetic.entry;
  verdict.kind = "arithmetic";
  verdict.recorded = arithmetic.verdict;
  verdict.verdict = check.agrees ? "agrees" : "disagrees";
  verdict.reason = fmt::format("{} from the rounded entries is {:.4g} to {:.4g}, printed {}{}",
                               arithmetic.formula.text, check.expected.low, check.expected.high,
                               arithmetic.claim == "equals" ? "" : arithmetic.claim + " ", arithmetic.printed);
  if (!arithmetic.reason.empty()) verdict.reason += "; " + arithmetic.reason;
  return verdict;
}

Verdict judged(const PrintedSymmetry& symmetry, const Model& model) {
  Verdict verdict;
  verdict.equation = symmetry.equations;
  verdict.part = "follow from a Lagrangian (Helmholtz's conditions)";
  verdict.kind = "symmetry";
  verdict.recorded = symmetry.verdict;
  for (const std::string& name : symmetry.without)
    if (!model.symbols.contains(name))
      symmetry.place.fail("without", "'" + name + "' is no symbol", "a symbol of model " + symmetry.model);
  const std::vector<std::string> broken = broken_lagrangian_symmetries(model, symmetry.without);
  verdict.verdict = broken.empty() ? "confirmed" : "misprint";
  if (!broken.empty()) verdict.evidence = "symbol by symbol alone";
  for (const std::string& one : broken) verdict.reason += (verdict.reason.empty() ? "" : "; ") + one;
  return verdict;
}

}  // namespace

std::vector<Verdict> verify_source(const PrintedSource& source,
                                   const std::function<Model(const std::string&)>& find_model,
                                   const VerificationSettings& settings) {
  if (source.statements.empty() && source.symmetries.empty() && source.identities.empty() &&
      source.matrices.empty() && source.arithmetic.empty())
    throw InputError(source.file, "the whole file", "has nothing to verify",
                     "[[statement]], [[identity]], [[arithmetic]], [[matrix]] or [[symmetry]] tables");
  std::list<OpenChapter> chapters;
  for (const PrintedChapter& chapter : source.chapters) {
    OpenChapter open;
    open.chapter = &chapter;
    open.model = std::make_unique<Model>(find_model(chapter.model));
    const auto& cases = open.model->cases;
    if (std::none_of(cases.begin(), cases.end(),
                     [&](const ResonanceCase& resonance) { return resonance.name == chapter.resonance; }))
      chapter.place.fail("case", "'" + chapter.resonance + "' is no case of model " + chapter.model,
                         "one of those that `secular derive " + chapter.model + "` lists");
    open.derivation = std::make_unique<Derivation>(derive(*open.model, open.model->find_case(chapter.resonance)));
    open.check = std::make_unique<StatementCheck>(chapter, *open.derivation);
    open.laboratory = std::make_unique<Laboratory>(*open.derivation, open.check->formula());
    chapters.push_back(std::move(open));
  }
  std::vector<Verdict> verdicts;
  std::size_t done = 0;
  for (const PrintedStatement& statement : source.statements) {
    const auto open = std::find_if(chapters.begin(), chapters.end(),
                                   [&](const OpenChapter& c) { return c.chapter->number == statement.chapter; });
    verdicts.push_back(judged(statement, *open, source, settings.proofs));
    if (settings.progress) settings.progress(++done, source.statements.size());
  }
  for (const PrintedSymmetry& symmetry : source.symmetries)
    verdicts.push_back(judged(symmetry, find_model(symmetry.model)));
  for (const PrintedIdentity& identity : source.identities) verdicts.push_back(judged(identity));
  for (const PrintedMatrix& matrix : source.matrices) verdicts.push_back(judged(matrix));
  for (const PrintedArithmetic& arithmetic : source.arithmetic) verdicts.push_back(judged(arithmetic));
  return verdicts;
}

}  // namespace secular::verify

#pragma once

#include <string_view>

#include "perturb/derivation.hpp"
#include "thesis/verify/identity_check.hpp"
#include "thesis/verify/printed_source.hpp"
#include "thesis/verify/statement_check.hpp"
#include "thesis/verify/table_arithmetic.hpp"

namespace secular::verify {

/// Reads a printed source and checks all that it says of one derivation, which is made once: chapters of other
/// models and cases are only read. Returns how many of its statements are right as printed. Throws InputError.
inline int verify_anything(std::string_view text, const Derivation& derivation) {
  const PrintedSource source = read_printed_source_text(text, "source.toml");
  int right = 0;
  for (const PrintedChapter& chapter : source.chapters) {
    if (chapter.model != derivation.model->name || chapter.resonance != derivation.resonance->name) continue;
    const StatementCheck check(chapter, derivation);
    for (const PrintedStatement& statement : source.statements) {
      if (statement.chapter != chapter.number) continue;
      if (check.holds(statement, statement.printed)) ++right;
      if (statement.corrected) check.holds(statement, *statement.corrected);
    }
  }
  for (const PrintedIdentity& identity : source.identities) {
    if (check_identity(identity, identity.printed).holds) ++right;
    if (identity.corrected) check_identity(identity, *identity.corrected);
  }
  for (const PrintedMatrix& matrix : source.matrices) wrong_entries(matrix);
  for (const PrintedArithmetic& arithmetic : source.arithmetic) check_arithmetic(arithmetic);
  return right;
}

}  // namespace secular::verify

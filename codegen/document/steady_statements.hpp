#pragma once

#include <string>
#include <vector>

#include "codegen/canonical/canonical_model.hpp"
#include "codegen/document/derivation_document.hpp"
#include "codegen/document/typeset.hpp"

/// What follows from the modulation equations for steady states, as words and equations: the one source of all
/// four outputs.
namespace secular::typeset {

struct Statement {
  std::string key;  ///< in JSON: "threshold"
  std::vector<Run> says;
  std::vector<Equation> equations;
};

struct StatementSection {
  std::string key, heading;
  std::vector<Statement> statements;
};

/// Jacobian of the Cartesian form; the zero solution and its thresholds; steady states. The case has a frame.
std::vector<StatementSection> steady_sections(const CanonicalModel& model, const CanonicalCase& resonance);

/// A run of words and formulas as plain text.
std::string plain_text(const std::vector<Run>& runs);

}  // namespace secular::typeset

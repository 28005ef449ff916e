#pragma once

#include <string>
#include <variant>
#include <vector>

#include "codegen/canonical/canonical_model.hpp"
#include "codegen/document/typeset.hpp"

/// A derivation as a document of headings, texts, equations and tables: built once, printed as LaTeX or HTML.
namespace secular::typeset {

/// Text in fixed pitch: what a person wrote in the model, or would write at the command line.
struct Code {
  std::string text;
};
using Run = std::variant<std::string, Code, Expression>;

struct Paragraph {
  enum class Tone { plain, good, bad };
  std::vector<Run> runs;
  Tone tone = Tone::plain;
};

struct Heading {
  bool of_case = false;  ///< otherwise of a section within a case or before the cases
  std::string text;
};

struct EquationList {
  std::vector<Equation> equations;
};

struct Table {
  std::vector<std::string> headings;
  std::vector<std::vector<Expression>> rows;  ///< the last column may be long
};

using Block = std::variant<Paragraph, Heading, EquationList, Table>;

struct Document {
  std::string title;
  std::vector<Block> blocks;
};

/// What derivation_text() says, for typesetting.
Document derivation_document(const CanonicalModel& model);

}  // namespace secular::typeset

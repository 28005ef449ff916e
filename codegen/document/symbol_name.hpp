#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace secular {

/// One letter, word or number of a typeset name.
struct NamePart {
  enum class Kind { letter, word, number, greek, verbatim };
  Kind kind = Kind::letter;
  std::string text;  ///< as written in the model: "A", "rate", "12", "Omega"
  bool operator==(const NamePart&) const = default;
};

/// A model's symbol as it is typeset: "mu12" is mu with subscript 12, "A_v1" is A with subscript v that has itself
/// the subscript 1, "alpha_e" is alpha with subscript e.
struct SymbolName {
  NamePart base;
  std::vector<SymbolName> subscripts;  ///< separated by commas
  bool operator==(const SymbolName&) const = default;
};

/// From an identifier of a model: underscores and digits at its end begin subscripts.
SymbolName symbol_name(std::string_view identifier);

/// The identifier as it stands, in fixed pitch.
SymbolName verbatim_name(std::string_view identifier);

/// A Greek letter that both LaTeX and Unicode have.
struct GreekLetter {
  std::string_view word;   ///< in models
  std::string_view latex;  ///< command without backslash
  std::string_view utf8;
};

/// nullptr if `word` is none. "eps" and "epsilon" are the rounded epsilon.
const GreekLetter* greek_letter(std::string_view word);

}  // namespace secular

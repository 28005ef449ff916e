#pragma once

#include <vector>

#include "codegen/document/typeset.hpp"

namespace secular::typeset {

/// A part of a formula that a back end writes as it stands. Brackets of an opened-up formula stand alone, because
/// a line break may lie between them.
struct Element {
  enum class Kind { expression, plus, minus, open, close };
  Kind kind = Kind::expression;
  Expression expression;
  bool tall = false;  ///< of a bracket: the inner formula holds fractions
  int exponent = 1;   ///< of a closing bracket
};

/// Elements that stay on one line.
struct Piece {
  std::vector<Element> elements;
  double width = 0;  ///< in em, estimated
};

/// The formula cut where lines may break: before the terms of its sum. A term wider than `widest` em is itself
/// opened up: its bracket is cut, a fraction with a long numerator is written 1/denominator times a
/// bracket, one with a long denominator numerator times bracket to the power -1.
std::vector<Piece> line_pieces(const Expression& formula, double widest);

/// Estimated width in em of the surrounding text.
double estimated_width(const Expression& formula);

}  // namespace secular::typeset

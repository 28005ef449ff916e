#pragma once

#include <string>
#include <string_view>

#include "codegen/document/line_pieces.hpp"

namespace secular::typeset {

/// A formula as presentation MathML (MathML Core), without the <math> element around it.
std::string mathml(const Expression& formula);

/// A piece of a formula, without the <math> element; `first` of its formula or further on.
std::string mathml(const Piece& piece, bool first);

}  // namespace secular::typeset

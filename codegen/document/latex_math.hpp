#pragma once

#include <string>
#include <string_view>

#include "codegen/document/line_pieces.hpp"

namespace secular::typeset {

/// A formula in LaTeX math mode (amsmath).
std::string latex_math(const Expression& formula);

/// A piece of a formula, `first` of it or further on; brackets have fixed sizes because lines may break between
/// them.
std::string latex_math(const Piece& piece, bool first);

/// "\omega_{0}", "A_{v_{1}}", "\mathit{rate}".
std::string latex_symbol(std::string_view identifier);

/// Plain text with LaTeX's special characters escaped. Characters that LaTeX's plain fonts lack are written by
/// their code point.
std::string latex_text(std::string_view text);

}  // namespace secular::typeset

#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "perturb/term_sum.hpp"

namespace secular {

/// Exponents of each coordinate's unit, each excitation's unit and the second.
using Dimension = std::vector<GiNaC::numeric>;

/// Units of a model's symbols from its equations: every term of equation k has the unit of D2(v_k), and terms that
/// are added have one unit. A symbol that the equations leave open (it only ever stands in products with other open
/// symbols) is absent.
std::map<std::string, Dimension> symbol_dimensions(const Model& model, const std::vector<TermSum>& equations);

/// Unit of a product of powers inside a rational expression whose terms share one unit; nothing if a symbol is
/// open.
std::optional<Dimension> dimension_of(const GiNaC::ex& expression, const std::map<std::string, Dimension>& symbols,
                                      const Model& model);

}  // namespace secular

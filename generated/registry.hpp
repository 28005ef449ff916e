// Models compiled into this program: generated code, never edited by hand.
#pragma once

#include <span>
#include <string_view>

#include "estimator/model/compiled_model.hpp"

namespace secular::generated {

/// All models, by name.
std::span<const CompiledModel* const> compiled_models();

/// The model of that name, or nullptr.
const CompiledModel* find_compiled_model(std::string_view name);

}  // namespace secular::generated

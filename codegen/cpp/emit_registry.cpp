#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "codegen/cpp/emit_cpp.hpp"
#include "codegen/expression/cpp_expression.hpp"

namespace secular {

std::vector<GeneratedFile> emit_registry(const std::vector<std::string>& model_names) {
  std::vector<std::string> names = model_names;
  std::sort(names.begin(), names.end());
  const std::string banner = "// Models compiled into this program: generated code, never edited by hand.\n";
  GeneratedFile header{"registry.hpp", banner + R"(#pragma once

#include <span>
#include <string_view>

#include "estimator/model/compiled_model.hpp"

namespace secular::generated {

/// All models, by name.
std::span<const CompiledModel* const> compiled_models();

/// The model of that name, or nullptr.
const CompiledModel* find_compiled_model(std::string_view name);

}  // namespace secular::generated
)"};
  std::string declarations, entries;
  for (const std::string& name : names) {
    const std::string space = safe_namespace(name);
    declarations += fmt::format("namespace {} {{\nextern const CompiledModel model;\n}}\n", space);
    entries += fmt::format("    &{}::model,\n", space);
  }
  GeneratedFile source{"registry.cpp", banner + "#include \"registry.hpp\"\n\nnamespace secular::generated {\n\n" +
                                           declarations + R"(
std::span<const CompiledModel* const> compiled_models() {
  static const CompiledModel* const models[] = {
)" + entries + R"(  };
  return models;
}

const CompiledModel* find_compiled_model(std::string_view name) {
  for (const CompiledModel* model : compiled_models())
    if (model->name == name) return model;
  return nullptr;
}

}  // namespace secular::generated
)"};
  return {std::move(header), std::move(source)};
}

}  // namespace secular

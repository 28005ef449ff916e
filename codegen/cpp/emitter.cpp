#include "codegen/cpp/emitter.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace secular {

void Emitter::unpack(const std::vector<std::string>& names, const std::string& attribute) {
  for (const std::string& name : names) {
    if (name == "pi") {
      code.line("const Scalar pi = Scalar(std::numbers::pi);");
      continue;
    }
    const auto parameter = std::find(model.parameters.begin(), model.parameters.end(), name);
    if (parameter == model.parameters.end()) continue;
    code.line(fmt::format("{}const Scalar {} = parameters[{}];", attribute, safe_identifier(name),
                          parameter - model.parameters.begin()));
  }
}

void Emitter::definitions(const CppWriter& writer) {
  for (const std::string& definition : writer.definitions()) code.line(definition);
}

std::string Emitter::parameter_list() const {
  std::string text;
  for (std::size_t i = 0; i < model.parameters.size(); ++i)
    text += fmt::format("{}[{}] {}", i ? ", " : "", i, model.parameters[i]);
  return text;
}

}  // namespace secular

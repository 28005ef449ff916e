#include "codegen/cpp/emitter.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "codegen/cpp/rest_value_lines.hpp"

namespace secular {

void Emitter::unpack(const std::vector<std::string>& names) {
  const std::vector<std::string> all = with_arguments(model, names);
  for (const std::string& name : all) {
    if (name == "pi") {
      code.line("const double pi = std::numbers::pi;");
      continue;
    }
    const auto parameter = std::find(model.parameters.begin(), model.parameters.end(), name);
    if (parameter == model.parameters.end()) continue;
    code.line(fmt::format("const Scalar {} = parameters[{}];", safe_identifier(name),
                          parameter - model.parameters.begin()));
  }
  definitions(rest_value_lines(model, all, "Scalar"));
}

void Emitter::definitions(const std::vector<std::string>& lines) {
  for (const std::string& line : lines) code.line(line);
}

std::string Emitter::parameter_list() const {
  std::string text;
  for (std::size_t i = 0; i < model.parameters.size(); ++i)
    text += fmt::format("{}[{}] {}", i ? ", " : "", i, model.parameters[i]);
  return text;
}

}  // namespace secular

// Values of functions at a model's rest position as code.
#include "codegen/cpp/rest_value_lines.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "codegen/expression/cpp_expression.hpp"

namespace secular {
namespace {

bool holds(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

// Powers in its argument are its own: those of the code around it have the same names.
std::string rest_value_line(const CanonicalModel& model, const CanonicalRestValue& value,
                            const std::string& scalar) {
  CppWriter writer(model.order, scalar);
  std::string call = writer.expression(value.argument);
  if (value.function == SmoothKind::power)
    call = fmt::format("power_of({}, {}.0 / {}.0)", call, value.exponent.numerator, value.exponent.denominator);
  else
    call = fmt::format("{}_of({})", name_of(value.function), call);
  std::string inside;
  for (const std::string& line : writer.definitions()) inside += line + " ";
  if (!inside.empty()) call = fmt::format("[&] {{ {}return {}; }}()", inside, call);
  return fmt::format("const {} {} = {};", scalar, safe_identifier(value.name), call);
}

}  // namespace

std::vector<std::string> with_arguments(const CanonicalModel& model, std::vector<std::string> names) {
  for (auto value = model.rest_values.rbegin(); value != model.rest_values.rend(); ++value) {
    if (!holds(names, value->name)) continue;
    for (std::size_t s = 0; s < model.order.size(); ++s)
      if (depends_on(value->argument, s) && !holds(names, model.order[s])) names.push_back(model.order[s]);
  }
  return names;
}

std::vector<std::string> rest_value_lines(const CanonicalModel& model, const std::vector<std::string>& names,
                                          const std::string& scalar) {
  std::vector<std::string> lines;
  for (const CanonicalRestValue& value : model.rest_values)
    if (holds(names, value.name)) lines.push_back(rest_value_line(model, value, scalar));
  return lines;
}

}  // namespace secular

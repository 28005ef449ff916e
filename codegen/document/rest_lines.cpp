#include "codegen/document/rest_lines.hpp"

#include <fmt/format.h>

#include "codegen/expression/cpp_expression.hpp"

namespace secular {

std::vector<std::string> rest_lines(const CanonicalModel& model) {
  std::vector<std::string> lines;
  for (const CanonicalFollowing& following : model.following)
    lines.push_back(following.name + " = " + formula_text(following.definition, model.order));
  for (const CanonicalRestValue& value : model.rest_values) {
    const std::string argument = formula_text(value.argument, model.order);
    lines.push_back(value.function == SmoothKind::power
                        ? fmt::format("{} = ({})^({}/{})", value.name, argument, value.exponent.numerator,
                                      value.exponent.denominator)
                        : fmt::format("{} = {}({})", value.name, name_of(value.function), argument));
  }
  return lines;
}

}  // namespace secular

#include "codegen/cpp/emitter.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace secular {
namespace {

bool are_equal(const CanonicalPowers& a, const CanonicalPowers& b) {  // slow phases are in no row
  return a.amplitude == b.amplitude && a.conjugate == b.conjugate && a.modulus == b.modulus &&
         a.forcing == b.forcing && a.phase == b.phase;
}

bool are_equal(const CanonicalColumnTerm& a, const CanonicalColumnTerm& b) {
  return a.imaginary == b.imaginary && are_equal(a.powers, b.powers) && a.factor == b.factor;
}

bool are_equal(const CanonicalCase& first, const CanonicalBlock& a, const CanonicalCase& second,
               const CanonicalBlock& b) {
  return a.modulation == b.modulation && a.mode == b.mode && a.phase == b.phase && a.name == b.name &&
         std::equal(a.columns.begin(), a.columns.end(), b.columns.begin(), b.columns.end(),
                    [&](const CanonicalBlock::Column& x, const CanonicalBlock::Column& y) {
                      return first.lumps[x.lump].name == second.lumps[y.lump].name &&
                             std::equal(x.terms.begin(), x.terms.end(), y.terms.begin(), y.terms.end(),
                                        [](const auto& s, const auto& t) { return are_equal(s, t); });
                    });
}

}  // namespace

BlockPlace block_place(const CanonicalModel& model, const CanonicalCase& resonance, std::size_t block) {
  for (const CanonicalCase& c : model.cases) {
    if (&c == &resonance) break;
    for (std::size_t b = 0; b < c.blocks.size(); ++b)
      if (are_equal(c, c.blocks[b], resonance, resonance.blocks[block])) return {safe_namespace(c.name), b};
  }
  return {safe_namespace(resonance.name), block};
}

void Emitter::unpack(const std::vector<std::string>& names, const std::string& attribute) {
  std::vector<std::string> wanted = names;
  const auto want = [&](const std::string& name) {
    if (std::find(wanted.begin(), wanted.end(), name) == wanted.end()) wanted.push_back(name);
  };
  for (auto value = model.rest_values.rbegin(); value != model.rest_values.rend(); ++value)
    if (std::find(wanted.begin(), wanted.end(), value->name) != wanted.end())
      for (std::size_t s = 0; s < model.order.size(); ++s)
        if (depends_on(value->argument, s)) want(model.order[s]);
  for (const std::string& name : wanted) {
    if (name == "pi") {
      code.line("const Scalar pi = Scalar(std::numbers::pi);");
      continue;
    }
    const auto parameter = std::find(model.parameters.begin(), model.parameters.end(), name);
    if (parameter == model.parameters.end()) continue;
    code.line(fmt::format("{}const Scalar {} = parameters[{}];", attribute, safe_identifier(name),
                          parameter - model.parameters.begin()));
  }
  for (const CanonicalRestValue& value : model.rest_values)
    if (std::find(wanted.begin(), wanted.end(), value.name) != wanted.end()) rest_value(value, attribute);
}

// Powers in its argument are its own: those of the function around it have the same names.
void Emitter::rest_value(const CanonicalRestValue& value, const std::string& attribute) {
  CppWriter writer(model.order, "Scalar");
  std::string call = writer.expression(value.argument);
  if (value.function == SmoothKind::power)
    call = fmt::format("power_of({}, {}.0 / {}.0)", call, value.exponent.numerator, value.exponent.denominator);
  else
    call = fmt::format("{}_of({})", name_of(value.function), call);
  std::string inside;
  for (const std::string& line : writer.definitions()) inside += line + " ";
  if (!inside.empty()) call = fmt::format("[&] {{ {}return {}; }}()", inside, call);
  code.line(fmt::format("{}const Scalar {} = {};", attribute, safe_identifier(value.name), call));
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

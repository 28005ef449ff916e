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

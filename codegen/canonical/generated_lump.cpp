#include "codegen/canonical/generated_lump.hpp"

#include <cstdlib>
#include <string>

namespace secular {
namespace {

// As the derivation names it, see powers_name() in perturb/lump_equations.cpp.
std::string monomial_name(const CanonicalModel& model, const CanonicalPowers& powers) {
  std::string name;
  const auto add = [&](const std::string& base, int power) {
    if (power == 0) return;
    name += "_" + base + (power == 1 ? "" : (power < 0 ? "m" : "") + std::to_string(std::abs(power)));
  };
  const std::size_t modes = model.coordinates.size();
  for (std::size_t k = 0; k < modes; ++k) add("A_" + model.coordinates[k], powers.amplitude[k]);
  for (std::size_t k = 0; k < modes; ++k) add("conjA_" + model.coordinates[k], powers.conjugate[k]);
  for (std::size_t k = 0; k < modes; ++k) add("absA_" + model.coordinates[k], powers.modulus[k]);
  for (std::size_t j = 0; j < model.excitations.size(); ++j) add(model.excitations[j], powers.forcing[j]);
  return name;
}

const char* kind_name(GeneratedLump::Kind kind) {
  switch (kind) {
    case GeneratedLump::Kind::conservative:
      return "conservative_";
    case GeneratedLump::Kind::dissipative:
      return "dissipative_";
    case GeneratedLump::Kind::harmonic_real:
      return "harmonic_re_";
    case GeneratedLump::Kind::harmonic_imaginary:
      return "harmonic_im_";
  }
  return "";
}

}  // namespace

std::optional<GeneratedLump> generated_lump(const CanonicalModel& model, const CanonicalCase& resonance,
                                            std::size_t lump) {
  using Kind = GeneratedLump::Kind;
  for (const CanonicalBlock& block : resonance.blocks)
    for (const CanonicalBlock::Column& column : block.columns) {
      if (column.lump != lump) continue;
      for (const CanonicalColumnTerm& term : column.terms) {
        const Kind kind = block.modulation ? (term.imaginary ? Kind::conservative : Kind::dissipative)
                                           : (term.imaginary ? Kind::harmonic_imaginary : Kind::harmonic_real);
        const std::string name =
            kind_name(kind) + model.coordinates[block.mode] + monomial_name(model, term.powers);
        if (name == resonance.lumps[lump].name) return GeneratedLump{kind, block.mode, term.powers};
      }
    }
  return std::nullopt;
}

}  // namespace secular

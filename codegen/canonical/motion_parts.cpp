#include "codegen/canonical/motion_parts.hpp"

#include <algorithm>

namespace secular {
namespace {

std::size_t place(const std::vector<std::string>& names, const std::string& name) {
  return static_cast<std::size_t>(std::find(names.begin(), names.end(), name) - names.begin());
}

}  // namespace

bool MotionPart::has_inertia() const {
  return std::any_of(motion.begin(), motion.end(), [](const auto& terms) {
    return std::any_of(terms.begin(), terms.end(),
                       [](const CanonicalMotionTerm& term) { return term.acceleration_of.has_value(); });
  });
}

std::vector<MotionPart> motion_parts(const CanonicalModel& model) {
  const std::size_t modes = model.motion.size();
  std::vector<MotionPart> parts;
  std::vector<std::size_t> symbols;  // of the strengths
  for (const std::string& name : model.strengths) symbols.push_back(place(model.order, name));
  // A product of two strengths vanishes with the first: it is that one's.
  const auto part_of = [&](const PolynomialTerm& term) {
    std::size_t part = 0;
    while (part < symbols.size() && term.exponents[symbols[part]] == 0) ++part;
    return part;
  };
  for (std::size_t p = 0; p <= symbols.size(); ++p) {
    const std::size_t wanted = p == 0 ? symbols.size() : p - 1;
    MotionPart part{std::nullopt, std::vector<std::vector<CanonicalMotionTerm>>(modes)};
    if (p > 0) part.strength = place(model.parameters, model.strengths[p - 1]);
    bool empty = true;
    for (std::size_t k = 0; k < modes; ++k)
      for (CanonicalMotionTerm term : model.motion[k]) {
        term.coefficient =
            terms_of(term.coefficient, [&](const PolynomialTerm& monomial) { return part_of(monomial) == wanted; });
        if (term.coefficient.is_zero()) continue;
        part.motion[k].push_back(std::move(term));
        empty = false;
      }
    if (p == 0 || !empty) parts.push_back(std::move(part));
  }
  return parts;
}

}  // namespace secular

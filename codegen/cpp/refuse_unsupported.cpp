#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <stdexcept>

#include "codegen/cpp/emit_cpp.hpp"
#include "codegen/document/print_text.hpp"
#include "input/input_error.hpp"

namespace secular {

void refuse_unsupported_motion(const CanonicalModel& model) {
  using Kind = CanonicalFactor::Kind;
  for (const auto& equation : model.motion)
    for (const CanonicalMotionTerm& term : equation)
      for (const CanonicalFactor& f : term.factors)
        if (f.kind == Kind::clock_cos || f.kind == Kind::clock_sin)
          throw InputError(model.name, "equation of motion",
                           fmt::format("cos or sin of {}*t stands without {}",
                                       model.excitation_frequencies[f.index], model.excitations[f.index]),
                           "write the excitation as F*cos(Omega*t): its measured signal takes that place");
}

void refuse_unsupported(const CanonicalModel& model, const CanonicalCase& c) {
  if (!c.quadratures.empty())
    throw InputError(model.name, "case " + c.name,
                     "term " + factors_text(model, c.quadratures.front().factors) +
                         " goes to quadrature: the case has no regressor linear in lumps",
                     "leave the case out of the generated code, or use a nonsmooth function of one coordinate");
  if (c.observed_frequency.empty())
    throw InputError(
        model.name, "case " + c.name, "no rotating frame makes its modulation equations autonomous",
        "steady motion needs one: of two excitations that act on a mode, lock one to the other without a "
        "detuning, as in Omega2 = 2*Omega");
  const std::size_t frequencies = model.natural_frequencies.size() + model.excitation_frequencies.size();
  for (std::size_t s = frequencies; s + 1 < model.order.size(); ++s) {
    const bool parameter =
        std::find(model.parameters.begin(), model.parameters.end(), model.order[s]) != model.parameters.end() ||
        std::any_of(model.rest_values.begin(), model.rest_values.end(),
                    [&](const CanonicalRestValue& value) { return value.name == model.order[s]; });
    for (const CanonicalLump& lump : c.lumps)
      if (!parameter && depends_on(lump.definition, s))
        throw std::logic_error("lump " + lump.name + " holds " + model.order[s] + ", which is no parameter");
    for (const CanonicalBlock& block : c.blocks)
      for (const CanonicalBlock::Column& column : block.columns)
        for (const CanonicalColumnTerm& term : column.terms)
          if (depends_on(term.factor, s))
            throw std::logic_error("a factor of the " + block.name + " holds " + model.order[s] +
                                   ", which is no frequency");
  }
  for (const CanonicalBlock& block : c.blocks)
    for (const CanonicalBlock::Column& column : block.columns)
      for (const CanonicalColumnTerm& term : column.terms)
        for (std::size_t j = 0; j < model.excitations.size(); ++j) {
          const int net = term.powers.phase[model.coordinates.size() + j], total = term.powers.forcing[j];
          if (std::abs(net) > total || (total - net) % 2 != 0)
            throw InputError(model.name, "case " + c.name + ", term with " + model.excitations[j],
                             "a harmonic of " + model.excitation_frequencies[j] + " does not come from " +
                                 model.excitations[j] + "*cos(" + model.excitation_frequencies[j] + "*t)",
                             "write the excitation as F*cos(Omega*t)");
        }
}

}  // namespace secular

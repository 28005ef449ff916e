#include "codegen/document/typeset_variables.hpp"

#include "codegen/canonical/cartesian_form.hpp"
#include "codegen/document/typeset_equations.hpp"

namespace secular::typeset {
namespace {

// Adds every term of the value; `write` turns its powers into factors.
template <typename Write>
void add_terms(Sum& sum, const VariableSum& value, bool imaginary, const Write& write) {
  for (const auto& [powers, parts] : value.terms()) {
    const Product factors = write(powers);
    for (const RationalFunction& part : parts) sum.add(part, factors, imaginary);
  }
}

Expression frame_turning(const CanonicalModel& model, const CanonicalCase& resonance, std::size_t mode) {
  return frequency_combination(model, frame_offset(resonance, mode));
}

// A power of a sum in brackets.
void multiply(Product& product, const Expression& sum, int power) {
  if (power != 0) product.times(power == 1 && sum.kind == Expression::Kind::sum ? bracket(sum) : sum, power);
}

}  // namespace

void add_forced(Sum& sum, const CanonicalModel& model, const VariableSum& value, const Product& factor,
                bool imaginary) {
  add_terms(sum, value, imaginary, [&](const VariableSum::Powers& powers) {
    Product product;
    for (std::size_t j = 0; j < model.excitations.size(); ++j)
      product.times(symbol(model.excitations[j]), powers[j]);
    if (!factor.empty()) product.times(factor.expression());
    return product;
  });
}

Expression cartesian_expression(const CanonicalModel& model, const CanonicalCase& resonance,
                                const VariableSum& value) {
  const CartesianVariables variables{model.coordinates.size(), model.excitations.size()};
  Sum sum(model.order);
  add_terms(sum, value, false, [&](const VariableSum::Powers& powers) {
    Product product;
    for (std::size_t k = 0; k < variables.modes; ++k) {
      const Expression norm_squared = Sum(model.order)
                                          .add(power(named("x", model, k), 2), false)
                                          .add(power(named("y", model, k), 2), false)
                                          .expression();
      const int norm = powers[variables.norm(k)];
      multiply(product, norm_squared, norm / 2);
      product.times(root(norm_squared), norm % 2);
      multiply(product, frame_turning(model, resonance, k), powers[variables.offset(k)]);
    }
    for (std::size_t j = 0; j < variables.excitations; ++j)
      product.times(symbol(model.excitations[j]), powers[variables.forcing(j)]);
    for (std::size_t k = 0; k < variables.modes; ++k) {
      product.times(named("x", model, k), powers[variables.x(k)]);
      product.times(named("y", model, k), powers[variables.y(k)]);
    }
    return product;
  });
  return sum.expression();
}

void add_amplitude(Sum& sum, const CanonicalModel& model, const CanonicalCase& resonance,
                   const VariableSum& value) {
  add_terms(sum, value, false, [&](const VariableSum::Powers& powers) {
    Product product;
    product.times(named("a", model, 0), powers[AmplitudeVariables::amplitude]);
    multiply(product, frame_turning(model, resonance, 0), powers[AmplitudeVariables::offset]);
    for (std::size_t j = 0; j < model.excitations.size(); ++j)
      product.times(symbol(model.excitations[j]), powers[AmplitudeVariables::forcing(j)]);
    return product;
  });
}

Expression amplitude_expression(const CanonicalModel& model, const CanonicalCase& resonance,
                                const VariableSum& value) {
  Sum sum(model.order);
  add_amplitude(sum, model, resonance, value);
  return sum.expression();
}

}  // namespace secular::typeset

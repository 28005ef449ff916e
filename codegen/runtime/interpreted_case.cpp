#include "codegen/runtime/interpreted_case.hpp"

#include <algorithm>
#include <numbers>

#include "codegen/emit_cpp.hpp"
#include "codegen/lump_gradient.hpp"

namespace secular {

using Complex = std::complex<double>;

InterpretedBlock::InterpretedBlock(const CanonicalModel& model, const CanonicalBlock& block)
    : model_(model), formulas_(model.order.size()) {
  for (std::size_t j = 0; j < block.columns.size(); ++j)
    for (const CanonicalColumnTerm& term : block.columns[j].terms)
      terms_.push_back(
          {j, block.columns[j].lump, formulas_.add(term.factor), term.imaginary, Monomial(term.powers)});
}

void InterpretedBlock::columns(const ObservationBatch& data, Complex* const* columns) const {
  const std::size_t modes = model_.coordinates.size(), excitations = model_.excitations.size();
  std::vector<double> symbols(model_.order.size(), 0.0);
  symbols.back() = std::numbers::pi;
  std::copy(data.natural_frequency, data.natural_frequency + modes, symbols.begin());
  std::vector<Complex> amplitude(modes), forcing(excitations);
  for (std::size_t i = 0; i < data.count; ++i) {
    for (std::size_t k = 0; k < modes; ++k) amplitude[k] = data.amplitude[k][i];
    for (std::size_t j = 0; j < excitations; ++j) {
      if (data.forcing) forcing[j] = data.forcing[j][i];
      if (data.excitation_frequency) symbols[modes + j] = data.excitation_frequency[j][i];
    }
    const FormulaSet::Values factor(formulas_, symbols.data());
    for (const Term& term : terms_) columns[term.column][i] = 0;
    for (const Term& term : terms_) {
      const Complex product = factor[term.factor] * term.monomial(amplitude.data(), forcing.data());
      columns[term.column][i] += term.imaginary ? Complex(-product.imag(), product.real()) : product;
    }
  }
}

Complex InterpretedBlock::target(const double* symbol_values, const double* lumps, const Complex* amplitude,
                                 const Complex* forcing) const {
  const FormulaSet::Values factor(formulas_, symbol_values);
  Complex sum;
  for (const Term& term : terms_) {
    const Complex product = lumps[term.lump] * factor[term.factor] * term.monomial(amplitude, forcing);
    sum += term.imaginary ? Complex(-product.imag(), product.real()) : product;
  }
  return sum;
}

InterpretedCase::InterpretedCase(const CanonicalModel& model, const CanonicalCase& resonance)
    : model_(model), case_(resonance), lump_formulas_(model.order.size()), gradient_formulas_(model.order.size()) {
  refuse_unsupported(model, resonance);
  for (std::size_t l = 0; l < resonance.lumps.size(); ++l) {
    lump_formulas_.add(resonance.lumps[l].definition);
    const LumpGradient gradient = lump_gradient(model, resonance.lumps[l].definition);
    const std::size_t denominator = gradient.shared ? gradient_formulas_.add(gradient.denominator) : 0;
    for (const LumpGradient::Entry& entry : gradient.entries)
      gradient_.push_back({l, entry.parameter, gradient_formulas_.add(entry.rate),
                           gradient.shared ? gradient_formulas_.add(entry.denominator_rate) : 0, denominator,
                           gradient.shared});
  }
  for (const CanonicalBlock& block : resonance.blocks)
    blocks_.push_back(std::make_unique<InterpretedBlock>(model, block));
}

void InterpretedCase::lumps(const double* symbol_values, double* lumps) const {
  const FormulaSet::Values value(lump_formulas_, symbol_values);
  for (std::size_t l = 0; l < case_.lumps.size(); ++l) lumps[l] = value[l];
}

void InterpretedCase::lumps_jacobian(const double* symbol_values, double* jacobian) const {
  const std::size_t parameters = model_.parameters.size();
  std::vector<double> values(case_.lumps.size());
  lumps(symbol_values, values.data());
  const FormulaSet::Values rate(gradient_formulas_, symbol_values);
  std::fill(jacobian, jacobian + values.size() * parameters, 0.0);
  for (const GradientEntry& entry : gradient_) {
    double value = rate[entry.rate];
    if (entry.shared) value = (value - values[entry.lump] * rate[entry.denominator_rate]) / rate[entry.denominator];
    jacobian[entry.lump * parameters + entry.parameter] = value;
  }
}

void InterpretedCase::modulation(const double* symbol_values, const double* excitation_frequency,
                                 const Complex* amplitude, const Complex* forcing, Complex* derivative) const {
  const std::size_t modes = model_.coordinates.size();
  std::vector<double> values(case_.lumps.size());
  lumps(symbol_values, values.data());
  std::fill(derivative, derivative + modes, Complex());
  for (std::size_t b = 0; b < blocks_.size(); ++b) {
    const CanonicalBlock& block = case_.blocks[b];
    if (block.modulation && !case_.mode_at_rest[block.mode])
      derivative[block.mode] += blocks_[b]->target(symbol_values, values.data(), amplitude, forcing);
  }
  // The frame turns with w_k instead of omega_k.
  for (std::size_t k = 0; k < modes; ++k) {
    if (case_.mode_at_rest[k]) continue;
    double rotation = 0;
    for (std::size_t i = 0; i < case_.observed_frequency[k].size(); ++i) {
      const CanonicalRatio ratio = case_.observed_frequency[k][i];
      const int numerator = ratio.numerator - (i == k ? ratio.denominator : 0);
      if (numerator != 0)
        rotation += static_cast<double>(numerator) / ratio.denominator *
                    (i < modes ? symbol_values[i] : excitation_frequency[i - modes]);
    }
    derivative[k] -= Complex(0, rotation) * amplitude[k];
  }
}

}  // namespace secular

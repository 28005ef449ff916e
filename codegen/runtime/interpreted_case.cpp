#include "codegen/runtime/interpreted_case.hpp"

#include <algorithm>
#include <numbers>

#include "codegen/canonical/amplitude_derivative.hpp"
#include "codegen/canonical/lump_gradient.hpp"
#include "codegen/cpp/emit_cpp.hpp"

namespace secular {

using Complex = std::complex<double>;

InterpretedBlock::InterpretedBlock(const CanonicalModel& model, const CanonicalBlock& block)
    : model_(model), formulas_(model.order.size()), slope_formulas_(model.order.size()) {
  for (std::size_t j = 0; j < block.columns.size(); ++j)
    for (const CanonicalColumnTerm& term : block.columns[j].terms) {
      for (const LumpGradient::Entry& entry : lump_gradient(model, term.factor).entries)
        slopes_.push_back({terms_.size(), entry.parameter, slope_formulas_.add(entry.rate)});
      terms_.push_back(
          {j, block.columns[j].lump, formulas_.add(term.factor), term.imaginary, Monomial(term.powers)});
    }
}

template <class Factors>
void InterpretedBlock::rows(const ObservationBatch& data, Factors factors, Complex* const* columns) const {
  const std::size_t modes = model_.coordinates.size(), excitations = model_.excitations.size();
  std::vector<double> symbols(model_.order.size(), 0.0), numbers(terms_.size());
  symbols.back() = std::numbers::pi;
  std::copy(data.natural_frequency, data.natural_frequency + modes, symbols.begin());
  std::vector<Complex> amplitude(modes), forcing(excitations);
  for (std::size_t i = 0; i < data.count; ++i) {
    for (std::size_t k = 0; k < modes; ++k) amplitude[k] = data.amplitude[k][i];
    for (std::size_t j = 0; j < excitations; ++j) {
      if (data.forcing) forcing[j] = data.forcing[j][i];
      if (data.excitation_frequency) symbols[modes + j] = data.excitation_frequency[j][i];
    }
    factors(symbols.data(), numbers.data());
    for (const Term& term : terms_) columns[term.column][i] = 0;
    for (std::size_t t = 0; t < terms_.size(); ++t) {
      const Complex product = numbers[t] * terms_[t].monomial(amplitude.data(), forcing.data());
      columns[terms_[t].column][i] += terms_[t].imaginary ? Complex(-product.imag(), product.real()) : product;
    }
  }
}

void InterpretedBlock::columns(const ObservationBatch& data, Complex* const* columns) const {
  rows(
      data,
      [&](const double* symbols, double* numbers) {
        const FormulaSet::Values factor(formulas_, symbols);
        for (std::size_t t = 0; t < terms_.size(); ++t) numbers[t] = factor[terms_[t].factor];
      },
      columns);
}

void InterpretedBlock::column_slopes(const ObservationBatch& data, std::size_t mode,
                                     Complex* const* columns) const {
  rows(
      data,
      [&](const double* symbols, double* numbers) {
        const FormulaSet::Values rate(slope_formulas_, symbols);
        std::fill(numbers, numbers + terms_.size(), 0.0);
        for (const Slope& slope : slopes_) {
          if (slope.mode == mode) numbers[slope.term] = rate[slope.rate];
        }
      },
      columns);
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
    : model_(model),
      case_(resonance),
      lump_formulas_(model.order.size()),
      gradient_formulas_(model.order.size()),
      derived_formulas_(model.order.size()) {
  refuse_unsupported(model, resonance);
  for (std::size_t l = 0; l < resonance.lumps.size(); ++l) {
    lump_formulas_.add(resonance.lumps[l].definition);
    for (const LumpGradient::Entry& entry : lump_gradient(model, resonance.lumps[l].definition).entries)
      gradient_.push_back({l, entry.parameter, gradient_formulas_.add(entry.rate)});
  }
  for (const CanonicalBlock& block : resonance.blocks)
    blocks_.push_back(std::make_unique<InterpretedBlock>(model, block));
  derive_modulation();
}

void InterpretedCase::derive_modulation() {
  for (const CanonicalBlock& block : case_.blocks) {
    if (!block.modulation || case_.mode_at_rest[block.mode]) continue;
    for (const CanonicalBlock::Column& column : block.columns)
      for (const CanonicalColumnTerm& term : column.terms)
        for (std::size_t j = 0; j < model_.coordinates.size(); ++j)
          for (const bool by_conjugate : {false, true}) {
            const auto derived = amplitude_derivative(term.powers, j, by_conjugate);
            if (!derived || case_.mode_at_rest[j]) continue;
            derived_.push_back({block.mode, j, column.lump, derived_formulas_.add(term.factor), by_conjugate,
                                term.imaginary,
                                static_cast<double>(derived->weight.numerator) / derived->weight.denominator,
                                Monomial(derived->powers)});
          }
  }
}

void InterpretedCase::lumps(const double* symbol_values, double* lumps) const {
  const FormulaSet::Values value(lump_formulas_, symbol_values);
  for (std::size_t l = 0; l < case_.lumps.size(); ++l) lumps[l] = value[l];
}

void InterpretedCase::lumps_jacobian(const double* symbol_values, double* jacobian) const {
  const std::size_t parameters = model_.parameters.size();
  const FormulaSet::Values rate(gradient_formulas_, symbol_values);
  std::fill(jacobian, jacobian + case_.lumps.size() * parameters, 0.0);
  for (const GradientEntry& entry : gradient_)
    jacobian[entry.lump * parameters + entry.parameter] = rate[entry.rate];
}

void InterpretedCase::modulation(const double* symbol_values, const double* excitation_frequency,
                                 const Complex* amplitude, const Complex* forcing, Complex* derivative) const {
  const std::size_t modes = model_.coordinates.size();
  const std::vector<double> symbols = with_excitation(symbol_values, excitation_frequency);
  std::vector<double> values(case_.lumps.size());
  lumps(symbol_values, values.data());
  std::fill(derivative, derivative + modes, Complex());
  for (std::size_t b = 0; b < blocks_.size(); ++b) {
    const CanonicalBlock& block = case_.blocks[b];
    if (block.modulation && !case_.mode_at_rest[block.mode])
      derivative[block.mode] += blocks_[b]->target(symbols.data(), values.data(), amplitude, forcing);
  }
  for (std::size_t k = 0; k < modes; ++k)
    if (!case_.mode_at_rest[k])
      derivative[k] -= Complex(0, rotation(k, symbol_values, excitation_frequency)) * amplitude[k];
}

std::vector<double> InterpretedCase::with_excitation(const double* symbol_values,
                                                     const double* excitation_frequency) const {
  std::vector<double> symbols(symbol_values, symbol_values + model_.order.size());
  if (excitation_frequency)
    std::copy_n(excitation_frequency, model_.excitations.size(),
                symbols.begin() + static_cast<std::ptrdiff_t>(model_.coordinates.size()));
  return symbols;
}

double InterpretedCase::rotation(std::size_t mode, const double* symbol_values,
                                 const double* excitation_frequency) const {
  const std::size_t modes = model_.coordinates.size();
  double sum = 0;
  for (std::size_t i = 0; i < case_.observed_frequency[mode].size(); ++i) {
    const CanonicalRatio ratio = case_.observed_frequency[mode][i];
    const int numerator = ratio.numerator - (i == mode ? ratio.denominator : 0);
    if (numerator != 0)
      sum += static_cast<double>(numerator) / ratio.denominator *
             (i < modes ? symbol_values[i] : excitation_frequency[i - modes]);
  }
  return sum;
}

void InterpretedCase::modulation_jacobian(const double* symbol_values, const double* excitation_frequency,
                                          const Complex* amplitude, const Complex* forcing,
                                          double* jacobian) const {
  const std::size_t modes = model_.coordinates.size();
  std::vector<double> values(case_.lumps.size());
  lumps(symbol_values, values.data());
  const std::vector<double> symbols = with_excitation(symbol_values, excitation_frequency);
  const FormulaSet::Values factor(derived_formulas_, symbols.data());
  std::vector<Complex> by_amplitude(modes * modes), by_conjugate(modes * modes);
  for (const DerivedTerm& term : derived_) {
    const Complex product =
        values[term.lump] * factor[term.factor] * term.weight * term.monomial(amplitude, forcing);
    (term.by_conjugate ? by_conjugate : by_amplitude)[term.mode * modes + term.along] +=
        term.imaginary ? Complex(-product.imag(), product.real()) : product;
  }
  for (std::size_t k = 0; k < modes; ++k)
    if (!case_.mode_at_rest[k])
      by_amplitude[k * modes + k] -= Complex(0, rotation(k, symbol_values, excitation_frequency));
  for (std::size_t k = 0; k < modes; ++k)
    for (std::size_t j = 0; j < modes; ++j) {
      const Complex by_real = by_amplitude[k * modes + j] + by_conjugate[k * modes + j],
                    turned = by_amplitude[k * modes + j] - by_conjugate[k * modes + j];
      double* const entry = jacobian + 4 * modes * k + 2 * j;
      entry[0] = by_real.real();
      entry[1] = -turned.imag();
      entry[2 * modes] = by_real.imag();
      entry[2 * modes + 1] = turned.real();
    }
}

}  // namespace secular

#include "thesis/procedures/block_rows.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <stdexcept>
#include <utility>

#include "estimator/identification/case_quality.hpp"
#include "estimator/identification/case_regression.hpp"

namespace secular {

using Complex = std::complex<double>;
using Eigen::Index;

std::vector<double> mean_frequencies(const ObservationSet& set) {
  std::vector<double> mean(set.model->modes(), 0.0);
  for (const Observation& o : set.observations)
    for (std::size_t k = 0; k < mean.size(); ++k)
      mean[k] += o.rate[k].imag() / static_cast<double>(set.observations.size());
  return mean;
}

BlockRows block_rows(const ObservationSet& set, std::size_t b, const std::vector<double>& natural_frequency,
                     const std::vector<std::string>& fixed) {
  const CompiledCase& resonance = *set.resonance;
  const RegressorBlock& block = resonance.blocks[b];
  const bool modulation = block.kind == BlockKind::modulation;
  const auto mode = static_cast<std::size_t>(block.mode);
  std::vector<const Observation*> used;
  for (const Observation& o : set.observations)
    if (modulation || o.harmonic_sd[b] >= 0) used.push_back(&o);
  if (used.empty()) throw std::invalid_argument("no observation has this equation");
  BlockRows rows;
  std::vector<std::size_t> kept;
  for (std::size_t j = 0; j < block.lumps.size(); ++j) {
    const std::string name(resonance.lumps[static_cast<std::size_t>(block.lumps[j])].name);
    if (std::find(fixed.begin(), fixed.end(), name) != fixed.end()) continue;
    kept.push_back(j);
    rows.names.push_back(name);
  }
  if (modulation) rows.names.emplace_back(set.model->symbols[mode].name);
  const auto columns = static_cast<Index>(rows.names.size());
  rows.regression.design.resize(2 * static_cast<Index>(used.size()), columns);
  rows.regression.response.resize(rows.regression.design.rows());
  std::vector<Complex> values(block.lumps.size());
  std::vector<Complex*> pointers;
  for (Complex& value : values) pointers.push_back(&value);
  for (std::size_t i = 0; i < used.size(); ++i) {
    const Observation& o = *used[i];
    std::vector<const Complex*> amplitude, forcing;
    std::vector<const double*> excitation;
    for (const Complex& a : o.amplitude) amplitude.push_back(&a);
    for (const Complex& f : o.forcing) forcing.push_back(&f);
    for (const double& w : o.excitation_frequency) excitation.push_back(&w);
    block.columns({1, natural_frequency.data(), excitation.data(), amplitude.data(), forcing.data()},
                  pointers.data());
    const Complex unit = modulation ? o.amplitude[mode] : Complex(1);
    const auto row = static_cast<Index>(2 * i);
    const auto put = [&](Index column, Complex value) {
      rows.regression.design(row, column) = value.real();
      rows.regression.design(row + 1, column) = value.imag();
    };
    for (std::size_t j = 0; j < kept.size(); ++j) put(static_cast<Index>(j), values[kept[j]] / unit);
    if (modulation) put(columns - 1, Complex(0, 1));
    const Complex target = modulation ? o.rate[mode] : o.harmonic[b];
    rows.regression.response(row) = target.real();
    rows.regression.response(row + 1) = target.imag();
    rows.condition.insert(rows.condition.end(), 2, o.condition);
  }
  rows.regression.fit = linear_fit(rows.regression.design, rows.regression.response, rows.condition);
  return rows;
}

BlockRows weighted_block_rows(const ObservationSet& set, std::size_t b,
                              const std::vector<double>& natural_frequency, const std::vector<std::string>& fixed) {
  CaseKnowledge known;
  known.natural_frequency = natural_frequency;
  for (const std::string& name : fixed) known.fixed[{std::string(set.resonance->name), name}] = 0;
  CaseFit fit = fit_case(set, {b}, known);
  if (fit.fit.coefficients.size() == 0) throw std::invalid_argument("no observation has this equation");
  BlockRows rows;
  for (std::size_t c = 0; c < fit.columns.size(); ++c) rows.names.push_back(column_name(fit, c));
  rows.regression.design = std::move(fit.system.design);
  rows.regression.response = std::move(fit.system.response);
  rows.condition = std::move(fit.system.condition);
  rows.regression.fit = linear_fit(rows.regression.design, rows.regression.response, rows.condition);
  return rows;
}

}  // namespace secular

#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <random>
#include <string>
#include <vector>

#include "estimator/model/compiled_model.hpp"
#include "tests/runtime/model_residual.hpp"

namespace secular::test {

using Complex = std::complex<double>;

/// A point at which all functions of a model are evaluated: numbers of order one.
struct Point {
  std::vector<double> parameters, displacement, velocity;
  std::vector<double> excitation_frequency;
  std::vector<ExcitationSample> excitation;
  std::vector<Complex> amplitude, forcing;
};

inline Point random_point(const CompiledModel& model, std::mt19937_64& random) {
  const auto uniform = [&](double low, double high) {
    return low + (high - low) * (static_cast<double>(random() >> 11) * 0x1p-53);
  };
  Point p;
  for (std::size_t i = 0; i < model.symbols.size(); ++i) p.parameters.push_back(uniform(0.5, 1.5));
  // Natural frequencies away from each other's simple multiples.
  for (std::size_t k = 0; k < model.modes(); ++k)
    p.parameters[k] = uniform(0.9, 1.1) * std::pow(2.7, static_cast<double>(k));
  for (std::size_t k = 0; k < model.modes(); ++k) {
    p.displacement.push_back(uniform(-0.1, 0.1));
    p.velocity.push_back(uniform(-1, 1));
    p.amplitude.emplace_back(uniform(-1, 1), uniform(-1, 1));
  }
  for (std::size_t j = 0; j < model.excitations.size(); ++j) {
    p.excitation_frequency.push_back(uniform(2, 2.5));
    p.excitation.push_back({uniform(-1, 1), uniform(-1, 1), uniform(-1, 1)});
    p.forcing.emplace_back(uniform(-1, 1), uniform(-1, 1));
  }
  return p;
}

/// All numbers that the functions of a model give at a point, one list a function.
inline std::vector<std::vector<double>> outputs(const CompiledModel& model, const Point& p) {
  std::vector<std::vector<double>> all;
  std::vector<double> acceleration(model.modes());
  model.acceleration(p.parameters.data(), p.excitation.data(), p.displacement.data(), p.velocity.data(),
                     acceleration.data());
  all.push_back(acceleration);
  const std::size_t modes = model.modes(), symbols = model.symbols.size();
  for (const auto& [function, size] :
       {std::pair(&model.mass_matrix, modes * modes), std::pair(&model.acceleration_by_state, 2 * modes * modes),
        std::pair(&model.acceleration_by_parameters, modes * symbols)}) {
    std::vector<double> values(size);
    (*function)(p.parameters.data(), p.excitation.data(), p.displacement.data(), p.velocity.data(), values.data());
    all.push_back(values);
  }
  for (const CompiledCase& c : model.cases) {
    std::vector<double> sensitivity(2 * modes * symbols);
    modulation_by_parameters(model, c, p.parameters.data(), p.excitation_frequency.data(), p.amplitude.data(),
                             p.forcing.data(), sensitivity.data());
    all.push_back(sensitivity);
    std::vector<double> lumps(c.lumps.size()), jacobian(c.lumps.size() * model.symbols.size());
    c.evaluate_lumps(p.parameters.data(), lumps.data());
    c.evaluate_lumps_jacobian(p.parameters.data(), jacobian.data());
    all.push_back(lumps);
    all.push_back(jacobian);
    const auto parts = [&](const std::vector<Complex>& values) {
      std::vector<double> flat;
      for (const Complex& value : values) flat.insert(flat.end(), {value.real(), value.imag()});
      all.push_back(flat);
    };
    std::vector<Complex> rate(model.modes());
    c.modulation(p.parameters.data(), p.excitation_frequency.data(), p.amplitude.data(), p.forcing.data(),
                 rate.data());
    parts(rate);
    std::vector<double> stability(4 * model.modes() * model.modes());
    c.modulation_jacobian(p.parameters.data(), p.excitation_frequency.data(), p.amplitude.data(), p.forcing.data(),
                          stability.data());
    all.push_back(stability);
    // Two observations, the second at zero amplitude.
    std::vector<std::vector<Complex>> amplitude, forcing;
    std::vector<std::vector<double>> frequency;
    for (const Complex& a : p.amplitude) amplitude.push_back({a, Complex()});
    for (const Complex& f : p.forcing) forcing.push_back({f, f});
    for (const double w : p.excitation_frequency) frequency.push_back({w, w});
    std::vector<const Complex*> amplitudes, forcings;
    std::vector<const double*> frequencies;
    for (const auto& row : amplitude) amplitudes.push_back(row.data());
    for (const auto& row : forcing) forcings.push_back(row.data());
    for (const auto& row : frequency) frequencies.push_back(row.data());
    for (const RegressorBlock& block : c.blocks) {
      std::vector<std::vector<Complex>> columns(block.lumps.size(), std::vector<Complex>(2));
      std::vector<Complex*> targets;
      for (auto& column : columns) targets.push_back(column.data());
      block.columns({2, p.parameters.data(), frequencies.data(), amplitudes.data(), forcings.data()},
                    targets.data());
      for (const auto& column : columns) parts(column);
      for (std::size_t k = 0; k < modes; ++k) {
        block.column_slopes({2, p.parameters.data(), frequencies.data(), amplitudes.data(), forcings.data()}, k,
                            targets.data());
        for (const auto& column : columns) parts(column);
      }
    }
  }
  return all;
}

/// Largest difference of any output, relative to the largest number its function gives.
inline double largest_difference(const CompiledModel& a, const CompiledModel& b, int draws) {
  std::mt19937_64 random(5);
  double worst = 0;
  for (int draw = 0; draw < draws; ++draw) {
    const Point p = random_point(a, random);
    const auto left = outputs(a, p), right = outputs(b, p);
    if (left.size() != right.size()) return INFINITY;
    for (std::size_t i = 0; i < left.size(); ++i) {
      double size = 0;
      if (left[i].size() != right[i].size()) return INFINITY;
      for (const double value : left[i]) size = std::max(size, std::abs(value));
      for (std::size_t n = 0; n < left[i].size(); ++n) {
        const double difference = std::abs(left[i][n] - right[i][n]);
        if (!(difference <= 0)) worst = std::isfinite(difference) ? std::max(worst, difference / size) : INFINITY;
      }
    }
  }
  return worst;
}

/// Names, tables and units of two models are the same.
inline void expect_same_tables(const CompiledModel& a, const CompiledModel& b) {
  EXPECT_EQ(a.name, b.name);
  EXPECT_EQ(a.source, b.source);
  EXPECT_TRUE(std::ranges::equal(a.coordinates, b.coordinates));
  EXPECT_TRUE(std::ranges::equal(a.excitations, b.excitations));
  EXPECT_TRUE(std::ranges::equal(a.excitation_frequencies, b.excitation_frequencies));
  const auto same_ratios = [](std::span<const Ratio> x, std::span<const Ratio> y) {
    return std::ranges::equal(x, y, [](const Ratio& l, const Ratio& r) {
      return l.numerator == r.numerator && l.denominator == r.denominator;
    });
  };
  ASSERT_EQ(a.symbols.size(), b.symbols.size());
  for (std::size_t p = 0; p < a.symbols.size(); ++p) {
    EXPECT_EQ(a.symbols[p].name, b.symbols[p].name);
    EXPECT_TRUE(same_ratios(a.symbols[p].dimension, b.symbols[p].dimension));
    EXPECT_TRUE(a.nominal[p] == b.nominal[p] || (std::isnan(a.nominal[p]) && std::isnan(b.nominal[p])));
  }
  ASSERT_EQ(a.cases.size(), b.cases.size());
  for (std::size_t i = 0; i < a.cases.size(); ++i) {
    const CompiledCase &x = a.cases[i], &y = b.cases[i];
    EXPECT_EQ(x.name, y.name);
    EXPECT_EQ(x.excited, y.excited);
    EXPECT_TRUE(std::ranges::equal(x.relations, y.relations));
    EXPECT_TRUE(std::ranges::equal(x.mode_at_rest, y.mode_at_rest));
    EXPECT_TRUE(same_ratios(x.observed_frequency, y.observed_frequency));
    ASSERT_EQ(x.lumps.size(), y.lumps.size());
    for (std::size_t l = 0; l < x.lumps.size(); ++l) {
      EXPECT_EQ(x.lumps[l].name, y.lumps[l].name);
      EXPECT_EQ(x.lumps[l].definition, y.lumps[l].definition);
      EXPECT_TRUE(same_ratios(x.lumps[l].dimension, y.lumps[l].dimension));
    }
    ASSERT_EQ(x.blocks.size(), y.blocks.size());
    for (std::size_t n = 0; n < x.blocks.size(); ++n) {
      EXPECT_EQ(x.blocks[n].kind, y.blocks[n].kind);
      EXPECT_EQ(x.blocks[n].name, y.blocks[n].name);
      EXPECT_EQ(x.blocks[n].mode, y.blocks[n].mode);
      EXPECT_EQ(x.blocks[n].order, y.blocks[n].order);
      EXPECT_TRUE(std::ranges::equal(x.blocks[n].phase, y.blocks[n].phase));
      EXPECT_TRUE(std::ranges::equal(x.blocks[n].lumps, y.blocks[n].lumps));
    }
  }
}

}  // namespace secular::test

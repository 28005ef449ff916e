#include "diagnose/verdict/start_values.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "input/input_error.hpp"

namespace secular {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// Slopes of the accelerations by the symbols, modes x symbols, in a motion near rest: functions of coordinates are
// smooth there.
MatrixXd slopes_by_symbols(const CompiledModel& model, const VectorXd& symbols) {
  constexpr double near_rest = 1e-4;
  const auto modes = static_cast<Index>(model.modes());
  VectorXd displacement(modes), velocity(modes);
  for (Index k = 0; k < modes; ++k) {
    displacement(k) = near_rest * (1 + 0.3 * static_cast<double>(k));
    velocity(k) = 0.7 * symbols(k) * displacement(k);
  }
  const std::vector<ExcitationSample> excitation(std::max<std::size_t>(1, model.excitations.size()),
                                                 {near_rest, near_rest * symbols(0), near_rest * symbols(0)});
  Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> slopes(modes, symbols.size());
  model.acceleration_by_parameters(symbols.data(), excitation.data(), displacement.data(), velocity.data(),
                                   slopes.data());
  return slopes;
}

// Symbols that nothing is known of and that a fit cannot be begun with at zero.
std::vector<std::string> need_a_start(const CompiledModel& model, const VectorXd& symbols,
                                      const std::vector<Index>& unknown) {
  std::vector<std::string> names;
  if (unknown.empty()) return names;
  VectorXd elsewhere = symbols;
  for (const Index s : unknown) elsewhere(s) = 1;
  const MatrixXd here = slopes_by_symbols(model, symbols), there = slopes_by_symbols(model, elsewhere);
  for (const Index s : unknown)
    if (!here.col(s).allFinite() || (here.col(s).isZero(0) && !there.col(s).isZero(0)))
      names.emplace_back(model.symbols[static_cast<std::size_t>(s)].name);
  return names;
}

// NaN: nothing is known of it.
double known_start(const CompiledModel& model, const DiagnosisOptions& options, std::size_t symbol) {
  double value = symbol < model.nominal.size() ? model.nominal[symbol] : NAN;
  if (std::isfinite(seen_frequency(options, symbol))) value = seen_frequency(options, symbol);
  for (const auto* numbers : {&options.start, &options.given.values})
    if (const auto found = numbers->find(std::string(model.symbols[symbol].name)); found != numbers->end())
      value = found->second;
  return value;
}

}  // namespace

double seen_frequency(const DiagnosisOptions& options, std::size_t mode) {
  return mode < options.natural_frequency.size() ? options.natural_frequency[mode] : NAN;
}

std::vector<std::string> symbols_without_start(const CompiledModel& model, const DiagnosisOptions& options,
                                               const std::vector<std::size_t>& own) {
  VectorXd symbols = VectorXd::Zero(static_cast<Index>(model.symbols.size()));
  std::vector<Index> unknown;
  for (std::size_t s = 0; s < model.symbols.size(); ++s) {
    const double value = known_start(model, options, s);
    if (std::isfinite(value))
      symbols(static_cast<Index>(s)) = value;
    else if (std::find(own.begin(), own.end(), s) != own.end())
      unknown.push_back(static_cast<Index>(s));
  }
  return need_a_start(model, symbols, unknown);
}

VectorXd start_values(const CompiledModel& model, const FaultTable& faults, const DiagnosisOptions& options,
                      const std::vector<std::size_t>& own) {
  VectorXd start = VectorXd::Zero(static_cast<Index>(model.symbols.size() + faults.size()));
  for (std::size_t s = 0; s < model.symbols.size(); ++s)
    if (const double value = known_start(model, options, s); std::isfinite(value))
      start(static_cast<Index>(s)) = value;
  for (std::size_t k = 0; k < model.modes(); ++k)
    if (!(start(static_cast<Index>(k)) > 0))
      throw InputError(
          std::string(model.name), "[nominal]",
          "gives no natural frequency above zero, and the records tell none, " + std::string(model.symbols[k].name),
          "a rough one tells which resonance a record excites: give it there");
  if (const auto names = symbols_without_start(model, options, own); !names.empty())
    throw InputError(std::string(model.name), "[nominal]",
                     fmt::format("gives no start for {}: from zero the equations tell no way to the right value",
                                 fmt::join(names, ", ")),
                     "rough values there, of the right sign and order of size");
  const auto symbols = static_cast<Index>(model.symbols.size());
  start(symbols + static_cast<Index>(faults.extra_frequency())) = start(0);
  start(symbols + static_cast<Index>(faults.extra_damping())) = 0.01;
  return start;
}

}  // namespace secular

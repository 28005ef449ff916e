#include "diagnose/verdict/given_numbers.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "diagnose/inference/contradiction.hpp"
#include "diagnose/thresholds.hpp"
#include "input/input_error.hpp"
#include "numerics/distribution.hpp"

namespace secular {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

/// A parameter counts as moved from so many standard deviations on.
constexpr auto& moved_by = diagnose_thresholds().moved_by;

std::string name_of(const CompiledModel& model, std::size_t symbol) {
  return std::string(model.symbols[symbol].name);
}

// Symbols of the model; what is beyond them are nuisances, of which nothing is given.
bool is_symbol(const CompiledModel& model, std::size_t unknown) {
  return unknown < model.symbols.size();
}

bool is_open(const GivenNumbers& given, const CompiledModel& model, std::size_t unknown) {
  return !is_symbol(model, unknown) || given.open.contains(name_of(model, unknown));
}

// Of the given numbers' error bars by the free unknowns of a fit.
VectorXd given_sd(const GivenNumbers& given, const CompiledModel& model, const Refit& fit) {
  VectorXd sd(static_cast<Index>(fit.free.size()));
  for (Index f = 0; f < sd.size(); ++f) {
    const std::size_t unknown = fit.free[static_cast<std::size_t>(f)];
    if (is_open(given, model, unknown)) {
      sd(f) = std::numeric_limits<double>::infinity();
      continue;
    }
    const auto found = given.sd.find(name_of(model, unknown));
    sd(f) = found == given.sd.end() ? 0 : found->second;
  }
  return sd;
}

}  // namespace

Judged whose_gap(const GivenNumbers& given) {
  if (!given) return Judged::fitted;
  return given.sd.empty() ? Judged::given : Judged::within_error_bars;
}

std::string to_string(Judged judged) {
  switch (judged) {
    case Judged::fitted:
      return "fitted parameters";
    case Judged::given:
      return "given numbers";
    case Judged::within_error_bars:
      return "given numbers within their error bars";
  }
  return "";
}

void check_given(const GivenNumbers& given, const CompiledModel& model, const std::vector<std::size_t>& own) {
  if (!given) return;
  for (const auto& [name, value] : given.values) {
    const bool known =
        std::any_of(own.begin(), own.end(), [&](std::size_t s) { return name_of(model, s) == name; });
    if (!known)
      throw InputError("--parameters", "symbol " + name, "is no symbol of model " + std::string(model.name), "");
  }
  for (const std::size_t s : own) {
    const std::string name = name_of(model, s);
    const bool nominal = s < model.nominal.size() && std::isfinite(model.nominal[s]);
    if (!given.values.contains(name) && !nominal)
      throw InputError(
          "--parameters", "symbol " + name, "has no value",
          "the gap of given numbers is that of all of them; leave --parameters out to have them fitted");
  }
}

bool are_rough_frequencies(const GivenNumbers& given, const CompiledModel& model,
                           const std::vector<std::size_t>& own) {
  const auto frequencies = model.symbols.first(model.modes());
  const auto is_frequency = [&](const auto& value) {
    return std::any_of(frequencies.begin(), frequencies.end(),
                       [&](const CompiledSymbol& symbol) { return symbol.name == value.first; });
  };
  if (!given || !std::all_of(given.values.begin(), given.values.end(), is_frequency)) return false;
  return std::any_of(own.begin(), own.end(), [&](std::size_t s) {
    return !given.values.contains(std::string(model.symbols[s].name)) && !std::isfinite(model.nominal[s]);
  });
}

std::vector<double> claimed_frequencies(const GivenNumbers& given, const std::vector<std::string>& names,
                                        std::vector<double> nominal) {
  for (std::size_t k = 0; k < nominal.size(); ++k)
    if (const auto claim = given.values.find(names[k]); claim != given.values.end()) nominal[k] = claim->second;
  return nominal;
}

std::vector<double> frequencies_of_records(const std::vector<double>& claimed, std::vector<double> shown,
                                           const std::vector<bool>& moved) {
  for (std::size_t k = 0; k < claimed.size(); ++k)
    if (std::isfinite(claimed[k]) && !moved[k]) shown[k] = claimed[k];
  return shown;
}

JudgedNumbers judge_given(const GivenNumbers& given, const CompiledModel& model,
                          const std::vector<std::size_t>& fitted, const Discrepancy& discrepancy,
                          const VectorXd& start, unsigned threads) {
  std::vector<std::size_t> open;
  for (const std::size_t u : fitted)
    if (is_open(given, model, u)) open.push_back(u);
  JudgedNumbers judged;
  if (open.empty()) {
    judged = {start, discrepancy(start), 0, {}};
  } else {
    RefitOptions options;
    options.threads = threads;
    Refit fit = refit(discrepancy, start, open, options);
    judged = {std::move(fit.unknowns), std::move(fit.rows), fit.rank, {}};
  }
  const std::vector<RowLabel> labels = discrepancy.labels();
  for (Index r = 0; r < judged.rows.size(); ++r) {
    if (std::isfinite(judged.rows(r))) continue;
    judged.rows(r) = diagnose_thresholds().no_motion;
    judged.without_motion.insert(labels[static_cast<std::size_t>(r)].record);
  }
  return judged;
}

double moved_p_value(const GivenNumbers& given, const JudgedNumbers& judged, const CompiledModel& model,
                     const VectorXd& start, const Refit& fit) {
  if (given.sd.empty())
    return chi_squared_upper_tail(judged.rows.squaredNorm() - fit.chi_squared,
                                  static_cast<double>(fit.rank - judged.rank));
  VectorXd numbers(static_cast<Index>(fit.free.size()));
  for (Index f = 0; f < numbers.size(); ++f)
    numbers(f) = start(static_cast<Index>(fit.free[static_cast<std::size_t>(f)]));
  const Contradiction found = contradiction(fit, numbers, given_sd(given, model, fit));
  return chi_squared_upper_tail(found.chi_squared, static_cast<double>(found.rank));
}

std::vector<ParameterMove> moved_parameters(const CompiledModel& model, const VectorXd& start, const Refit& fit) {
  std::vector<ParameterMove> moved;
  for (std::size_t f = 0; f < fit.free.size(); ++f) {
    if (!is_symbol(model, fit.free[f])) continue;
    const auto u = static_cast<Index>(fit.free[f]);
    const double sd = std::sqrt(std::max(0.0, fit.covariance(static_cast<Index>(f), static_cast<Index>(f))));
    if (fit.identifiable[f] && std::abs(fit.unknowns(u) - start(u)) > moved_by * sd)
      moved.push_back({name_of(model, fit.free[f]), start(u), fit.unknowns(u), sd});
  }
  return moved;
}

}  // namespace secular

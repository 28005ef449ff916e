#include "app/procedure/procedure_bias.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <map>
#include <optional>
#include <string>
#include <tuple>

#include "app/shared/progress_line.hpp"
#include "estimator/identification/identified_lumps.hpp"
#include "motion/correction/observation_noise.hpp"
#include "motion/correction/steady_set.hpp"
#include "numerics/in_parallel.hpp"

namespace secular::app {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

/// Draws of the noise: they tell a standard deviation to 7 %.
constexpr std::uint64_t noise_draws = 100;

/// Rows of the same quantity in the same section.
using RowKey = std::tuple<std::string, std::string, std::string>;
using Errors = std::map<RowKey, double>;

RowKey key_of(const ProcedureSection& section, const ProcedureRow& row) {
  return {section.method, section.title, row.name};
}

// Recovered minus true.
Errors errors_of(const std::vector<ProcedureSection>& sections) {
  Errors errors;
  for (const ProcedureSection& section : sections)
    for (const ProcedureRow& row : section.rows)
      if (row.truth && std::isfinite(row.recovered)) errors[key_of(section, row)] = row.recovered - *row.truth;
  return errors;
}

/// Over independent directions in which the parameters are uncertain.
struct Uncertainty {
  std::map<RowKey, double> square;  ///< by row: sum of the squares by which its error grows along each
  Index lost = 0;                   ///< directions along which a dwell has no steady motion
};

Uncertainty uncertainty_along(const Eigen::MatrixXd& directions, const VectorXd& parameters, SteadySet& motions,
                              const MethodsOn& methods, const Errors& exact, unsigned threads) {
  std::vector<VectorXd> moved;
  std::vector<std::optional<ObservationSet>> shown;
  for (const VectorXd direction : directions.colwise()) {
    moved.push_back(parameters + direction);
    shown.push_back(motions.at(moved.back()));
  }
  std::vector<Errors> along(shown.size());
  in_parallel(along.size(), threads, [&](std::size_t d) {
    if (shown[d]) along[d] = errors_of(methods(*shown[d], moved[d]));
  });
  Uncertainty result;
  result.lost = std::count_if(shown.begin(), shown.end(), [](const auto& set) { return !set; });
  for (const Errors& errors : along)
    for (const auto& [key, error] : errors)
      if (const auto before = exact.find(key); before != exact.end())
        result.square[key] += std::pow(error - before->second, 2);
  return result;
}

}  // namespace

void add_bias(ProcedureRun& run, const MethodsOn& methods, const Estimate& identified, unsigned threads) {
  const VectorXd parameters = representative_parameters(identified);
  SteadySet motions(run.measured, threads);
  const std::optional<ObservationSet> exact = motions.at(parameters);
  if (!exact) {
    run.warnings.push_back(
        "the bias of the methods is not known: the full equations of motion with the identified parameters have no "
        "steady motion near every dwell");
    return;
  }
  std::vector<Errors> draws(noise_draws);
  ProgressLine line("noise draws");
  std::atomic<std::size_t> done{0};
  in_parallel(noise_draws, threads, [&](std::size_t draw) {
    draws[draw] = errors_of(methods(with_observation_noise(*exact, draw + 1), parameters));
    line(++done, noise_draws);
  });
  std::map<RowKey, std::vector<double>> errors;
  for (const Errors& draw : draws)
    for (const auto& [key, error] : draw) errors[key].push_back(error);
  const Errors without_noise = errors_of(methods(*exact, parameters));
  const auto along = [&](const Eigen::MatrixXd& directions) {
    return uncertainty_along(directions, parameters, motions, methods, without_noise, threads);
  };
  Uncertainty by_noise = along(identified.noise), open = along(identified.open);
  if (const Index lost = by_noise.lost + open.lost; lost > 0)
    run.warnings.push_back(
        fmt::format("along {} of the {} directions in which the identified parameters are uncertain a dwell has no "
                    "steady motion: "
                    "error bars without the bias do not contain them",
                    lost, identified.noise.cols() + identified.open.cols()));
  for (ProcedureSection& section : run.sections)
    for (ProcedureRow& row : section.rows) {
      const RowKey key = key_of(section, row);
      const auto found = errors.find(key);
      // A law that half of the draws decide against says nothing of its rows.
      if (found == errors.end() || found->second.size() < noise_draws / 2) continue;
      const Eigen::Map<const VectorXd> all(found->second.data(), static_cast<Index>(found->second.size()));
      ProcedureBias bias;
      bias.value = all.mean();
      bias.degrees_of_freedom = static_cast<double>(all.size() - 1);
      bias.noise_sd =
          std::sqrt((all.array() - bias.value).square().sum() / bias.degrees_of_freedom + by_noise.square[key]);
      bias.open_sd = std::sqrt(open.square[key]);
      // Which dwells respond is the same in every draw: the brackets of the jumps come on top.
      if (section.method == "jump_frequencies") bias.noise_sd = std::hypot(bias.noise_sd, row.sd.value_or(0));
      row.bias = bias;
    }
}

}  // namespace secular::app

#pragma once

#include <Eigen/Core>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "diagnose/inference/refit.hpp"
#include "estimator/model/compiled_model.hpp"

namespace secular {

/// Numbers of a model's own parameters that somebody claims. No values: every parameter is the campaign's to
/// choose.
struct GivenNumbers {
  std::map<std::string, double> values;  ///< by symbol
  std::map<std::string, double> sd;      ///< where they came with error bars
  std::set<std::string> open;            ///< of `values`: only starts, nothing was said of these
  explicit operator bool() const { return !values.empty(); }
};

/// Whose gap it is.
enum class Judged {
  fitted,            ///< the model with whatever parameters fit best
  given,             ///< the numbers that were given
  within_error_bars  ///< the numbers that were given, as far as their error bars reach
};

/// `fitted` without numbers, `within_error_bars` where any of them has an error bar.
Judged whose_gap(const GivenNumbers& given);
/// Words of a report: "given numbers".
std::string to_string(Judged judged);

/// Throws InputError where a number belongs to no symbol of `own`, or where numbers are given and a symbol of `own`
/// has neither one nor a nominal value. `own`: indices of the model's own symbols.
void check_given(const GivenNumbers& given, const CompiledModel& model, const std::vector<std::size_t>& own);

/// Whether they say where the modes are and nothing else, of a model with further parameters that it has no number
/// for: no numbers whose gap could be judged, but a start.
bool are_rough_frequencies(const GivenNumbers& given, const CompiledModel& model,
                           const std::vector<std::size_t>& own);

/// By mode, rad/s: natural frequencies that are claimed, the given ones in the place of a model's `nominal` ones
/// (NaN: none). `names`: their symbols.
std::vector<double> claimed_frequencies(const GivenNumbers& given, const std::vector<std::string>& names,
                                        std::vector<double> nominal);

/// Where the records are: as claimed, or as they show (NaN: they do not) where nothing is or they show another one
/// (`moved`).
std::vector<double> frequencies_of_records(const std::vector<double>& claimed, std::vector<double> shown,
                                           const std::vector<bool>& moved);

/// The given numbers against a campaign.
struct JudgedNumbers {
  Eigen::VectorXd unknowns;  ///< of the discrepancy, what was left open fitted
  Eigen::VectorXd rows;
  Eigen::Index rank = 0;                 ///< of what was left open
  std::set<std::size_t> without_motion;  ///< records near whose motion the model has none with these numbers
};

/// Rows of the numbers in `start`; those of a record near whose motion the model has none then count as off by
/// DiagnoseThresholds::no_motion. Of `fitted` (the model's own symbols and nuisances) the campaign chooses those
/// that are open and all nuisances.
JudgedNumbers judge_given(const GivenNumbers& given, const CompiledModel& model,
                          const std::vector<std::size_t>& fitted, const Discrepancy& discrepancy,
                          const Eigen::VectorXd& start, unsigned threads);

/// p that the given numbers, within their error bars if they have any, are those that fit best (`fit`).
double moved_p_value(const GivenNumbers& given, const JudgedNumbers& judged, const CompiledModel& model,
                     const Eigen::VectorXd& start, const Refit& fit);

struct ParameterMove {
  std::string name;
  double from = 0, to = 0, sd = 0;
};

/// Free unknowns of `fit` that lie more than three of its standard deviations from `start`.
std::vector<ParameterMove> moved_parameters(const CompiledModel& model, const Eigen::VectorXd& start,
                                            const Refit& fit);

}  // namespace secular

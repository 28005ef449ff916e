#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace secular {

/// How one block of equations was fitted.
struct BlockQuality {
  std::string name;
  std::string resonance;
  std::size_t equations = 0, conditions = 0;
  double normalised_residual = 0;  ///< residual over what the measured noise explains; 1 is perfect
  double condition_index = 0;      ///< largest of the case's regression, scaled columns
  bool clustered = false;          ///< covariance from scatter between conditions
  std::map<std::string, double> variance_inflation;
};

/// Test of one coefficient added last: F = (value/sd)^2 with 1 and `degrees_of_freedom` (conditions - 1 where the
/// error bar comes from their scatter). `p_value_holm` allows for all tests of the case (Holm).
struct PartialF {
  double f = 0, degrees_of_freedom = 0, p_value = 1, p_value_holm = 1;
  std::size_t tests = 0;
};

/// Percentiles over resampled conditions.
struct BootstrapInterval {
  double low = 0, high = 0, sd = 0;
};

/// One excitation condition in the regression of its case.
struct ConditionQuality {
  std::string resonance;
  std::size_t record = 0, ensembles = 0;
  double leverage =
      0;  ///< sum over its rows; the columns of the regression share out their number among conditions
  double influence = 0;                   ///< Cook's distance of leaving it out, in the metric of the covariance
  double residual = 0;                    ///< root mean square, over what noise explains
  std::vector<double> amplitude;          ///< peak, [mode], mean over ensembles
  std::optional<double> gamma, gamma_sd;  ///< rad; combination resonances: arg(F conj(A1) conj(A2))
};

/// An ensemble that stands out from the others of its condition.
struct OutlyingEnsemble {
  std::string resonance;
  std::size_t record = 0;
  double centre_s = 0;
  double distance = 0;  ///< from the median of its condition, in units of what is usual
  double weight = 1;    ///< in the regression
};

/// One damping law of a mode: these terms and no others of the candidates.
struct DampingLaw {
  std::vector<std::string> terms;
  double score = 0;             ///< mean square of the equation error in conditions that were left out, over noise
  double worse_by = 0, sd = 0;  ///< than the chosen law, paired over conditions
  double p_value = 1;           ///< that it predicts no worse than the chosen law: see DampingComparison
  bool excluded = false;        ///< p_value below 0.5 %
};

/// Laws are compared condition by condition, each predicted by the others, with the signed-rank test of Wilcoxon
/// (with Student's paired test below eight conditions, whose ranks alone could not decide). A wrong law fails by
/// factors that differ from condition to condition: their mean has a large error, but next to every difference has
/// the same sign.
struct DampingComparison {
  std::string resonance, mode;
  std::vector<DampingLaw> laws;  ///< best score first
  std::size_t chosen = 0;  ///< of the laws that predict no worse than the best one, that with the fewest terms
  bool decided = false;    ///< every law that lacks a term of the chosen one is excluded
};

/// A way to change parameters that no equation of the campaign notices.
struct NullDirection {
  std::vector<std::string> parameters;
  std::string text;                    ///< readable: what goes with what
  std::vector<std::string> parted_by;  ///< cases or components that would notice it
};

}  // namespace secular

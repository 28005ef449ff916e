#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "estimator/identification/case_regression.hpp"

namespace secular {

/// One real equation of a case against the repeatability of the data: does it hold at every condition as well as
/// repeats of one condition agree with each other?
struct LackOfFit {
  std::size_t block = 0;  ///< index into CompiledCase::blocks
  EquationPart part = EquationPart::in_phase;
  std::string name;            ///< readable
  std::size_t conditions = 0;  ///< with observations of it; of a decay: stretches
  /// Root mean square of the conditions' means over what the scatter of repeats gives; 1 is perfect.
  double misfit_ratio = 0;
  double scatter_ratio = 0;  ///< scatter of repeats over what the measured noise explains; 1 is perfect
  double f = 0;              ///< misfit_ratio squared: F of lack of fit against pure error
  /// Sum of squares of the conditions' means, over the measured noise, beyond what it is at f = 1.
  double beyond = 0;
  double numerator_df = 0;    ///< conditions less the unknowns that this equation takes up
  double denominator_df = 0;  ///< repeats; infinite where there are too few and the measured noise stands for them
  double p_value = 1;         ///< of one equation
  bool significant = false;   ///< with all equations of the case allowed for (Bonferroni, 0.1 %)
};

/// docs/inference.md (14). F test of lack of fit for every equation of a case: residuals in the frame of the
/// motion, over their measured noise, are split into the conditions' means and the scatter about them. Repeats are
/// the ensembles of a dwell; of a decay, what windows that do not overlap leave from one to the next beyond any
/// smooth law counts as scatter. An equation with fewer means than unknowns is left out. `unknown`: how far
/// parameters may be along the moves of ObservationSet::truncation_of_moves and then along the directions of
/// truncation_change, by independent unknowns; empty: one standard deviation each.
std::vector<LackOfFit> lack_of_fit(const CaseFit& fit, const Eigen::MatrixXd& unknown);

/// docs/inference.md (15). Columns x perturbations: what a lack of fit as large as the one that is seen, in
/// each equation where it is significant, does to the coefficients where it lies along them. The least-squares
/// residual shows only what no column can imitate; an effect that the model lacks is as likely to have a part that
/// the columns take up. For a combination w of coefficients that part moves w'b by |w'M| at most if it is no larger
/// than what is seen. Zero columns: no lack of fit.
Eigen::MatrixXd hidden_misfit(const CaseFit& fit, const std::vector<LackOfFit>& tests);

}  // namespace secular

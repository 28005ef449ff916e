#pragma once

#include "diagnose/inference/explanation_search.hpp"

namespace secular {

/// The model as it is, at the finest errors that it can live with. Of a model that is far from the data a fine fit
/// would be bent beyond all sense; what it lacks is looked for first, among errors that it can live with.
void fit_null(ExplanationSearch& search, const Eigen::VectorXd& start);

/// A fit once more among the errors of the measurement at its own unknowns, again and again until that moves none
/// of those that the rows tell by more than a hundredth of its standard deviation. Stalled where it does not come
/// to rest, or where a fit on the way stalls.
Refit bring_to_rest(Discrepancy& discrepancy, Refit fit, const InferenceOptions& options);

/// The model as it is among the errors of the measurement at this explanation, from where it was and from there.
void settle_null(ExplanationSearch& search, const Explanation& best);

}  // namespace secular

#pragma once

#include "diagnose/inference/explanation_search.hpp"

namespace secular {

/// The model as it is and the likeliest explanations from where a search among other rows of the same records left
/// them, at errors that are taken at the best of them; single candidates that show at first order beside the model
/// as it is, where those rows saw no gap. A way from the model's start among rows that hold many turns leads to
/// where a phase is a whole turn off; one from rows of few turns does not.
void fit_near(ExplanationSearch& search, const Inference& near);

}  // namespace secular

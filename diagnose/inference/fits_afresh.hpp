#pragma once

#include "diagnose/inference/explanation_search.hpp"

namespace secular {

/// The model's own numbers may follow what is missing to where no step leads back, and whatever is tried beside
/// them there is bent as well. If the first few effects leave more than noise there, and one of them on its own
/// way from the start does not, that one is the best, and the rest is judged beside it: whether that is so.
bool begin_afresh(ExplanationSearch& search, const Eigen::VectorXd& start);

/// Where even the best explanation leaves more than noise, the model's own numbers may have followed what was
/// missing to where no step leads back: the best effects once more, each on its own way from the start. Whether
/// one of them is the best now.
bool start_afresh(ExplanationSearch& search, const Eigen::VectorXd& start);

}  // namespace secular

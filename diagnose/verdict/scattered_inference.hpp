#pragma once

#include <Eigen/Core>
#include <vector>

#include "diagnose/inference/inference.hpp"
#include "diagnose/verdict/frequency_scatter.hpp"

namespace secular {

/// What the candidates explain, and how natural frequencies differ from record to record beside that.
struct ScatteredInference {
  Inference inference;
  FrequencyScatter scatter;  ///< none where `of_records` admits none
};

/// What infer() is asked, of whatever discrepancy.
struct InferenceTask {
  const std::vector<Candidate>& candidates;
  const Eigen::VectorXd& start;
  const std::vector<std::size_t>& own;
  const InferenceOptions& options;
};

/// As infer(). Natural frequencies scatter about the model where it leaves no more
/// than noise, else about the best explanation. What a model that lacks something leaves of them is larger: with
/// what is left about its best explanation the search is made again, and `of_records`, what `discrepancy` admits
/// of each record, changes with it. A smaller scatter allows for less: where the larger one leaves more than
/// noise already, it is not what is there, or not all. `knows_without`: what is found without any scatter is known;
/// the search is not made, and the scatter does not suffice.
ScatteredInference infer_beside_scatter(Discrepancy& discrepancy, RecordNuisances& of_records,
                                        const InferenceTask& task, bool knows_without);

}  // namespace secular

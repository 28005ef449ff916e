#pragma once

#include <map>
#include <string>
#include <vector>

namespace secular {

struct EvaluationRequest {
  std::string model;                     ///< as ModelSource takes it
  std::string resonance;                 ///< a case
  std::map<std::string, double> values;  ///< of every symbol
  std::string values_name;               ///< what messages call them
  bool omega_kept = false;               ///< Omega inside coefficients stays; else its resonant value stands for it
};

struct Evaluation {
  std::string json;  ///< what `secular evaluate` prints
  std::vector<std::string> warnings;
};

/// The job `evaluate`: numbers of a derivation, see evaluation_json(). Throws InputError.
Evaluation evaluate(const EvaluationRequest& request);

}  // namespace secular

#pragma once

#include <memory>
#include <string>
#include <vector>

#include "jobs/shared/model_loading.hpp"
#include "measure/observe/dwell_resonance.hpp"

namespace secular {

/// Natural frequencies by which records are told apart, and what to say of the nominal ones.
struct FrequencyStarts {
  std::vector<DwellTones> dwells;
  std::vector<Resonance> cases;       ///< of the model, in its order; those that were not chosen have no excitation
  std::vector<double> frequency;      ///< by mode, rad/s; NaN: not determined
  std::vector<bool> moved;            ///< by mode: the nominal one is not what the records show
  std::vector<std::string> warnings;  ///< one, where a nominal one was moved
};

/// What the records of the window show, see secular::natural_frequency_starts. `nominal`: by mode, rad/s; `chosen`:
/// names of cases; empty: all.
FrequencyStarts frequency_starts(const ModelSource& model, const Campaign& campaign, const RecordReader& read,
                                 const std::vector<double>& nominal, const std::vector<std::string>& chosen,
                                 const Window& window);

/// The model with natural frequencies that were moved in place of its nominal ones.
std::shared_ptr<const CompiledModel> with_starts(std::shared_ptr<const CompiledModel> model,
                                                 const FrequencyStarts& starts);

/// Cases by name with the records that they explain, in the order of the model.
struct Assignment {
  std::vector<std::string> names;
  std::vector<std::vector<bool>> records;  ///< [case][record]
  std::vector<std::string> warnings;
};

/// Every dwell goes to the case whose resonance it excites, decays to cases of free motion. Throws InputError where
/// no record belongs to any.
Assignment assign_records(const ModelSource& model, const Campaign& campaign, const FrequencyStarts& starts,
                          const std::vector<std::string>& chosen, const Window& window);

}  // namespace secular

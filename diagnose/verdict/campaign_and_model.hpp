#pragma once

#include <cstddef>
#include <vector>

#include "estimator/model/compiled_model.hpp"
#include "measure/data/campaign.hpp"
#include "measure/observe/observation_set.hpp"

namespace secular {

/// A campaign, and the model that it is compared with. What is referred to outlives what is made of it.
struct CampaignAndModel {
  const Campaign& campaign;
  RecordReader read;
  const CompiledModel& model;    ///< with every effect that it is tried with
  std::vector<std::size_t> own;  ///< symbols of the model as it was
};

}  // namespace secular

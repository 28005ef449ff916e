#include "app/estimate_json.hpp"

#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>

#include "estimator/regression/confidence.hpp"

namespace secular::app {
namespace {

using Json = nlohmann::ordered_json;

Json value_json(const EstimatedValue& value, bool lump) {
  Json entry;
  entry["name"] = value.name;
  if (lump) entry["definition"] = value.definition;
  if (value.value) {
    entry["value"] = *value.value;
    entry["sd"] = value.sd;
    if (value.fixed) {
      entry["ci95"] = {*value.value, *value.value};
    } else {
      const Interval interval = confidence_interval(*value.value, value.sd, value.degrees_of_freedom);
      entry["ci95"] = {interval.low, interval.high};
    }
  } else {
    entry["value"] = nullptr;
    entry["sd"] = nullptr;
    entry["ci95"] = nullptr;
  }
  entry["unit"] = value.unit;
  entry["identifiable"] = value.identifiable;
  entry["significant"] = value.significant;
  entry["from"] = value.from;
  if (value.fixed) entry["fixed"] = true;
  if (value.truncation != 0) entry["truncation_correction"] = -value.truncation;
  if (!value.identifiable) entry["entangled_with"] = value.entangled_with;
  return entry;
}

}  // namespace

std::string estimate_json(const Identification& identification) {
  Json result;
  result["schema"] = 1;
  result["model"] = identification.model->name;
  result["case"] = identification.resonance->name;
  result["estimates"] = Json::array();
  for (const EstimatedValue& value : identification.estimate.parameters)
    result["estimates"].push_back(value_json(value, false));
  result["lumps"] = Json::array();
  for (const EstimatedValue& value : identification.estimate.lumps)
    result["lumps"].push_back(value_json(value, true));
  Json quality;
  quality["observations"] = identification.measured.observations.size();
  quality["blocks"] = Json::array();
  for (const BlockQuality& block : identification.estimate.blocks) {
    Json entry;
    entry["name"] = block.name;
    entry["equations"] = block.equations;
    entry["conditions"] = block.conditions;
    entry["normalised_residual"] = block.normalised_residual;
    entry["condition_index"] = block.condition_index;
    entry["covariance"] = block.clustered ? "clustered by condition" : "from residuals";
    for (const auto& [name, inflation] : block.variance_inflation) entry["variance_inflation"][name] = inflation;
    quality["blocks"].push_back(std::move(entry));
  }
  if (!identification.held_out.empty()) {
    quality["held_out"] = Json::array();
    for (const HeldOutPrediction& prediction : identification.held_out)
      quality["held_out"].push_back({{"record", identification.campaign.records[prediction.record].file},
                                     {"from_s", prediction.from_s},
                                     {"to_s", prediction.to_s},
                                     {"rms", prediction.rms},
                                     {"largest_excursion", prediction.amplitude},
                                     {"unit", identification.coordinate_unit}});
  }
  quality["warnings"] = identification.estimate.warnings;
  result["quality"] = std::move(quality);
  return result.dump(2) + "\n";
}

}  // namespace secular::app

#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "jobs/identify/identification.hpp"

namespace secular {

/// Field `scatter_between_records` of an estimate that several records tell.
nlohmann::ordered_json scatter_json(const EstimatedValue& value, const Estimate& estimate);

/// A line for each number that differs from record to record by more than chance allows.
std::vector<std::string> scatter_lines(const Estimate& estimate);

/// The same as disturbances of the records that tell such a number, each with its own shift.
std::vector<Disturbance> scatter_disturbances(const Identification& id);

}  // namespace secular

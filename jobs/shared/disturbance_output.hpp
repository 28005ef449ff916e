#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "measure/data/campaign.hpp"
#include "measure/disturbances/disturbance.hpp"
#include "report/html_report.hpp"

namespace secular {

/// The array `disturbances` of results.
nlohmann::ordered_json disturbances_json(const std::vector<Disturbance>& found, const Campaign& campaign);

/// A table with the worst of each kind, and a figure of the worst of all, whose record is read again.
void add_disturbances(report::HtmlReport& page, const std::vector<Disturbance>& found, const Campaign& campaign);

}  // namespace secular

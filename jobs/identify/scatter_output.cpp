#include "jobs/identify/scatter_output.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "measure/disturbances/catalogue.hpp"
#include "measure/thresholds.hpp"
#include "report/number_format.hpp"

namespace secular {
namespace {

// At the level of all disturbances: once in so many campaigns whose records do not differ.
bool is_significant(const EstimatedValue& value, const Estimate& estimate) {
  const auto tests = std::count_if(estimate.parameters.begin(), estimate.parameters.end(),
                                   [](const EstimatedValue& v) { return v.between_records.has_value(); });
  return value.value && value.between_records &&
         value.between_records->p_value < measure_thresholds().disturbance_false_alarm / static_cast<double>(tests);
}

// Where a record was observed.
std::pair<double, double> span_of(const Identification& id, std::size_t record) {
  double from = INFINITY, to = -INFINITY;
  for (const ObservationSet& set : id.measured)
    for (const Observation& o : set.observations)
      if (o.record == record) {
        from = std::min(from, o.centre_s - 0.5 * o.length_s);
        to = std::max(to, o.centre_s + 0.5 * o.length_s);
      }
  return {from, to};
}

}  // namespace

nlohmann::ordered_json scatter_json(const EstimatedValue& value, const Estimate& estimate) {
  const ScatterBetweenRecords& scatter = *value.between_records;
  return {{"value", scatter.sd},        {"ci95", {scatter.low, scatter.high}},
          {"unit", value.unit},         {"records", scatter.records.size()},
          {"p_value", scatter.p_value}, {"significant", is_significant(value, estimate)}};
}

std::vector<std::string> scatter_lines(const Estimate& estimate) {
  std::vector<std::string> lines;
  for (const EstimatedValue& value : estimate.parameters)
    if (is_significant(value, estimate)) {
      const ScatterBetweenRecords& scatter = *value.between_records;
      const auto percent = [&](double sd) { return report::format_number(100 * sd / std::abs(*value.value), 2); };
      lines.push_back(
          fmt::format("{} differs from record to record: sd {} {} ({} %, 95 % interval {} to {} %, {} records)",
                      value.name, report::format_number(scatter.sd, 3), value.unit, percent(scatter.sd),
                      percent(scatter.low), percent(scatter.high), scatter.records.size()));
    }
  return lines;
}

std::vector<Disturbance> scatter_disturbances(const Identification& id) {
  std::vector<Disturbance> found;
  for (const EstimatedValue& value : id.estimate.parameters) {
    if (!is_significant(value, id.estimate)) continue;
    const ScatterBetweenRecords& scatter = *value.between_records;
    for (std::size_t r = 0; r < scatter.records.size(); ++r) {
      Disturbance entry;
      entry.kind = "record_scatter";
      entry.treated = "fitted";
      entry.record = scatter.records[r];
      std::tie(entry.from_s, entry.to_s) = span_of(id, entry.record);
      entry.size = scatter.shifts[r];
      entry.unit = value.unit;
      entry.share = std::abs(entry.size / *value.value);
      entry.text = fmt::format("{} is {} % {} the mean of {} records", value.name,
                               report::format_number(100 * entry.share, 2), entry.size < 0 ? "below" : "above",
                               scatter.records.size());
      found.push_back(std::move(entry));
    }
  }
  return found;
}

}  // namespace secular

#include "measure/disturbances/disturbance_watch.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <utility>

#include "measure/disturbances/catalogue.hpp"

namespace secular {

WatchedReader::Look DisturbanceWatch::look() {
  return [this](std::size_t index, const Record& record, const std::vector<ChannelValues>& values) {
    std::vector<Disturbance> found = find_disturbances(campaign_, index, record, values);
    const std::lock_guard lock(mutex_);
    found_.emplace(index, std::move(found));
  };
}

std::vector<Disturbance> DisturbanceWatch::found() const {
  const std::lock_guard lock(mutex_);
  std::vector<Disturbance> all;
  for (const auto& [record, found] : found_) all.insert(all.end(), found.begin(), found.end());
  return all;
}

std::size_t DisturbanceWatch::records() const {
  const std::lock_guard lock(mutex_);
  return found_.size();
}

std::vector<const Disturbance*> worst_of_kinds(const std::vector<Disturbance>& found) {
  std::map<std::string_view, const Disturbance*> worst;
  for (const Disturbance& disturbance : found) {
    const Disturbance*& of_kind = worst[disturbance.kind];
    if (of_kind == nullptr || disturbance.share > of_kind->share) of_kind = &disturbance;
  }
  std::vector<const Disturbance*> result;
  for (const auto& [kind, disturbance] : worst) result.push_back(disturbance);
  std::stable_sort(result.begin(), result.end(),
                   [](const Disturbance* a, const Disturbance* b) { return a->share > b->share; });
  return result;
}

std::size_t records_with(const std::vector<Disturbance>& found, std::string_view kind) {
  std::set<std::size_t> records;
  for (const Disturbance& disturbance : found)
    if (disturbance.kind == kind) records.insert(disturbance.record);
  return records.size();
}

std::vector<std::string> disturbance_lines(const std::vector<Disturbance>& found, const Campaign& campaign,
                                           std::size_t records) {
  std::vector<std::string> lines;
  for (const Disturbance* worst : worst_of_kinds(found))
    lines.push_back(fmt::format("{}: in {} of {} records, worst {}{} ({:.2g} %): {}", worst->kind,
                                records_with(found, worst->kind), records, campaign.records[worst->record].file,
                                worst->channel ? ", " + campaign.channels[*worst->channel].name : "",
                                100 * worst->share, worst->text));
  return lines;
}

}  // namespace secular

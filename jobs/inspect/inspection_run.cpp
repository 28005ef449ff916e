#include "jobs/inspect/inspection_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <nlohmann/json.hpp>
#include <system_error>
#include <utility>

#include "input/input_error.hpp"
#include "jobs/inspect/inspection_report.hpp"
#include "jobs/inspect/table_summary.hpp"
#include "jobs/shared/disturbance_output.hpp"
#include "jobs/shared/json_numbers.hpp"
#include "jobs/shared/record_selection.hpp"
#include "measure/data/file_pattern.hpp"
#include "measure/disturbances/catalogue.hpp"
#include "measure/formats/data_file.hpp"

namespace secular {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

InspectionLimit limit_of(const InspectionRequest& request) {
  InspectionLimit limit;
  limit.span = span_of(request.window);
  if (request.whole) limit.whole_bytes = std::numeric_limits<std::size_t>::max();
  return limit;
}

InspectedCampaign inspected_campaign(const fs::path& folder, Campaign campaign, const InspectionRequest& request) {
  const Window& window = request.window;
  const InspectionLimit limit = limit_of(request);
  InspectedCampaign result{std::move(campaign), {}, {}, {}};
  require_match(result.campaign, window);
  std::erase_if(result.campaign.records,
                [&](const RecordEntry& entry) { return !matches_record(window.records, entry.file); });
  result.records = inspect_records(result.campaign, limit, [&](std::size_t index, const Record& record) {
    const std::vector<Disturbance> found = find_disturbances(result.campaign, index, record);
    result.disturbances.insert(result.disturbances.end(), found.begin(), found.end());
    if (request.pictures) result.pictures.push_back(record_pictures(result.campaign, index, record, found));
  });
  const bool none = std::none_of(result.records.begin(), result.records.end(),
                                 [](const RecordInspection& record) { return record.judged > 0 || !record.axis; });
  if (none && !limit.span.all())
    throw InputError((folder / "campaign.toml").string(), "", "no record has a sample between --from and --to",
                     "secular inspect without them says from when to when records go");
  return result;
}

InspectedFile inspected_file(const fs::path& path, const InspectionRequest& request) {
  InspectedFile result;
  result.file = inspect_file(path, limit_of(request), [&](const Campaign& campaign, const Record& record) {
    result.campaign = campaign;
    result.disturbances = find_disturbances(campaign, 0, record);
    if (request.pictures) result.pictures.push_back(record_pictures(campaign, 0, record, result.disturbances));
  });
  return result;
}

Json faults_json(const std::vector<DataFault>& faults) {
  Json list = Json::array();
  for (const DataFault& fault : faults) list.push_back({{"kind", fault.kind}, {"text", fault.text}});
  return list;
}

Json quality_json(const ChannelQuality& quality) {
  return {{"samples", quality.samples},
          {"missing", quality.missing},
          {"mean", quality.mean},
          {"rms", quality.rms},
          {"peak", quality.peak},
          {"minimum", quality.minimum},
          {"maximum", quality.maximum},
          {"noise_rms", optional_json(quality.noise)},
          {"resolution", optional_json(quality.resolution)},
          {"faults", faults_json(quality.faults)}};
}

void put_axis(Json& object, const std::optional<TimeAxis>& axis, std::size_t samples) {
  object["start_s"] = axis ? Json(axis->start_s) : Json(nullptr);
  object["sample_rate_hz"] = axis ? Json(axis->sample_rate_hz) : Json(nullptr);
  object["jitter_s"] = axis ? Json(axis->jitter_s) : Json(nullptr);
  object["duration_s"] = axis ? Json(recorded_s(*axis, samples)) : Json(nullptr);
}

Json campaign_json(const std::string& path, const InspectedCampaign& found) {
  const auto& [campaign, records, disturbances, pictures] = found;
  Json root = {{"campaign", path}, {"name", campaign.name}};
  if (campaign.sample_rate_hz > 0) root["sample_rate_hz"] = campaign.sample_rate_hz;
  root["channels"] = Json::array();
  for (const Channel& channel : campaign.channels)
    root["channels"].push_back({{"name", channel.name},
                                {"role", to_string(channel.role)},
                                {"quantity", to_string(channel.quantity)},
                                {"unit", channel.unit},
                                {"frame", channel.frame == Frame::absolute ? "absolute" : "relative"},
                                {"delay_s", channel.delay_s}});
  if (campaign.modal_basis)
    root["modal_basis"] = {{"channels", campaign.modal_basis->channels},
                           {"modes", campaign.modal_basis->modes},
                           {"mass_normalised_shapes", campaign.modal_basis->mass_normalised_shapes}};
  std::size_t faults = 0;
  if (const std::vector<TableSummary> tables = tables_of(campaign); !tables.empty()) {
    root["tables"] = Json::array();
    for (const TableSummary& table : tables) {
      root["tables"].push_back({{"file", table.file},
                                {"rows", table.rows},
                                {"lowest_hz", table.lowest_hz},
                                {"highest_hz", table.highest_hz},
                                {"lowest_level", table.lowest_level},
                                {"highest_level", table.highest_level},
                                {"lines", table.lines},
                                {"without_sd", table.without_sd},
                                {"repeated_rows", table.repeats},
                                {"faults", table.faults}});
      faults += table.faults.size();
    }
  }
  root["records"] = Json::array();
  for (std::size_t r = 0; r < records.size(); ++r) {
    const RecordEntry& entry = campaign.records[r];
    if (entry.row) continue;
    Json record = {{"file", entry.file}, {"kind", to_string(entry.kind)}, {"samples", records[r].samples}};
    if (records[r].judged < records[r].samples) record["judged_samples"] = records[r].judged;
    if (records[r].estimated) record["samples_estimated"] = true;
    put_axis(record, records[r].axis, records[r].samples);
    if (entry.excitation_frequency_hz) record["excitation_frequency_hz"] = *entry.excitation_frequency_hz;
    if (entry.excitation_amplitude) record["excitation_amplitude"] = *entry.excitation_amplitude;
    if (!entry.group.empty()) record["group"] = entry.group;
    record["usable"] = record_obstacle(found, r).empty();
    record["faults"] = faults_json(records[r].faults);
    faults += records[r].faults.size();
    record["channels"] = Json::array();
    for (std::size_t c = 0; c < records[r].channels.size(); ++c) {
      Json levels = {{"name", campaign.channels[c].name}, {"unit", campaign.channels[c].unit}};
      levels.update(quality_json(records[r].channels[c]));
      faults += records[r].channels[c].faults.size();
      record["channels"].push_back(std::move(levels));
    }
    root["records"].push_back(std::move(record));
  }
  root["faults_found"] = faults;
  root["disturbances"] = disturbances_json(disturbances, campaign);
  return root;
}

Json file_json(const std::string& path, const InspectedFile& found) {
  const auto& [file, campaign, disturbances, pictures] = found;
  Json root = {{"file", path}, {"format", file.format}, {"segments", file.segments}};
  if (file.partial) root["judged"] = "the first samples";
  if (file.estimated) root["lengths_estimated"] = true;
  std::size_t faults = file.faults.size();
  if (!file.time.empty()) {
    root["time"] = {{"variable", file.time}};
    std::size_t samples = 1;
    for (const VariableInspection& variable : file.variables)
      if (variable.name == file.time)
        for (const std::size_t length : variable.shape) samples *= length;
    put_axis(root["time"], file.axis, samples);
  }
  root["faults"] = faults_json(file.faults);
  root["variables"] = Json::array();
  for (const VariableInspection& variable : file.variables) {
    Json entry = {{"name", variable.name}, {"shape", variable.shape}, {"type", variable.type}};
    if (!variable.unit.empty()) entry["unit"] = variable.unit;
    if (!variable.stated_unit.empty()) entry["stated_unit"] = variable.stated_unit;
    if (!variable.fault.empty()) entry["fault"] = variable.fault;
    if (variable.quality) {
      entry.update(quality_json(*variable.quality));
      faults += variable.quality->faults.size();
    }
    root["variables"].push_back(std::move(entry));
  }
  root["faults_found"] = faults;
  root["disturbances"] = disturbances_json(disturbances, campaign);
  return root;
}

}  // namespace

double recorded_s(const TimeAxis& axis, std::size_t samples) {
  return static_cast<double>(samples) / axis.sample_rate_hz;
}

fs::path campaign_or_file(const std::string& path) {
  const fs::path given = path;
  if (given.filename() != "campaign.toml") return given;
  return given.has_parent_path() ? given.parent_path() : ".";
}

Inspection inspect(const InspectionRequest& request) {
  Inspection found;
  if (request.campaign) {
    found.path = request.path;
    found.campaign = inspected_campaign(request.path, *request.campaign, request);
    return found;
  }
  const fs::path path = campaign_or_file(request.path);
  std::error_code ignored;
  if (!fs::exists(path, ignored))
    throw InputError(request.path, "", "does not exist",
                     fmt::format("a campaign folder or a {} file was expected", data_formats));
  found.path = path.string();
  if (fs::is_directory(path, ignored)) {
    found.campaign = inspected_campaign(path, read_campaign(path), request);
  } else {
    require_any_record(request.path, request.window);
    found.file = inspected_file(path, request);
  }
  return found;
}

std::string inspection_json(const Inspection& found) {
  const Json root =
      found.campaign ? campaign_json(found.path, *found.campaign) : file_json(found.path, *found.file);
  return root.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace secular

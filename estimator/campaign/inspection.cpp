#include "estimator/campaign/inspection.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "estimator/campaign/data_file.hpp"
#include "estimator/campaign/record_data.hpp"
#include "input/input_error.hpp"

namespace secular {
namespace {

std::string without_file(const InputError& error) {
  std::string text = error.place();
  text += (text.empty() ? "" : ": ") + error.wrong();
  return text + (error.right().empty() ? "" : "; " + error.right());
}

// The time axis, or a fault that says why there is none.
std::optional<TimeAxis> judged_axis(const std::vector<double>& stamps, const RowPlace& place,
                                    std::optional<double> expected_rate, std::vector<DataFault>& faults) {
  const auto missing = std::find_if(stamps.begin(), stamps.end(), [](double t) { return !std::isfinite(t); });
  if (missing != stamps.end()) {
    faults.push_back({"time", fmt::format("{}: the time stamp is missing or not finite",
                                          place.of(static_cast<std::size_t>(missing - stamps.begin())))});
    return std::nullopt;
  }
  try {
    return even_time_axis(stamps, "", place, expected_rate);
  } catch (const InputError& error) {
    faults.push_back({"time", without_file(error)});
    return std::nullopt;
  }
}

std::string lower(std::string text) {
  for (char& c : text)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return text;
}

// "HIdata.time" -> "time".
std::string last_part(const std::string& path) {
  return path.substr(path.rfind('.') + 1);
}

RecordInspection inspect_record(const Campaign& campaign, const RecordEntry& entry) {
  RecordInspection inspection;
  try {
    const RecordData data = read_record_data(campaign, entry, MissingNumbers::keep_as_nan);
    inspection.samples = data.stamps_s.size();
    inspection.axis = judged_axis(data.stamps_s, data.place, campaign.sample_rate_hz, inspection.faults);
    if (inspection.axis && !(std::abs(inspection.axis->sample_rate_hz / campaign.sample_rate_hz - 1) <= 1e-3))
      inspection.faults.push_back({"time", fmt::format("is sampled at {:.6g} Hz; campaign.toml says {}",
                                                       inspection.axis->sample_rate_hz, campaign.sample_rate_hz)});
    for (const std::vector<double>& samples : data.channels) inspection.channels.push_back(check_channel(samples));
  } catch (const InputError& error) {
    inspection.faults.push_back({"unreadable", without_file(error)});
  }
  return inspection;
}

}  // namespace

std::vector<RecordInspection> inspect_records(const Campaign& campaign) {
  std::vector<RecordInspection> inspections;
  for (const RecordEntry& entry : campaign.records) inspections.push_back(inspect_record(campaign, entry));
  return inspections;
}

FileInspection inspect_file(const std::filesystem::path& path) {
  const DataFile data = read_data_file(path, {}, MissingNumbers::keep_as_nan);
  FileInspection inspection;
  inspection.format = data.format;
  for (const DataVariable& variable : data.variables) {
    inspection.variables.push_back({variable.name, variable.shape, variable.type, variable.unit,
                                    variable.stated_unit, variable.fault, std::nullopt});
    if (!variable.fault.empty()) continue;
    const std::string name = lower(last_part(variable.name));
    if (inspection.time.empty() && (name == "t" || name == "time") && variable.values.size() > 1) {
      inspection.time = variable.name;
      inspection.axis = judged_axis(variable.values, data.place, std::nullopt, inspection.faults);
    }
    inspection.variables.back().quality = check_channel(variable.values);
    if (variable.name == inspection.time) {  // neither an offset nor a ramp is a fault of time
      inspection.variables.back().quality->faults.clear();
      inspection.variables.back().quality->noise.reset();
      inspection.variables.back().quality->resolution.reset();
    }
  }
  return inspection;
}

}  // namespace secular

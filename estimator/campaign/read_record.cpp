#include <fmt/format.h>

#include <cmath>

#include "estimator/campaign/campaign.hpp"
#include "estimator/campaign/data_file.hpp"
#include "estimator/campaign/record_data.hpp"
#include "estimator/campaign/time_axis.hpp"
#include "input/input_error.hpp"

namespace secular {

RecordData read_record_data(const Campaign& campaign, const RecordEntry& entry, MissingNumbers missing) {
  const auto variable_of = [&](const std::string& channel) {
    const auto renamed = entry.variables.find(channel);
    return renamed == entry.variables.end() ? channel : renamed->second;
  };
  std::vector<std::string> wanted = {variable_of("t")};
  for (const Channel& channel : campaign.channels) wanted.push_back(variable_of(channel.name));
  const DataFile data = read_data_file(campaign.folder / entry.file, wanted, missing);
  RecordData record{data.file, data.place, data.vector(wanted.front()).values, {}};
  for (std::size_t c = 0; c < campaign.channels.size(); ++c) {
    const DataVariable& variable = data.vector(wanted[c + 1]);
    const Quantity quantity = campaign.channels[c].quantity;
    if (const std::string fault = quantity_fault(variable, quantity); !fault.empty())
      throw InputError(data.file, "variable " + variable.name, fault,
                       fmt::format("campaign.toml says {}", to_string(quantity)));
    record.channels.push_back(variable.values);
    if (record.channels.back().size() != record.stamps_s.size())
      throw InputError(
          data.file, "channel " + campaign.channels[c].name,
          fmt::format("has {} samples for {} time stamps", record.channels.back().size(), record.stamps_s.size()),
          "all variables of a record have one length");
  }
  return record;
}

Record read_record(const Campaign& campaign, const RecordEntry& entry) {
  RecordData data = read_record_data(campaign, entry, MissingNumbers::refuse);
  const TimeAxis axis = even_time_axis(data.stamps_s, data.file, data.place, campaign.sample_rate_hz);
  if (!(std::abs(axis.sample_rate_hz / campaign.sample_rate_hz - 1) <= 1e-3))
    throw InputError(data.file, "", fmt::format("is sampled at {} Hz", axis.sample_rate_hz),
                     fmt::format("campaign.toml says sample_rate_hz = {}", campaign.sample_rate_hz));
  return {axis.start_s, axis.sample_rate_hz, std::move(data.channels)};
}

}  // namespace secular

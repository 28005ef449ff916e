#include "measure/data/table_entries.hpp"

#include <fmt/format.h>

#include <utility>

#include "input/input_error.hpp"
#include "measure/data/line_table.hpp"

namespace secular {
namespace {

TableConvention convention_in(const TomlTable& table, const RecordEntry& entry) {
  const auto said = [&](const char* key) {
    if (table.has(key) && table.string(key).empty()) table.fail(key, "is ''", "a word, or no such line");
    return table.string_or(key, "");
  };
  const ConventionWords words{said("amplitudes"),
                              said("phases"),
                              said("phase_sign"),
                              said("frequency_unit"),
                              table.optional_number("phase_offset_deg").value_or(0),
                              table.boolean_or("per_excitation", false)};
  TableConvention convention = convention_of(
      words, [&](const std::string& word, const std::string& is, const std::string&, const std::string& expected) {
        table.fail(word.c_str(), "is '" + is + "'", expected);
      });
  convention.level = entry.excitation_amplitude;
  return convention;
}

}  // namespace

std::vector<RecordEntry> table_entries(const TomlTable& table, const Campaign& campaign, const RecordEntry& entry) {
  TableRequest request;
  for (const Channel& channel : campaign.channels) {
    const auto renamed = entry.variables.find(channel.name);
    request.channels.push_back({channel.name, channel.role,
                                renamed == entry.variables.end() ? channel.name : renamed->second,
                                channel.quantity});
  }
  for (const auto& [part, variable] : entry.variables) {
    const bool channel = std::any_of(campaign.channels.begin(), campaign.channels.end(),
                                     [&, &part = part](const Channel& c) { return c.name == part; });
    if (!channel) request.columns.emplace(part, variable);
  }
  request.convention = convention_in(table, entry);
  request.words = {"write phases = \"deg\" or \"rad\" in its [[record]] of campaign.toml",
                   "name it in its [[record]] of campaign.toml: variables = {{ \"{}\" = \"...\" }}",
                   "write excitation_amplitude = LEVEL in its [[record]] of campaign.toml",
                   std::string("write frequency_unit = \"Hz\" (") + frequency_unit_list +
                       ") in its [[record]] of campaign.toml"};
  const LineTable lines = read_line_table(campaign.folder / entry.file, request);
  if (!lines.damaged.empty())
    throw InputError((campaign.folder / entry.file).string(), "", lines.damaged.front(),
                     "take the row out, or let `secular import` make the campaign, which leaves such rows out");
  std::size_t excitation = 0;
  for (std::size_t c = 0; c < campaign.channels.size(); ++c)
    if (campaign.channels[c].role == ChannelRole::excitation) excitation = c;
  std::vector<RecordEntry> rows;
  for (LineRow row : lines.rows) {
    row.table = entry.file;
    RecordEntry& record = rows.emplace_back(entry);
    record.file = row_name(entry.file, row.place);
    record.variables.clear();
    record.excitation_frequency_hz = row.frequency_hz;
    if (const TableLine* level = row.find(excitation, {})) record.excitation_amplitude = std::abs(level->amplitude);
    record.row = std::make_shared<const LineRow>(std::move(row));
  }
  return rows;
}

std::string row_name(const std::string& table, const std::string& place) {
  return table + ":" + place.substr(place.rfind(' ') + 1);
}

}  // namespace secular

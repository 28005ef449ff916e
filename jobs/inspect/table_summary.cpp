#include "jobs/inspect/table_summary.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "measure/data/frequency_names.hpp"
#include "measure/data/line_names.hpp"
#include "measure/formats/number_table.hpp"
#include "measure/formats/uff_frf.hpp"

namespace secular {
namespace {

void add_row(const Campaign& campaign, const LineRow& row, TableSummary& table) {
  const std::vector<std::size_t> excitation = channels_of(campaign, ChannelRole::excitation);
  double level = 0;
  for (const TableLine& line : row.lines) {
    const std::string name = campaign.channels[line.channel].name + line_suffix(line.number);
    if (std::find(table.lines.begin(), table.lines.end(), name) == table.lines.end()) table.lines.push_back(name);
    const bool drives = line.channel == excitation.front();
    if (drives && line.number == LineNumber{}) level = std::abs(line.amplitude);
    if (line.sd || drives) continue;
    if (std::find(table.without_sd.begin(), table.without_sd.end(), name) == table.without_sd.end())
      table.without_sd.push_back(name);
  }
  if (table.rows == 0) {
    table.lowest_hz = table.highest_hz = row.frequency_hz;
    table.lowest_level = table.highest_level = level;
  }
  table.lowest_hz = std::min(table.lowest_hz, row.frequency_hz);
  table.highest_hz = std::max(table.highest_hz, row.frequency_hz);
  table.lowest_level = std::min(table.lowest_level, level);
  table.highest_level = std::max(table.highest_level, level);
  ++table.rows;
}

std::vector<double> numbers_of(const LineRow& row) {
  std::vector<double> numbers = {row.frequency_hz};
  for (const TableLine& line : row.lines) {
    numbers.push_back(line.amplitude.real());
    numbers.push_back(line.amplitude.imag());
  }
  return numbers;
}

// "run(2).freq", "Frequency [Hz]", "omega": may hold the frequencies of a table.
bool may_be_frequency(const std::string& variable) {
  std::string name = bracketed_unit(variable).name;
  name = name.substr(name.rfind('.') + 1);
  return is_frequency_name(name) || name == "omega" || name == "Omega";
}

}  // namespace

std::vector<TableSummary> tables_of(const Campaign& campaign) {
  std::vector<TableSummary> tables;
  std::map<std::string, std::size_t> places;
  std::map<std::string, std::map<std::vector<double>, std::string>> seen;
  std::map<std::string, std::set<long long>> labels;
  for (const RecordEntry& entry : campaign.records) {
    if (!entry.row) continue;
    const LineRow& row = *entry.row;
    const auto [at, is_new] = places.try_emplace(row.table, tables.size());
    if (is_new) tables.push_back({row.table, 0, 0, 0, 0, 0, 0, {}, {}, {}});
    TableSummary& table = tables[at->second];
    add_row(campaign, row, table);
    if (row.condition && !labels[row.table].insert(*row.condition).second) ++table.repeats;
    const auto [first, fresh] = seen[row.table].try_emplace(numbers_of(row), row.place);
    if (!fresh) table.faults.push_back(fmt::format("{} is {} once more", row.place, first->second));
  }
  return tables;
}

std::string table_import(const std::filesystem::path& path, const FileInspection& file) {
  std::string frequency, channels;
  bool responses = false;
  for (const VariableInspection& variable : file.variables) {
    if (frequency.empty() && may_be_frequency(variable.name)) frequency = variable.name;
    if (variable.name.ends_with(".re") && variable.type.starts_with(frequency_response)) {
      channels += fmt::format(" --channel {}:response{}", variable.name.substr(0, variable.name.size() - 3),
                              variable.unit.empty() ? ":QUANTITY:UNIT" : "");
      responses = true;
    }
  }
  if (frequency.empty()) return {};
  const bool usual = is_frequency_name(bracketed_unit(frequency).name);
  return fmt::format(
      "secular import {} -o CAMPAIGN --kind lines{} --channel NAME:excitation:QUANTITY:UNIT{}{}", path.string(),
      usual ? "" : fmt::format(" --column 'f={}'", frequency), responses ? " --level LEVEL" : "",
      responses ? channels : " --channel NAME:response:QUANTITY:UNIT --column NAME.phase=VARIABLE --phases deg");
}

}  // namespace secular

#include "jobs/inspect/table_summary.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "measure/data/line_names.hpp"

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

}  // namespace secular

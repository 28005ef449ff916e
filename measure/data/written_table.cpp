#include "measure/data/written_table.hpp"

#include <algorithm>
#include <limits>
#include <set>
#include <utility>

#include "measure/data/line_names.hpp"

namespace secular {

WrittenTable written_table(const std::vector<LineRow>& rows, const std::vector<Channel>& channels) {
  WrittenTable table;
  const auto column = [&](const std::string& name, const auto& value) {
    table.names.push_back(name);
    std::vector<double>& values = table.columns.emplace_back();
    for (const LineRow& row : rows) values.push_back(value(row));
  };
  const double none = std::numeric_limits<double>::quiet_NaN();
  column("f", [](const LineRow& row) { return row.frequency_hz; });
  if (std::any_of(rows.begin(), rows.end(), [](const LineRow& row) { return row.condition.has_value(); }))
    column("condition",
           [none](const LineRow& row) { return row.condition ? static_cast<double>(*row.condition) : none; });
  std::set<std::pair<std::size_t, LineNumber>> lines;
  std::set<std::pair<std::size_t, LineNumber>> with_sd;
  for (const LineRow& row : rows)
    for (const TableLine& line : row.lines) {
      lines.emplace(line.channel, line.number);
      if (line.sd) with_sd.emplace(line.channel, line.number);
    }
  for (const auto& key : lines) {
    const auto& [channel, number] = key;
    const std::string name = channels[channel].name + line_suffix(number);
    const auto put = [&, channel = channel, number = number](const char* part, const auto& of) {
      column(name + part, [&, none](const LineRow& row) {
        const TableLine* line = row.find(channel, number);
        return line ? of(*line) : none;
      });
    };
    if (number.is_mean()) {
      put("", [](const TableLine& line) { return line.amplitude.real(); });
    } else {
      put(".re", [](const TableLine& line) { return line.amplitude.real(); });
      put(".im", [](const TableLine& line) { return line.amplitude.imag(); });
    }
    if (with_sd.count(key) > 0) put(".sd", [none](const TableLine& line) { return line.sd.value_or(none); });
  }
  return table;
}

}  // namespace secular

#include "measure/data/import_tables.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>
#include <utility>

#include "input/input_error.hpp"
#include "measure/data/import_channels.hpp"
#include "measure/data/import_parts.hpp"
#include "measure/data/line_table.hpp"
#include "measure/data/names.hpp"
#include "measure/data/numbered_options.hpp"
#include "measure/formats/number_table.hpp"

namespace secular {
namespace {

/// Damaged rows that a warning lists.
constexpr std::size_t most_listed_rows = 4;

TableConvention convention_in(const TableOptions& options) {
  if (!std::isfinite(options.phase_offset_deg.value_or(0)))
    throw InputError("--phase-offset", "", "is not finite", "degrees were expected");
  return convention_of(
      {options.amplitudes, options.phases, options.phase_sign, options.frequency_unit,
       options.phase_offset_deg.value_or(0), options.per_excitation},
      [](std::string word, const std::string& is, const std::string& wrong, const std::string& expected) {
        std::replace(word.begin(), word.end(), '_', '-');
        throw InputError("--" + word + " " + is, "", wrong, expected);
      });
}

std::map<std::string, std::string> columns_given(const std::vector<std::string>& options) {
  std::map<std::string, std::string> columns;
  for (const std::string& text : options) {
    const std::size_t equals = text.find('=');
    if (equals == std::string::npos || equals == 0 || equals + 1 == text.size())
      throw InputError("--column " + text, "", "is not PART=VARIABLE", "for example --column tip.phase=ph1");
    if (!columns.emplace(text.substr(0, equals), text.substr(equals + 1)).second)
      throw InputError("--column " + text, "", "names a part twice", "every part once");
  }
  return columns;
}

// Complex variables under their own name, and excitations that the file has no column of: what --channel may name.
Variables with_described(Variables variables, const ImportOptions& options) {
  const Variables stored = variables;
  const auto add = [&](const std::string& name, const DataVariable* like) {
    if (name.empty() || find_variable(variables, name)) return;
    DataVariable variable = like ? *like : DataVariable{};
    variable.name = name;
    variables.push_back(std::move(variable));
  };
  for (const DataVariable& variable : stored) {
    const CsvName bare = bracketed_unit(variable.name);
    if (!bare.unit.empty()) add(bare.name, &variable);
    for (const char* const part : {".re", "_re", " re"})
      if (bare.name.ends_with(part)) add(bare.name.substr(0, bare.name.size() - 3), &variable);
  }
  for (const auto& [part, variable] : columns_given(options.table.columns))
    if (part.find_first_of(".@") == std::string::npos && part != "f" && part != "condition")
      add(part, find_variable(stored, variable));
  for (const std::string& text : options.channels)
    if (const std::size_t role = text.find(":excitation"); role != std::string::npos)
      if (const std::string name = text.substr(0, role); name.find('=') == std::string::npos) add(name, nullptr);
  return variables;
}

void check_options(const ImportOptions& options) {
  if (options.files.empty()) throw InputError("FILE", "", "no file is named", "name the files to import");
  if (!options.time.empty() || options.sample_rate_hz || options.ensemble_s || !options.frequencies_hz.empty())
    throw InputError(
        "--time, --sample-rate, --ensemble, --frequency", "", "say something of samples",
        "a table of lines has none: leave them out; its frequencies are a column (--column f=VARIABLE)");
  if (!options.geometry.empty())
    throw InputError("--geometry", "", "is for `secular modal`, which reads no tables", "leave it out");
}

}  // namespace

ImportedCampaign import_tables(const ImportOptions& options, const TableSink& sink) {
  check_options(options);
  TableRequest request;
  request.convention = convention_in(options.table);
  request.words = {"write --phases deg or --phases rad", "name it with --column {}=VARIABLE",
                   "write --level LEVEL, in the unit of its channel: one for all files or one for each",
                   std::string("write --frequency-unit with ") + frequency_unit_list};
  ImportedCampaign imported;
  Campaign& campaign = imported.campaign;
  campaign.name = options.name.empty() ? options.files.front().stem().string() : options.name;
  std::set<std::string> taken, used, unused, without_sd;
  for (std::size_t f = 0; f < options.files.size(); ++f) {
    const std::filesystem::path& path = options.files[f];
    const Variables variables = describe_data_file(path);
    for (const std::string& number : numbers_in(options, variables, path.string())) {
      ImportOptions own = numbered(options, number);
      own.files = {path};
      const std::vector<DescribedChannel> channels = describe_channels(own, with_described(variables, own));
      if (campaign.channels.empty())
        for (const DescribedChannel& described : channels) campaign.channels.push_back(described.channel);
      request.channels.clear();
      double excitation_factor = 1;
      for (std::size_t c = 0; c < channels.size(); ++c) {
        const Channel &channel = channels[c].channel, &first = campaign.channels[c];
        if (channel.quantity != first.quantity)
          throw InputError(path.string(), "channel " + channel.name, "measures " + to_string(channel.quantity),
                           "the first file says " + to_string(first.quantity));
        request.channels.push_back(
            {channel.name, channel.role, channels[c].variable, channel.quantity, channels[c].si_factor});
        if (channel.role == ChannelRole::excitation) excitation_factor = channels[c].si_factor;
        if (f == 0 && number.size() < 2 && (number.empty() || number == "1") && !channels[c].given_unit.empty())
          imported.converted.push_back({channel.name, channels[c].given_unit, channel.unit});
      }
      request.columns = columns_given(own.table.columns);
      const auto level = of_file(options.amplitudes, f, options.files.size(), "--level");
      request.convention.level = level ? std::optional(std::abs(excitation_factor) * *level) : std::nullopt;
      LineTable table = read_line_table(path, request);
      for (const DataVariable& variable : variables) {
        const bool left = std::find(table.unused.begin(), table.unused.end(), variable.name) != table.unused.end();
        if (left)
          unused.insert(variable.name);
        else
          used.insert(variable.name);
      }
      if (!table.damaged.empty()) {
        std::string list;
        for (std::size_t i = 0; i < std::min(most_listed_rows, table.damaged.size()); ++i)
          list += (i ? "; " : "") + table.damaged[i];
        imported.warnings.push_back(fmt::format("{}: {} of {} rows left out: {}{}", path.string(),
                                                table.damaged.size(), table.damaged.size() + table.rows.size(),
                                                list, table.damaged.size() > most_listed_rows ? "; ..." : ""));
      }
      for (const LineRow& row : table.rows)
        for (const TableLine& line : row.lines)
          if (!line.sd && line.number == LineNumber{} &&
              campaign.channels[line.channel].role == ChannelRole::response)
            without_sd.insert(campaign.channels[line.channel].name);
      RecordEntry entry;
      std::filesystem::path source = path;
      if (!number.empty()) source.replace_filename(path.stem().string() + "-" + number + ".csv");
      entry.file = record_file(source, taken);
      entry.kind = RecordKind::lines;
      entry.group = options.group;
      sink(campaign, entry, table.rows);
      campaign.records.push_back(std::move(entry));
    }
  }
  std::set_difference(unused.begin(), unused.end(), used.begin(), used.end(),
                      std::back_inserter(imported.left_out));
  if (!without_sd.empty())
    imported.warnings.push_back(fmt::format(
        "rows do not say the standard deviation of {}: noise is what a model leaves of them, or what rows with one "
        "label in a column condition scatter by; where it is known, add a column CHANNEL.sd",
        fmt::join(without_sd, ", ")));
  return imported;
}

}  // namespace secular

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/App.hpp>
#include <algorithm>
#include <initializer_list>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/shared/command_line.hpp"
#include "app/shared/commands.hpp"
#include "app/shared/notices.hpp"
#include "app/shared/output_target.hpp"
#include "app/shared/selection_options.hpp"
#include "jobs/inspect/inspection_report.hpp"
#include "jobs/inspect/inspection_run.hpp"
#include "jobs/inspect/proposed_import.hpp"
#include "jobs/inspect/table_summary.hpp"

namespace secular::app {
namespace {

// Rows of cells, the first of them the heading; columns from `first_number` on are aligned to the right.
std::string aligned(const std::vector<std::vector<std::string>>& rows, std::size_t first_number) {
  std::vector<std::size_t> widths;
  for (const auto& row : rows) {
    widths.resize(std::max(widths.size(), row.size()));
    for (std::size_t c = 0; c < row.size(); ++c) widths[c] = std::max(widths[c], row[c].size());
  }
  std::string text;
  for (const auto& row : rows) {
    std::string line = " ";
    for (std::size_t c = 0; c < row.size(); ++c)
      line +=
          c < first_number ? fmt::format(" {:<{}}", row[c], widths[c]) : fmt::format("  {:>{}}", row[c], widths[c]);
    line.erase(line.find_last_not_of(' ') + 1);
    text += visible(line) + "\n";
  }
  return text;
}

std::string number(double value) {
  return fmt::format("{:.5g}", value);
}

std::string number(const std::optional<double>& value) {
  return value ? fmt::format("{:.3g}", *value) : "-";
}

std::string count(std::size_t n, const char* noun) {
  return fmt::format("{} {}{}", n, noun, n == 1 ? "" : "s");
}

const std::vector<std::string> level_headings = {"mean", "rms", "peak", "noise", "resolution"};

void append_levels(std::vector<std::string>& row, const ChannelQuality& quality) {
  for (const double level : {quality.mean, quality.rms, quality.peak}) row.push_back(number(level));
  row.push_back(number(quality.noise));
  row.push_back(number(quality.resolution));
}

constexpr const char* partial_note =
    " judged by their first samples only, for their size; --whole reads everything.";

constexpr const char* level_note =
    "rms: about the mean. noise: rms of the white noise that the upper half of the spectrum would allow.\n";

void print_faults(const std::vector<std::string>& faults) {
  if (faults.empty()) {
    fmt::print("\nno faults found\n");
    return;
  }
  fmt::print("\n{} found\n", count(faults.size(), "fault"));
  for (const std::string& fault : faults) fmt::print("  {}\n", visible(fault));
}

void print_channels(const Campaign& campaign) {
  std::vector<std::vector<std::string>> rows = {{"name", "role", "quantity", "unit"}};
  for (const Channel& channel : campaign.channels)
    rows.push_back({channel.name, to_string(channel.role), to_string(channel.quantity),
                    channel.unit + (channel.frame == Frame::absolute ? ", absolute" : "") +
                        (channel.delay_s != 0 ? fmt::format(", {:g} s late", channel.delay_s) : "")});
  fmt::print("\n{}\n{}", count(campaign.channels.size(), "channel"), aligned(rows, rows.front().size()));
  if (campaign.modal_basis)
    fmt::print("modal basis: {} from {}\n", fmt::join(campaign.modal_basis->modes, ", "),
               fmt::join(campaign.modal_basis->channels, ", "));
}

void print_tables(const Campaign& campaign) {
  const std::vector<TableSummary> tables = tables_of(campaign);
  if (tables.empty()) return;
  std::vector<std::vector<std::string>> rows = {
      {"file", "lines", "without sd", "rows", "repeats", "from (Hz)", "to (Hz)", "level from", "to"}};
  for (const TableSummary& table : tables)
    rows.push_back({table.file, fmt::format("{}", fmt::join(table.lines, " ")),
                    table.without_sd.empty() ? "-" : fmt::format("{}", fmt::join(table.without_sd, " ")),
                    std::to_string(table.rows), std::to_string(table.repeats), number(table.lowest_hz),
                    number(table.highest_hz), number(table.lowest_level), number(table.highest_level)});
  fmt::print("\n{} of lines\n{}", count(tables.size(), "table"), aligned(rows, 3));
}

void print_records(const Campaign& campaign, const std::vector<RecordInspection>& records) {
  std::vector<std::vector<std::string>> rows = {
      {"file", "kind", "group", "samples", "start (s)", "duration (s)", "frequency (Hz)", "amplitude"}};
  double total = 0;
  for (std::size_t r = 0; r < records.size(); ++r) {
    const RecordEntry& entry = campaign.records[r];
    if (entry.row) continue;
    const std::optional<TimeAxis>& axis = records[r].axis;
    if (axis) total += recorded_s(*axis, records[r].samples);
    const auto given = [](const std::optional<double>& value) { return value ? number(*value) : "-"; };
    rows.push_back({entry.file, to_string(entry.kind), entry.group.empty() ? "-" : entry.group,
                    (records[r].estimated ? "about " : "") + std::to_string(records[r].samples),
                    axis ? number(axis->start_s) : "-", axis ? number(recorded_s(*axis, records[r].samples)) : "-",
                    given(entry.excitation_frequency_hz), given(entry.excitation_amplitude)});
  }
  if (rows.size() > 1)
    fmt::print("\n{}, {:.6g} s in all\n{}", count(rows.size() - 1, "record"), total, aligned(rows, 3));
}

void print_levels(const Campaign& campaign, const std::vector<RecordInspection>& records) {
  std::vector<std::vector<std::string>> rows = {{"record", "channel", "unit"}};
  rows.front().insert(rows.front().end(), level_headings.begin(), level_headings.end());
  for (std::size_t r = 0; r < records.size(); ++r)
    for (std::size_t c = 0; c < records[r].channels.size(); ++c) {
      rows.push_back({campaign.records[r].file, campaign.channels[c].name, campaign.channels[c].unit});
      append_levels(rows.back(), records[r].channels[c]);
    }
  if (rows.size() > 1) fmt::print("\nlevels\n{}{}", aligned(rows, 3), level_note);
}

void print_campaign(const std::string& folder, const InspectedCampaign& found) {
  const auto& [campaign, records, disturbances, pictures] = found;
  fmt::print("campaign '{}' in {}\n", visible(campaign.name), folder);
  fmt::print("{}\n", visible(usable_sentence(found)));
  if (campaign.sample_rate_hz > 0) fmt::print("sample rate {} Hz\n", campaign.sample_rate_hz);
  print_channels(campaign);
  print_tables(campaign);
  print_records(campaign, records);
  print_levels(campaign, records);
  const auto partly = std::count_if(records.begin(), records.end(),
                                    [](const RecordInspection& record) { return record.judged < record.samples; });
  if (partly > 0) fmt::print("{} of {} records{}\n", partly, records.size(), partial_note);
  std::vector<std::string> faults;
  for (std::size_t r = 0; r < records.size(); ++r) {
    for (const DataFault& fault : records[r].faults)
      faults.push_back(fmt::format("{}: {}: {}", campaign.records[r].file, fault.kind, fault.text));
    for (std::size_t c = 0; c < records[r].channels.size(); ++c)
      for (const DataFault& fault : records[r].channels[c].faults)
        faults.push_back(fmt::format("{}, {}: {}: {}", campaign.records[r].file, campaign.channels[c].name,
                                     fault.kind, fault.text));
  }
  for (const TableSummary& table : tables_of(campaign))
    for (const std::string& fault : table.faults) faults.push_back(table.file + ": " + fault);
  print_faults(faults);
  print_disturbances(disturbances, campaign, records.size());
  const auto any = [&, &all = campaign.records](std::initializer_list<RecordKind> kinds) {
    return std::any_of(all.begin(), all.end(), [&](const RecordEntry& entry) {
      return std::find(kinds.begin(), kinds.end(), entry.kind) != kinds.end();
    });
  };
  fmt::print("\nNext: secular identify {} --model MODEL -o OUT\n", folder);
  if (any({RecordKind::free_decay, RecordKind::impact}))
    fmt::print("      secular modal {} -o OUT (frequencies, damping and shapes, without a model)\n", folder);
}

// "m/s^2", "m/s^2 (from g)", "EU ?" for a unit that is not known.
std::string shown_unit(const VariableInspection& variable) {
  if (variable.unit.empty()) return variable.stated_unit.empty() ? "-" : variable.stated_unit + " ?";
  if (variable.unit == variable.stated_unit) return variable.unit;
  return fmt::format("{} (from {})", variable.unit, variable.stated_unit);
}

void print_file(const std::string& path, const InspectedFile& found) {
  const auto& [file, campaign, disturbances, pictures] = found;
  const std::string table = table_import(path, file);
  fmt::print("{}: {} with {}\n", path, file.format, count(file.variables.size(), "numeric variable"));
  if (file.segments > 1)
    fmt::print("{} segments, each of which `secular import` makes a record: this is the first\n", file.segments);
  if (file.variables.empty()) {
    fmt::print("nothing in it can be imported\n");
    return;
  }
  if (file.axis)
    fmt::print("time in {}, from {:.6g} s at {} Hz\n", file.time, file.axis->start_s, file.axis->sample_rate_hz);
  std::vector<std::vector<std::string>> rows = {{"variable", "shape", "type", "unit"}};
  rows.front().insert(rows.front().end(), level_headings.begin(), level_headings.end());
  std::vector<std::string> faults, unusable;
  for (const DataFault& fault : file.faults)
    faults.push_back(fmt::format("{}: {}: {}", file.time, fault.kind, fault.text));
  for (const VariableInspection& variable : file.variables) {
    rows.push_back(
        {variable.name, fmt::format("{}", fmt::join(variable.shape, " x ")), variable.type, shown_unit(variable)});
    if (!variable.fault.empty()) unusable.push_back(variable.name + " " + variable.fault);
    if (!variable.quality) continue;
    append_levels(rows.back(), *variable.quality);
    for (const DataFault& fault : variable.quality->faults)
      if (fault.kind != "constant" || table.empty() || !file.time.empty())  // a table's level stays the same
        faults.push_back(fmt::format("{}: {}: {}", variable.name, fault.kind, fault.text));
  }
  fmt::print("\n{}{}", aligned(rows, 4), level_note);
  if (file.partial) fmt::print("{}Values are{}\n", file.estimated ? "Lengths are estimated. " : "", partial_note);
  for (const std::string& variable : unusable) fmt::print("no channel: {}\n", visible(variable));
  print_faults(faults);
  print_disturbances(disturbances, campaign, 1);
  if (!table.empty()) {
    fmt::print("\nTo use it as a table of lines: {}\n", visible(table));
    if (file.time.empty()) return;
  }
  if (const std::string command = proposed_import(path, file); !command.empty())
    fmt::print("\nTo use it: {}\n", visible(command));
}

}  // namespace

void add_inspect_command(CLI::App* command, Action& chosen) {
  struct Options {
    InspectionRequest request;
    SelectionOptions selection;
    OutputFolder output{{"inspection.json", "report.html"}};
    bool json = false;
  };
  auto options = std::make_shared<Options>();
  command
      ->add_option("CAMPAIGN_OR_FILE", options->request.path,
                   "campaign folder, or CSV, MAT, HDF5, UFF 58, LVM or WAV file")
      ->required();
  options->selection.add_to(*command, {.band = false});
  options->output.add_to(*command, "folder for report.html and inspection.json (default: none)", false);
  command->add_flag("--whole", options->request.whole, "read everything, also where data are larger than 64 MB");
  command->add_flag("--json", options->json, "the same as JSON");
  command->footer(
      "Faults are for you to judge: offset, clipping, constant or coarse channels, missing samples, uneven time.\n"
      "Of more than 64 MB the first samples of every record are judged, at once; --whole reads all, a record at a "
      "time.\n"
      "Example: secular inspect out/test -o out/inspection");
  command->callback([options, command, &chosen] {
    chosen = [options, command] {
      InspectionRequest& request = options->request;
      request.window = options->selection.window();
      request.pictures = !options->output.path().empty();
      if (request.pictures)
        options->output.check({{"what is inspected", campaign_or_file(request.path).string(), true}});
      const Inspection found = inspect(request);
      const std::string json = inspection_json(found);
      if (request.pictures)
        options->output.write(
            {{"inspection.json", json}, {"report.html", inspection_report(found, command_line_of(*command))}});
      if (options->json)
        fmt::print("{}", json);
      else if (found.campaign)
        print_campaign(found.path, *found.campaign);
      else
        print_file(found.path, *found.file);
      if (request.pictures && !options->json)
        fmt::print("written: {0}/inspection.json, {0}/report.html\n", options->output.path());
      return 0;
    };
  });
}

}  // namespace secular::app

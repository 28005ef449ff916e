#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/App.hpp>
#include <algorithm>
#include <filesystem>
#include <functional>
#include <initializer_list>
#include <limits>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <system_error>
#include <vector>

#include "app/inspect/inspection_report.hpp"
#include "app/inspect/proposed_import.hpp"
#include "app/inspect/table_summary.hpp"
#include "app/shared/command_line.hpp"
#include "app/shared/commands.hpp"
#include "app/shared/notices.hpp"
#include "app/shared/output_target.hpp"
#include "app/shared/selection_options.hpp"
#include "input/input_error.hpp"
#include "jobs/shared/disturbance_output.hpp"
#include "jobs/shared/json_numbers.hpp"
#include "jobs/shared/record_selection.hpp"
#include "measure/data/campaign.hpp"
#include "measure/data/file_pattern.hpp"
#include "measure/data/inspection.hpp"
#include "measure/disturbances/catalogue.hpp"
#include "measure/formats/data_file.hpp"

namespace secular::app {
namespace {

using Json = nlohmann::ordered_json;

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

double duration_s(const TimeAxis& axis, std::size_t samples) {
  return static_cast<double>(samples) / axis.sample_rate_hz;
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
  for (const std::string& fault : faults) fmt::print("  {}\n", fault);
}

void print_channels(const Campaign& campaign) {
  std::vector<std::vector<std::string>> rows = {{"name", "role", "quantity", "unit"}};
  for (const Channel& channel : campaign.channels)
    rows.push_back({channel.name, to_string(channel.role), to_string(channel.quantity),
                    channel.unit + (channel.frame == Frame::absolute ? ", absolute" : "")});
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
    if (axis) total += duration_s(*axis, records[r].samples);
    const auto given = [](const std::optional<double>& value) { return value ? number(*value) : "-"; };
    rows.push_back({entry.file, to_string(entry.kind), entry.group.empty() ? "-" : entry.group,
                    (records[r].estimated ? "about " : "") + std::to_string(records[r].samples),
                    axis ? number(axis->start_s) : "-", axis ? number(duration_s(*axis, records[r].samples)) : "-",
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

// What is made of an inspection.
struct Wanted {
  Window window;
  InspectionLimit limit;
  bool pictures = false;
};

InspectedCampaign inspected(const std::filesystem::path& folder, const Wanted& wanted) {
  const Window& window = wanted.window;
  const InspectionLimit& limit = wanted.limit;
  InspectedCampaign result{read_campaign(folder), {}, {}, {}};
  require_match(result.campaign, window);
  std::erase_if(result.campaign.records,
                [&](const RecordEntry& entry) { return !matches_record(window.records, entry.file); });
  result.records = inspect_records(result.campaign, limit, [&](std::size_t index, const Record& record) {
    const std::vector<Disturbance> found = find_disturbances(result.campaign, index, record);
    result.disturbances.insert(result.disturbances.end(), found.begin(), found.end());
    if (wanted.pictures) result.pictures.push_back(record_pictures(result.campaign, index, record, found));
  });
  const bool none = std::none_of(result.records.begin(), result.records.end(),
                                 [](const RecordInspection& record) { return record.judged > 0 || !record.axis; });
  if (none && !limit.span.all())
    throw InputError((folder / "campaign.toml").string(), "", "no record has a sample between --from and --to",
                     "secular inspect without them says from when to when records go");
  return result;
}

void print_campaign(const std::filesystem::path& folder, const InspectedCampaign& found) {
  const auto& [campaign, records, disturbances, pictures] = found;
  fmt::print("campaign '{}' in {}\n", visible(campaign.name), folder.string());
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
  fmt::print("\nNext: secular identify {} --model MODEL -o OUT\n", folder.string());
  if (any({RecordKind::free_decay, RecordKind::impact}))
    fmt::print("      secular modal {} -o OUT (frequencies, damping and shapes, without a model)\n",
               folder.string());
}

// "m/s^2", "m/s^2 (from g)", "EU ?" for a unit that is not known.
std::string shown_unit(const VariableInspection& variable) {
  if (variable.unit.empty()) return variable.stated_unit.empty() ? "-" : variable.stated_unit + " ?";
  if (variable.unit == variable.stated_unit) return variable.unit;
  return fmt::format("{} (from {})", variable.unit, variable.stated_unit);
}

InspectedFile inspected_file(const std::filesystem::path& path, const Wanted& wanted) {
  InspectedFile result;
  result.file = inspect_file(path, wanted.limit, [&](const Campaign& campaign, const Record& record) {
    result.campaign = campaign;
    result.disturbances = find_disturbances(campaign, 0, record);
    if (wanted.pictures) result.pictures.push_back(record_pictures(campaign, 0, record, result.disturbances));
  });
  return result;
}

void print_file(const std::filesystem::path& path, const InspectedFile& found) {
  const auto& [file, campaign, disturbances, pictures] = found;
  fmt::print("{}: {} with {}\n", path.string(), file.format, count(file.variables.size(), "numeric variable"));
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
      faults.push_back(fmt::format("{}: {}: {}", variable.name, fault.kind, fault.text));
  }
  fmt::print("\n{}{}", aligned(rows, 4), level_note);
  if (file.partial) fmt::print("{}Values are{}\n", file.estimated ? "Lengths are estimated. " : "", partial_note);
  for (const std::string& variable : unusable) fmt::print("no channel: {}\n", variable);
  print_faults(faults);
  print_disturbances(disturbances, campaign, 1);
  if (const std::string table = table_import(path, file); !table.empty()) {
    fmt::print("\nTo use it as a table of lines: {}\n", table);
    if (file.time.empty()) return;
  }
  if (const std::string command = proposed_import(path, file); !command.empty())
    fmt::print("\nTo use it: {}\n", command);
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
  object["duration_s"] = axis ? Json(duration_s(*axis, samples)) : Json(nullptr);
}

Json campaign_json(const std::filesystem::path& folder, const InspectedCampaign& found) {
  const auto& [campaign, records, disturbances, pictures] = found;
  Json root = {{"campaign", folder.string()}, {"name", campaign.name}};
  if (campaign.sample_rate_hz > 0) root["sample_rate_hz"] = campaign.sample_rate_hz;
  root["channels"] = Json::array();
  for (const Channel& channel : campaign.channels)
    root["channels"].push_back({{"name", channel.name},
                                {"role", to_string(channel.role)},
                                {"quantity", to_string(channel.quantity)},
                                {"unit", channel.unit},
                                {"frame", channel.frame == Frame::absolute ? "absolute" : "relative"}});
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

Json file_json(const std::filesystem::path& path, const InspectedFile& found) {
  const auto& [file, campaign, disturbances, pictures] = found;
  Json root = {{"file", path.string()}, {"format", file.format}, {"segments", file.segments}};
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

struct Results {
  std::string json, report;
  std::function<void()> print;
};

constexpr auto replace_broken_text = Json::error_handler_t::replace;

Results results_of(const std::filesystem::path& path, const Wanted& wanted, const std::string& command) {
  Results results;
  const std::string source = path.string();
  if (std::filesystem::is_directory(path)) {
    auto found = std::make_shared<InspectedCampaign>(inspected(path, wanted));
    results.json = campaign_json(path, *found).dump(2, ' ', false, replace_broken_text) + "\n";
    if (wanted.pictures) results.report = inspection_report(*found, "campaign: " + source, command);
    results.print = [path, found] { print_campaign(path, *found); };
    return results;
  }
  auto found = std::make_shared<InspectedFile>(inspected_file(path, wanted));
  results.json = file_json(path, *found).dump(2, ' ', false, replace_broken_text) + "\n";
  if (wanted.pictures)
    results.report =
        inspection_report(*found, fmt::format("file: {}", source), command, proposed_import(path, found->file));
  results.print = [path, found] { print_file(path, *found); };
  return results;
}

}  // namespace

void add_inspect_command(CLI::App* command, Action& chosen) {
  struct Options {
    std::string path;
    SelectionOptions selection;
    OutputFolder output{{"inspection.json", "report.html"}};
    bool json = false, whole = false;
  };
  auto options = std::make_shared<Options>();
  command
      ->add_option("CAMPAIGN_OR_FILE", options->path, "campaign folder, or CSV, MAT, HDF5, UFF 58, LVM or WAV file")
      ->required();
  options->selection.add_to(*command, {.band = false});
  options->output.add_to(*command, "folder for report.html and inspection.json (default: none)", false);
  command->add_flag("--whole", options->whole, "read everything, also where data are larger than 64 MB");
  command->add_flag("--json", options->json, "the same as JSON");
  command->footer(
      "Faults are for you to judge: offset, clipping, constant or coarse channels, missing samples, uneven time.\n"
      "Of more than 64 MB the first samples of every record are judged, at once; --whole reads all, a record at a "
      "time.\n"
      "Example: secular inspect out/test -o out/inspection");
  command->callback([options, command, &chosen] {
    chosen = [options, command] {
      const Window window = options->selection.window();
      std::error_code ignored;
      std::filesystem::path path = options->path;
      if (path.filename() == "campaign.toml") path = path.has_parent_path() ? path.parent_path() : ".";
      if (!std::filesystem::exists(path, ignored))
        throw InputError(options->path, "", "does not exist",
                         fmt::format("a campaign folder or a {} file was expected", data_formats));
      const bool folder = std::filesystem::is_directory(path, ignored);
      if (!folder) options->selection.require_any_record(options->path);
      const bool report = !options->output.path().empty();
      if (report) options->output.check({{"what is inspected", path.string(), true}});
      Wanted wanted{window, {}, report};
      wanted.limit.span = options->selection.span();
      if (options->whole) wanted.limit.whole_bytes = std::numeric_limits<std::size_t>::max();
      const Results results = results_of(path, wanted, command_line_of(*command));
      if (report) options->output.write({{"inspection.json", results.json}, {"report.html", results.report}});
      if (options->json)
        fmt::print("{}", results.json);
      else
        results.print();
      if (report && !options->json)
        fmt::print("written: {0}/inspection.json, {0}/report.html\n", options->output.path());
      return 0;
    };
  });
}

}  // namespace secular::app

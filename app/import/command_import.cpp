#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/App.hpp>
#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "app/shared/commands.hpp"
#include "app/shared/notices.hpp"
#include "app/shared/output_target.hpp"
#include "measure/data/campaign.hpp"
#include "measure/data/import_files.hpp"
#include "measure/data/import_tables.hpp"
#include "measure/data/names.hpp"

namespace secular::app {
namespace {

struct RecordSummary {
  std::size_t samples = 0;  ///< of a table: rows
  double start_s = 0, duration_s = 0;
  double lowest_hz = 0, highest_hz = 0;  ///< of a table
};

RecordSummary summary_of(const std::vector<LineRow>& rows) {
  RecordSummary summary{rows.size(), 0, 0, rows.front().frequency_hz, rows.front().frequency_hz};
  for (const LineRow& row : rows) {
    summary.lowest_hz = std::min(summary.lowest_hz, row.frequency_hz);
    summary.highest_hz = std::max(summary.highest_hz, row.frequency_hz);
  }
  return summary;
}

void print_json(const ImportedCampaign& imported, const std::vector<RecordSummary>& records,
                const std::string& folder) {
  const Campaign& campaign = imported.campaign;
  nlohmann::ordered_json summary = {{"campaign", folder}, {"name", campaign.name}};
  if (campaign.sample_rate_hz > 0) summary["sample_rate_hz"] = campaign.sample_rate_hz;
  summary["channels"] = nlohmann::ordered_json::array();
  for (const Channel& channel : campaign.channels)
    summary["channels"].push_back({{"name", channel.name},
                                   {"role", to_string(channel.role)},
                                   {"quantity", to_string(channel.quantity)},
                                   {"unit", channel.unit}});
  summary["records"] = nlohmann::ordered_json::array();
  for (std::size_t r = 0; r < campaign.records.size(); ++r) {
    if (campaign.records[r].kind == RecordKind::lines) {
      summary["records"].push_back({{"file", campaign.records[r].file},
                                    {"kind", "lines"},
                                    {"rows", records[r].samples},
                                    {"lowest_hz", records[r].lowest_hz},
                                    {"highest_hz", records[r].highest_hz}});
      continue;
    }
    summary["records"].push_back({{"file", campaign.records[r].file},
                                  {"kind", to_string(campaign.records[r].kind)},
                                  {"from", imported.sources[r].string()},
                                  {"samples", records[r].samples},
                                  {"start_s", records[r].start_s},
                                  {"duration_s", records[r].duration_s}});
  }
  summary["left_out"] = imported.left_out;
  summary["warnings"] = imported.warnings;
  summary["converted"] = nlohmann::ordered_json::array();
  for (const ConvertedChannel& channel : imported.converted)
    summary["converted"].push_back({{"name", channel.name}, {"from", channel.from_unit}, {"to", channel.to_unit}});
  fmt::print("{}\n", summary.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace));
}

void print_text(const ImportedCampaign& imported, const std::vector<RecordSummary>& records,
                const std::string& folder) {
  const Campaign& campaign = imported.campaign;
  const bool tables = campaign.sample_rate_hz == 0;
  fmt::print("{}: {} channel{}, {} {}{}{}\n", folder, campaign.channels.size(),
             campaign.channels.size() == 1 ? "" : "s", campaign.records.size(), tables ? "table" : "record",
             campaign.records.size() == 1 ? "" : "s",
             tables ? " of lines" : fmt::format(" at {} Hz", campaign.sample_rate_hz));
  for (std::size_t r = 0; r < campaign.records.size(); ++r)
    if (tables)
      fmt::print("  {}: {} rows, {:.6g} to {:.6g} Hz\n", campaign.records[r].file, records[r].samples,
                 records[r].lowest_hz, records[r].highest_hz);
    else
      fmt::print("  {}: {} samples, {:.6g} s\n", campaign.records[r].file, records[r].samples,
                 records[r].duration_s);
  for (const ConvertedChannel& channel : imported.converted)
    fmt::print("{}: '{}' in the file, {} in the campaign\n", channel.name, channel.from_unit, channel.to_unit);
  if (!imported.left_out.empty())
    fmt::print("left out, since no --channel names them: {}\n", fmt::join(imported.left_out, ", "));
  fmt::print("Next: secular inspect {}\n", folder);
}

void add_table_options(CLI::App& command, TableOptions& table) {
  command
      .add_option("--column", table.columns,
                  "lines: PART=VARIABLE for a column that is called otherwise; parts are f, condition, and NAME, "
                  "NAME.phase, NAME.re, NAME.im, NAME.sd, NAME.phase_sd of a channel, NAME@3.phase at 3 Omega")
      ->expected(1)
      ->take_all();
  command.add_option("--amplitudes", table.amplitudes, "lines: amplitudes are peak (default), rms or peak_to_peak");
  command.add_option("--phases", table.phases, "lines: phases are in rad or deg, where the file does not say it");
  command.add_option("--phase-sign", table.phase_sign,
                     "lines: lead (default: cos(Omega t + phase)) or lag (cos(Omega t - phase))");
  command.add_option("--phase-offset", table.phase_offset_deg, "lines: degrees on top of the phases of responses");
  command.add_flag("--per-excitation", table.per_excitation,
                   "lines: responses are over the excitation's amplitude (frequency response functions)");
  command.add_option("--frequency-unit", table.frequency_unit,
                     "lines: Hz (default), kHz, rad/s or 1/min, where the file does not say it");
}

ImportedCampaign import_into(CampaignWriter& writer, const ImportOptions& options,
                             std::vector<RecordSummary>& records) {
  if (parse_record_kind(options.kind) == RecordKind::lines)
    return import_tables(options,
                         [&](const Campaign& campaign, const RecordEntry& entry, const std::vector<LineRow>& rows) {
                           writer.write(campaign, entry, rows);
                           records.push_back(summary_of(rows));
                         });
  return import_files(options, [&](const Campaign& campaign, const RecordEntry& entry, Record&& record) {
    writer.write(campaign, entry, record);
    records.push_back(
        {record.samples(), record.start_s, static_cast<double>(record.samples()) / record.sample_rate_hz, 0, 0});
  });
}

}  // namespace

void add_import_command(CLI::App* command, Action& chosen) {
  struct Options {
    ImportOptions import;
    std::vector<std::string> files;
    OutputCampaign output;
    bool json = false;
  };
  auto options = std::make_shared<Options>();
  ImportOptions& import = options->import;
  command->add_option("FILE", options->files, "CSV, MAT, HDF5, UFF 58, LVM or WAV files, each a record")
      ->required();
  options->output.add_to(*command);
  command->add_option("--kind", import.kind, std::string(record_kind_list) + "; lines: a table, see below");
  command
      ->add_option(
          "--channel", import.channels,
          "NAME:ROLE:QUANTITY:UNIT of a variable, once for each channel; NAME:ROLE where the file says the "
          "rest; NAME=VARIABLE:... renames it; ...:UNIT:FACTOR where a number x means x*FACTOR in UNIT")
      ->expected(1)
      ->take_all();
  command->add_option("--time", import.time,
                      "variable that holds the time (default: the one called t or time), in seconds where neither "
                      "the file nor NAME:UNIT "
                      "says ms, us, min, ...");
  command->add_option("--sample-rate", import.sample_rate_hz, "samples a second, where no variable holds time");
  command->add_option("--name", import.name, "name of the campaign (default: of the first file)");
  command->add_option("--group", import.group, "what the records have in common");
  command
      ->add_option("--frequency", import.frequencies_hz, "nominal excitation frequency in Hz: one, or one a file")
      ->expected(1)
      ->take_all();
  command
      ->add_option(
          "--amplitude,--level", import.amplitudes,
          "nominal excitation amplitude in the unit of its channel: one, or one a file; of a table without "
          "such a column its level")
      ->expected(1)
      ->take_all();
  command->add_option("--ensemble", import.ensemble_s, "seconds of an ensemble that dwells are cut into");
  command->add_option("--decimal-mark", import.decimal_mark,
                      ". or , of a CSV that has both; the other one then parts thousands");
  add_table_options(*command, import.table);
  command->add_flag("--json", options->json, "what was made, as JSON");
  command->footer(
      "ROLE: excitation or response. QUANTITY and UNIT: acceleration m/s^2, velocity m/s, displacement m, force "
      "N,\n"
      "voltage V, strain 1, angle rad. What a file does not say is asked for by the name of the option.\n"
      "UFF, HDF5 and CSV files may say the unit themselves: NAME:ROLE is enough then. Other units (g, mm, in, deg, "
      "...)\n"
      "become SI. WAV files and counts need the FACTOR that takes a number to the UNIT.\n"
      "A table of lines has a row for every settled dwell: frequency, level, amplitude and phase of the response "
      "(or\n"
      "real and imaginary part), perhaps standard deviations; a * in a variable, run(*).force, makes a table of "
      "each.\n"
      "Example: secular import swing.mat -o swing --kind free_decay --time t --channel theta:response:angle:rad\n"
      "Example: secular import stepped.csv -o stepped --kind lines --phases deg --channel "
      "force:excitation:force:N \\\n"
      "  --channel tip:response:displacement:mm");
  command->callback([options, &chosen] {
    chosen = [options] {
      options->import.files.assign(options->files.begin(), options->files.end());
      std::vector<CommandInput> inputs;
      for (const std::string& file : options->files) inputs.push_back({"the file", file, false});
      options->output.check(inputs);
      CampaignWriter writer(options->output.path(), options->output.replaces());
      std::vector<RecordSummary> records;
      const ImportedCampaign imported = import_into(writer, options->import, records);
      writer.finish(imported.campaign);
      print_warnings(imported.warnings);
      if (options->json)
        print_json(imported, records, options->output.path());
      else
        print_text(imported, records, options->output.path());
      return 0;
    };
  });
}

}  // namespace secular::app

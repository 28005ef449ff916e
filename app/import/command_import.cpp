#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/App.hpp>
#include <memory>
#include <string>
#include <vector>

#include "app/shared/commands.hpp"
#include "app/shared/notices.hpp"
#include "app/shared/output_target.hpp"
#include "jobs/import/import_run.hpp"
#include "measure/data/campaign.hpp"
#include "measure/data/names.hpp"

namespace secular::app {
namespace {

void print_text(const ImportRun& run, const std::string& folder, bool made) {
  const auto& [imported, records] = run;
  const Campaign& campaign = imported.campaign;
  const bool tables = campaign.sample_rate_hz == 0;
  fmt::print("{}{}: {} channel{}, {} {}{}{}\n", made ? "" : "would make ", folder, campaign.channels.size(),
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
  if (campaign.geometry)
    fmt::print("geometry: {} points, {} lines; {} of {} responses have a place\n", campaign.geometry->points.size(),
               campaign.geometry->lines.size(), campaign.geometry->sensors.size(),
               channels_of(campaign, ChannelRole::response).size());
  if (made) {
    fmt::print("Next: secular inspect {}\n", folder);
    return;
  }
  for (const Channel& channel : campaign.channels)
    fmt::print("channel {}: {}, {} in {}\n", channel.name, to_string(channel.role), to_string(channel.quantity),
               channel.unit);
  fmt::print("Nothing was written: the same without --dry-run makes it\n");
}

void add_table_options(CLI::App& command, ImportOptions& import) {
  TableOptions& table = import.table;
  command.add_option("--decimal-mark", import.decimal_mark,
                     ". or , of a CSV that has both; the other one then parts thousands");
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

// What the channels are, and how late.
void add_channel_options(CLI::App& command, ImportOptions& import) {
  command
      .add_option("--channel", import.channels,
                  "NAME:ROLE:QUANTITY:UNIT of a variable, once for each channel; NAME:ROLE where the file says the "
                  "rest; NAME=VARIABLE:... renames it; ...:UNIT:FACTOR where a number x means x*FACTOR in UNIT")
      ->expected(1)
      ->take_all();
  command
      .add_option("--delay", import.delays,
                  "NAME=S: samples of a channel come S seconds late against the others', by a mere delay")
      ->expected(1)
      ->take_all();
}

}  // namespace

void add_import_command(CLI::App* command, Action& chosen) {
  struct Options {
    ImportOptions import;
    std::vector<std::string> files;
    OutputCampaign output;
    bool json = false, dry_run = false;
  };
  auto options = std::make_shared<Options>();
  ImportOptions& import = options->import;
  command->add_option("FILE", options->files, "CSV, MAT, HDF5, UFF 58, LVM or WAV files, each a record")
      ->required();
  options->output.add_to(*command);
  command->add_option("--kind", import.kind, std::string(record_kind_list) + "; lines: a table, see below");
  add_channel_options(*command, import);
  command->add_option("--time", import.time,
                      "variable that holds the time (default: the one called t or time), in seconds where neither "
                      "the file nor NAME:UNIT "
                      "says ms, us, min, ...");
  command->add_option("--sample-rate", import.sample_rate_hz, "samples a second, where no variable holds time");
  command->add_option("--name", import.name, "name of the campaign (default: of the first file)");
  command->add_option(
      "--geometry", import.geometry,
      "universal file whose nodes and trace lines the report of `secular modal` draws (default: those "
      "of a first FILE that holds any)");
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
  add_table_options(*command, import);
  command->add_flag("--dry-run", options->dry_run, "say what would be made, and write nothing");
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
      const ImportRun run = options->dry_run
                                ? preview_import(options->import)
                                : run_import(options->import, options->output.path(), options->output.replaces());
      print_warnings(run.imported.warnings);
      if (options->json)
        fmt::print("{}", import_json(run, options->output.path()));
      else
        print_text(run, options->output.path(), !options->dry_run);
      return 0;
    };
  });
}

}  // namespace secular::app

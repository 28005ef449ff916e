#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/App.hpp>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "app/shared/commands.hpp"
#include "app/shared/notices.hpp"
#include "app/shared/output_target.hpp"
#include "measure/data/campaign.hpp"
#include "measure/data/import_files.hpp"

namespace secular::app {
namespace {

struct RecordSummary {
  std::size_t samples = 0;
  double start_s = 0, duration_s = 0;
};

void print_json(const ImportedCampaign& imported, const std::vector<RecordSummary>& records,
                const ImportOptions& options, const std::string& folder) {
  const Campaign& campaign = imported.campaign;
  nlohmann::ordered_json summary = {
      {"campaign", folder}, {"name", campaign.name}, {"sample_rate_hz", campaign.sample_rate_hz}};
  summary["channels"] = nlohmann::ordered_json::array();
  for (const Channel& channel : campaign.channels)
    summary["channels"].push_back({{"name", channel.name},
                                   {"role", to_string(channel.role)},
                                   {"quantity", to_string(channel.quantity)},
                                   {"unit", channel.unit}});
  summary["records"] = nlohmann::ordered_json::array();
  for (std::size_t r = 0; r < campaign.records.size(); ++r)
    summary["records"].push_back({{"file", campaign.records[r].file},
                                  {"kind", to_string(campaign.records[r].kind)},
                                  {"from", options.files[r].string()},
                                  {"samples", records[r].samples},
                                  {"start_s", records[r].start_s},
                                  {"duration_s", records[r].duration_s}});
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
  fmt::print("{}: {} channel{}, {} record{} at {} Hz\n", folder, campaign.channels.size(),
             campaign.channels.size() == 1 ? "" : "s", campaign.records.size(),
             campaign.records.size() == 1 ? "" : "s", campaign.sample_rate_hz);
  for (std::size_t r = 0; r < campaign.records.size(); ++r)
    fmt::print("  {}: {} samples, {:.6g} s\n", campaign.records[r].file, records[r].samples, records[r].duration_s);
  for (const ConvertedChannel& channel : imported.converted)
    fmt::print("{}: '{}' in the file, {} in the campaign\n", channel.name, channel.from_unit, channel.to_unit);
  if (!imported.left_out.empty())
    fmt::print("left out, since no --channel names them: {}\n", fmt::join(imported.left_out, ", "));
  fmt::print("Next: secular inspect {}\n", folder);
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
  command->add_option("--kind", import.kind, "dwell, sweep, free_decay, impact or broadband");
  command
      ->add_option(
          "--channel", import.channels,
          "NAME:ROLE:QUANTITY:UNIT of a variable, once for each channel; NAME:ROLE where the file says the "
          "rest; NAME=VARIABLE:... renames it; ...:UNIT:FACTOR where a number x means x*FACTOR in UNIT")
      ->expected(1)
      ->take_all();
  command->add_option("--time", import.time,
                      "variable that holds the time (default: t), in seconds where neither the file nor NAME:UNIT "
                      "says ms, us, min, ...");
  command->add_option("--sample-rate", import.sample_rate_hz, "samples a second, where no variable holds time");
  command->add_option("--name", import.name, "name of the campaign (default: of the first file)");
  command->add_option("--group", import.group, "what the records have in common");
  command
      ->add_option("--frequency", import.frequencies_hz, "nominal excitation frequency in Hz: one, or one a file")
      ->expected(1)
      ->take_all();
  command
      ->add_option("--amplitude", import.amplitudes,
                   "nominal excitation amplitude in the unit of its channel: one, or one a file")
      ->expected(1)
      ->take_all();
  command->add_option("--ensemble", import.ensemble_s, "seconds of an ensemble that dwells are cut into");
  command->add_option("--decimal-mark", import.decimal_mark,
                      ". or , of a CSV that has both; the other one then parts thousands");
  command->add_flag("--json", options->json, "what was made, as JSON");
  command->footer(
      "ROLE: excitation or response. QUANTITY and UNIT: acceleration m/s^2, velocity m/s, displacement m, force "
      "N,\n"
      "voltage V, strain 1, angle rad. What a file does not say is asked for by the name of the option.\n"
      "UFF, HDF5 and CSV files may say the unit themselves: NAME:ROLE is enough then. Other units (g, mm, in, deg, "
      "...)\n"
      "become SI. WAV files and counts need the FACTOR that takes a number to the UNIT.\n"
      "Example: secular import swing.mat -o swing --kind free_decay --time t --channel theta:response:angle:rad");
  command->callback([options, &chosen] {
    chosen = [options] {
      options->import.files.assign(options->files.begin(), options->files.end());
      std::vector<CommandInput> inputs;
      for (const std::string& file : options->files) inputs.push_back({"the file", file, false});
      options->output.check(inputs);
      CampaignWriter writer(options->output.path(), options->output.replaces());
      std::vector<RecordSummary> records;
      const ImportedCampaign imported =
          import_files(options->import, [&](const Campaign& campaign, const RecordEntry& entry, Record&& record) {
            writer.write(campaign, entry, record);
            records.push_back(
                {record.samples(), record.start_s, static_cast<double>(record.samples()) / record.sample_rate_hz});
          });
      writer.finish(imported.campaign);
      print_warnings(imported.warnings);
      if (options->json)
        print_json(imported, records, options->import, options->output.path());
      else
        print_text(imported, records, options->output.path());
      return 0;
    };
  });
}

}  // namespace secular::app

#include <fmt/format.h>

#include <CLI/App.hpp>
#include <cmath>
#include <memory>
#include <string>

#include "app/shared/command_line.hpp"
#include "app/shared/commands.hpp"
#include "app/shared/notices.hpp"
#include "app/shared/output_target.hpp"
#include "app/shared/selection_options.hpp"
#include "jobs/spectrum/spectrum_run.hpp"

namespace secular::app {
namespace {

struct SpectrumArguments {
  SpectrumRequest request;
  OutputFolder output{{"spectrum.json", "report.html"}};
  SelectionOptions selection;
  bool json = false;
};

void print_table(const RecordSpectrum& record) {
  fmt::print("{}\n{} ensemble{} of {:.6g} s\n", record.source, record.survey.layout.count,
             record.survey.layout.count == 1 ? "" : "s",
             static_cast<double>(record.survey.layout.length) / record.sample_rate_hz);
  for (const std::string& text : record.conclusions) fmt::print("- {}\n", text);
  const bool rates = record.has_rates();
  const auto deviation = [](double sd) { return std::isfinite(sd) ? fmt::format("{:.2g}", sd) : std::string("-"); };
  for (std::size_t c = 0; c < record.names.size(); ++c) {
    fmt::print("\n{} ({})\n  {:<20} {:>14} {:>9} {:>13} {:>9}", record.names[c],
               record.units[c].empty() ? "unit not known" : record.units[c], "method", "frequency Hz", "sd",
               "amplitude", "sd");
    fmt::print("{}{:>9} {:>7}\n", rates ? fmt::format(" {:>10}", "rate 1/s") : "", "gamma^2", "dB");
    for (const MethodStatistics& method : record.survey.tables[c]) {
      if (!record.are_tones(c, method)) {
        fmt::print("  {:<20} {}\n", method.name, no_tones_text(method));
        continue;
      }
      for (std::size_t i = 0; i < method.terms.size(); ++i) {
        const TermStatistics& term = method.terms[i];
        const std::string name = i > 0 ? "" : method.name;
        fmt::print("  {:<20} {:>13.8g}{} {:>9} {:>13.6g} {:>9}", name, term.frequency_hz,
                   term.family == PoleFamily::circular ? " " : "*", deviation(term.frequency_sd), term.amplitude,
                   deviation(term.amplitude_sd));
        if (rates)
          fmt::print(" {:>10}", term.family == PoleFamily::circular ? "" : fmt::format("{:.5g}", term.rate));
        if (i == 0) fmt::print("{:>9.6f} {:>7.1f}", method.correlation, method.signal_to_noise_db);
        fmt::print("\n");
      }
    }
  }
  fmt::print("sd: {}\n",
             record.survey.layout.count > 1
                 ? "scatter of one ensemble"
                 : "maximum likelihood's own, from the noise it leaves; --ensemble gives scatter to all");
  if (rates)
    fmt::print("*: hyperbolic (a rate over 2 pi), or a product (frequency, and rate of growth or decay)\n");
}

int run(SpectrumArguments& options, const CLI::App& command) {
  options.request.window = options.selection.window();
  options.request.warn = print_warning;
  options.output.check({{"the record", options.request.source, true}});
  const SpectrumRun found = run_spectrum(options.request);
  const std::string json = spectrum_json(found);
  options.output.write(
      {{"spectrum.json", json}, {"report.html", spectrum_report(found, command_line_of(command))}});
  if (options.json) {
    fmt::print("{}", json);
    return 0;
  }
  if (found.record) print_table(*found.record);
  for (const auto& [name, levels] : found.table.series)
    fmt::print("{}: steady responses at {} level{}\n", name, levels.size(), levels.size() == 1 ? "" : "s");
  fmt::print("written: {0}/spectrum.json, {0}/report.html\n", options.output.path());
  return 0;
}

}  // namespace

void add_spectrum_command(CLI::App* command, Action& chosen) {
  auto options = std::make_shared<SpectrumArguments>();
  SpectralOptions& spectral = options->request.spectral;
  command
      ->add_option("CAMPAIGN_OR_FILE", options->request.source,
                   "campaign folder, or CSV, MAT, HDF5, UFF 58, LVM or WAV file")
      ->required();
  options->output.add_to(*command, "folder for spectrum.json and report.html");
  options->selection.add_to(*command);
  command->add_option("--channel", options->request.channels, "analyse these channels (default: every response)")
      ->expected(1)
      ->take_all();
  command
      ->add_option("--order", spectral.order, "terms of the decomposition (default: the tones that a test finds)")
      ->check(CLI::Range(1, 40));
  command->add_option("--ensemble", spectral.ensemble_s, "cut the record into ensembles of this length, s")
      ->check(CLI::PositiveNumber);
  command->add_option("--overlap", spectral.overlap, "share of an ensemble that the next one sees again")
      ->check(CLI::Range(0.0, 0.95));
  command->add_option("--delays", spectral.delays, "delay coordinates of the principal components")
      ->check(CLI::Range(4, 400));
  command->add_flag("--offset", spectral.offset, "a constant in every channel beside the terms");
  command->add_option("--time", options->request.time, "file: the variable that holds the time in seconds");
  command
      ->add_option("--sample-rate", options->request.sample_rate_hz,
                   "file: samples a second, where none holds time")
      ->check(CLI::PositiveNumber);
  command->add_flag("--json", options->json, "print spectrum.json instead of the summary");
  command->footer(
      "Circular-hyperbolic decomposition by four methods, over ensembles where --ensemble is given; singular "
      "values "
      "of\ndelay coordinates and of the channels; whether the record has settled; what of each response a linear "
      "relation to\nthe excitation explains. Of a file of steady responses (members frequency, amplitude, force) "
      "the "
      "curves of each level.\nExample: secular spectrum campaign --records '*0001*' --ensemble 4 --overlap 0.5 -o "
      "results");
  command->callback(
      [options, command, &chosen] { chosen = [options, command] { return run(*options, *command); }; });
}

}  // namespace secular::app

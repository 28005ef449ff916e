#include <fmt/format.h>

#include <CLI/App.hpp>
#include <algorithm>
#include <memory>
#include <sstream>
#include <string>
#include <thread>

#include "app/procedure/thesis_procedures.hpp"
#include "app/shared/command_line.hpp"
#include "app/shared/commands.hpp"
#include "app/shared/word_choice.hpp"
#include "app/shared/notices.hpp"
#include "app/shared/output_target.hpp"
#include "app/shared/selection_options.hpp"
#include "input/input_error.hpp"
#include "jobs/shared/record_selection.hpp"
#include "report/number_format.hpp"

namespace secular::app {
namespace {

struct ProcedureArguments {
  ProcedureRequest request;
  std::vector<std::string> terms;
  SelectionOptions selection;
  OutputFolder output{{"procedures.json", "report.html"}};
  bool json = false;
};

std::string number_or_blank(const std::optional<double>& value) {
  return value ? report::format_number(*value, 4) : "";
}

void print_summary(const ProcedureRun& run, const std::string& folder) {
  const report::PlainNumbers plain(prints_for_programs());
  fmt::print("model {}, case {}: {} ensembles\n", run.model->name, run.resonance->name,
             run.measured.observations.size());
  for (const ProcedureSection& section : run.sections) {
    fmt::print("{}\n", section.title);
    for (const ProcedureRow& row : section.rows) {
      std::string line = fmt::format(
          "  {:<40} {:<18}", row.name,
          row.sd ? report::format_uncertain(row.recovered, *row.sd) : report::format_number(row.recovered, 5));
      if (row.bias) line += "  without bias " + report::format_uncertain(row.best(), row.bias->sd());
      if (row.truth) line += "  true " + number_or_blank(row.truth);
      if (row.as_printed) line += "  as printed " + number_or_blank(row.as_printed);
      if (row.source) line += "  Table " + row.table + ": " + number_or_blank(row.source);
      fmt::print("{}\n", line);
    }
    for (const auto& [name, table] : section.anova)
      for (const AnovaRow& row : table.rows) {
        const std::string line = fmt::format("  {}: without {}: ", name, row.name);
        if (row.degrees_of_freedom == 0)
          fmt::print("{}no loss, the other terms hold it\n", line);
        else
          fmt::print("{}F = {} (p {}), by condition F = {} (p {})\n", line, report::format_number(row.f, 4),
                     report::format_number(row.p, 2), report::format_number(row.clustered_f, 4),
                     report::format_number(row.clustered_p, 2));
      }
  }
  fmt::print("written: {0}/procedures.json, {0}/report.html\n", folder);
}

}  // namespace

void add_procedure_command(CLI::App* command, Action& chosen) {
  auto options = std::make_shared<ProcedureArguments>();
  ProcedureRequest& request = options->request;
  command->add_option("CAMPAIGN", request.campaign, "campaign folder with dwells")->required();
  command->add_option("--model", request.model, "model file, or the name of a shipped model")->required();
  command->add_option("--case", request.resonance, "resonance case; otherwise the one that the methods cover");
  command
      ->add_option(
          "--method", request.methods,
          "saddle_node, harmonic, frequency_response, two_modes, anova (alone: of any case of dwells); all that "
          "apply without it")
      ->delimiter(',')
      ->check(one_of({"saddle_node", "harmonic", "frequency_response", "two_modes", "anova"}));
  command->add_option("--term", options->terms, "NAME,NAME: columns tested together in the analysis of variance")
      ->allow_extra_args(false);
  command->add_option("--without", request.left_out, "lumps that the analysis of variance leaves out of the model")
      ->delimiter(',');
  command->add_option("--true", request.truth, "parameters a simulated campaign was made with: experiment or JSON");
  options->selection.add_to(*command);
  options->output.add_to(*command, "folder for procedures.json and report.html");
  command->add_flag("--interpret", request.interpret, "no compiled code of the model: slower, same results");
  command->add_flag_callback(
      "--no-bias", [options] { options->request.bias = false; },
      "leave out what every method does on motions of the full equations, where the truth is known");
  request.threads = std::max(1U, std::thread::hardware_concurrency());
  command->add_option("--threads", request.threads, "threads; the result does not depend on it")
      ->check(CLI::Range(1U, 1024U));
  command->add_flag("--json", options->json, "print procedures.json instead of the summary");
  command->footer(
      "Example: secular procedure campaign --model two_mass_mode1 --true experiments/thesis_chapter5 -o out");
  command->callback([options, command, &chosen] {
    chosen = [options, command] {
      ProcedureRequest& asked = options->request;
      asked.window = options->selection.window();
      options->output.check({{"the campaign", asked.campaign, true},
                             {"the model", asked.model, false},
                             {"the truth", asked.truth, false}});
      for (const std::string& text : options->terms) {
        std::vector<std::string> names;
        std::istringstream stream(text);
        for (std::string name; std::getline(stream, name, ',');) names.push_back(name);
        asked.terms.push_back(std::move(names));
      }
      const ProcedureRun run = run_procedures(asked);
      const std::string json = procedures_json(run);
      const std::string html = procedures_report(run, command_line_of(*command));
      options->output.write({{"procedures.json", json}, {"report.html", html}});
      print_warnings(run.warnings);
      if (options->json)
        fmt::print("{}", json);
      else
        print_summary(run, options->output.path());
      return 0;
    };
  });
}

}  // namespace secular::app

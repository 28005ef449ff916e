#include <fmt/format.h>

#include <CLI/App.hpp>
#include <functional>
#include <memory>
#include <string>

#include "app/shared/commands.hpp"
#include "app/shared/word_choice.hpp"
#include "app/shared/notices.hpp"
#include "app/shared/output_target.hpp"
#include "app/shared/progress_line.hpp"
#include "jobs/derive/derivation.hpp"

namespace secular::app {

void add_derive_command(CLI::App* command, Action& chosen) {
  struct Options {
    DerivationRequest request;
    std::string format = "text";
    OutputFile output;
    bool json = false;
  };
  auto options = std::make_shared<Options>();
  command->add_option("MODEL", options->request.model, "model file, or the name of a shipped model")->required();
  command->add_option("--case", options->request.resonance, "one resonance case; all without it");
  command
      ->add_option("--format", options->format,
                   "text, json, latex (a document that needs amsmath only) or html (a page by itself)")
      ->check(one_of({"text", "json", "latex", "html"}))
      ->capture_default_str();
  command->add_option(
      "--with-effect", options->request.effects,
      "NAME[:MODE[:OTHER[:FORM]]]: add an effect of the catalogue to the equations of motion of coordinate MODE "
      "(repeatable)");
  command->add_flag("--json", options->json, "same as --format json");
  options->output.add_to(*command);
  command->footer(
      "Exit status 1 if a certificate does not hold.\n"
      "Examples: secular derive two_mass_mode1 --case principal_parametric\n"
      "          secular derive pendulum --format html -o pendulum.html");
  command->callback([options, &chosen] {
    chosen = [options] {
      options->output.check({{"the model", options->request.model, false}});
      ProgressLine progress("steps");
      options->request.progress = std::ref(progress);
      const CanonicalModel model = derive(options->request);
      options->output.write(derivation_document(model, options->json ? "json" : options->format));
      for (const CanonicalCase& resonance : model.cases) print_warnings(resonance.warnings);
      return is_certified(model) ? 0 : 1;
    };
  });
}

}  // namespace secular::app

#include <fmt/format.h>

#include <CLI/App.hpp>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "app/shared/commands.hpp"
#include "app/shared/notices.hpp"
#include "app/shared/output_target.hpp"
#include "app/shared/progress_line.hpp"
#include "app/shared/shipped_models.hpp"
#include "codegen/document/print_html.hpp"
#include "codegen/document/print_json.hpp"
#include "codegen/document/print_latex.hpp"
#include "codegen/document/print_text.hpp"
#include "perturb/model.hpp"
#include "perturb/with_effects.hpp"

namespace secular::app {
namespace {

std::string derivation(const CanonicalModel& model, const std::string& format) {
  if (format == "json") return derivation_json(model);
  if (format == "latex") return derivation_latex(model);
  if (format == "html") return derivation_html(model);
  return derivation_text(model);
}

Model augmented(const Model& model, const std::vector<std::string>& effects) {
  std::vector<EffectTerm> terms;
  for (const std::string& effect : effects) terms.push_back(parse_effect_term(effect, model));
  return with_effects(model, terms).model;
}

}  // namespace

void add_derive_command(CLI::App* command, Action& chosen) {
  struct Options {
    std::string model, resonance, format = "text";
    OutputFile output;
    std::vector<std::string> effects;
    bool json = false;
  };
  auto options = std::make_shared<Options>();
  command->add_option("MODEL", options->model, "model file, or the name of a shipped model")->required();
  command->add_option("--case", options->resonance, "one resonance case; all without it");
  command
      ->add_option("--format", options->format,
                   "text, json, latex (a document that needs amsmath only) or html (a page by itself)")
      ->check(CLI::IsMember({"text", "json", "latex", "html"}))
      ->capture_default_str();
  command->add_option(
      "--with-effect", options->effects,
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
      options->output.check({{"the model", options->model, false}});
      ProgressLine progress("steps");
      const CanonicalModel model =
          canonical_model(augmented(read_model(resolve_model(options->model)), options->effects),
                          options->resonance, CanonicalContent::all, std::ref(progress));
      const std::string text = derivation(model, options->json ? "json" : options->format);
      options->output.write(text);
      bool certified = true;
      for (const CanonicalCase& resonance : model.cases) {
        print_warnings(resonance.warnings);
        certified = certified && resonance.certificate.holds;
      }
      return certified ? 0 : 1;
    };
  });
}

}  // namespace secular::app

#include <fmt/format.h>

#include <CLI/App.hpp>
#include <algorithm>
#include <cstdlib>
#include <map>
#include <memory>
#include <numbers>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "app/shared/command_line.hpp"
#include "app/shared/commands.hpp"
#include "app/shared/word_choice.hpp"
#include "app/shared/notices.hpp"
#include "app/shared/output_target.hpp"
#include "app/shared/progress_line.hpp"
#include "app/shared/selection_options.hpp"
#include "input/input_error.hpp"
#include "jobs/identify/estimate_json.hpp"
#include "jobs/identify/full_equations.hpp"
#include "jobs/identify/identification.hpp"
#include "jobs/identify/identification_report.hpp"
#include "jobs/identify/scatter_output.hpp"
#include "jobs/shared/left_out.hpp"
#include "numerics/hertz.hpp"
#include "report/number_format.hpp"

namespace secular::app {
namespace {

struct IdentifyArguments {
  std::string campaign;
  IdentificationRequest request;
  SelectionOptions selection;
  OutputFolder output{{"estimate.json", "report.html", "response.svg"}};
  std::vector<std::string> fixed;
  std::string by;  ///< empty: as the records need it
  bool json = false, timings = false;
};

void parse_fixed(IdentifyArguments& options) {
  for (const std::string& text : options.fixed) {
    const std::size_t equals = text.find('=');
    char* end = nullptr;
    const double value = equals == std::string::npos ? 0 : std::strtod(text.c_str() + equals + 1, &end);
    if (equals == std::string::npos || equals == 0 || end == text.c_str() + equals + 1 || *end != '\0')
      throw InputError("--fix " + text, "", "is not NAME=VALUE", "for example --fix mu2=0");
    if (!std::isfinite(value)) throw InputError("--fix " + text, "", "is not a finite number");
    const std::string name = text.substr(0, equals);
    const auto [given, fresh] = options.request.fixed.emplace(name, value);
    if (!fresh && given->second != value)
      throw InputError("--fix " + text, "", fmt::format("contradicts --fix {}={}", name, given->second),
                       "give every name once");
  }
}

void print_following(const Identification& id) {
  if (id.following.empty()) return;
  fmt::print("follow from the rest position\n");
  for (const FollowingEstimate& f : id.following)
    fmt::print("  {:<12} {:>20}{}\n", f.name, report::format_uncertain(f.value, f.sd),
               f.doubtful ? " doubtful" : "");
}

// `in_hertz`: of a natural frequency, which is said in Hz too.
void print_value(const EstimatedValue& v, bool in_hertz = false) {
  if (v.fixed)
    fmt::print("  {:<12} {:>20} {:<14} given\n", v.name, report::format_number(*v.value, 6), v.unit);
  else if (v.value)
    fmt::print("  {:<12} {:>20} {:<14} sd {} %{}{}{}\n", v.name, report::format_uncertain(*v.value, v.sd), v.unit,
               report::format_number(100 * v.sd / std::abs(*v.value), 2), v.significant ? "" : ", not significant",
               v.doubtful ? ", doubtful" : "",
               in_hertz ? ", " + report::format_uncertain(*v.value * to_hz, v.sd * to_hz) + " Hz" : "");
  else {
    std::string with;
    for (const std::string& other : v.entangled_with) with += (with.empty() ? "" : ", ") + other;
    fmt::print("  {:<12} {:>20} {}\n", v.name, "not identifiable", with.empty() ? "" : "entangled with " + with);
  }
}

// Natural frequencies are the first of a model's symbols.
void print_parameters(const Identification& id) {
  const std::vector<EstimatedValue>& all = id.estimate.parameters;
  for (std::size_t p = 0; p < all.size(); ++p) print_value(all[p], p < id.model->modes());
}

void print_not_separated(const Estimate& estimate) {
  for (const NullDirection& direction : estimate.null_directions) {
    std::string tests;
    for (std::size_t i = 0; i < direction.parted_by.size() && i < 3; ++i)
      tests += (i == 0 ? "" : "; ") + direction.parted_by[i];
    fmt::print("not separated: {}{}\n", direction.text, tests.empty() ? "" : ". What would part them: " + tests);
  }
}

void print_full_summary(const Identification& id, const std::string& folder) {
  const report::PlainNumbers plain(prints_for_programs());
  const FullEstimate& full = *id.full;
  fmt::print("model {}, by the full equations: {}; {} of the samples\n", id.model->name,
             records_in_words(id.campaign, full.records), report::format_percent(full.data_used));
  if (full.has_converged) {
    const LackOfFit& fit = id.estimate.lack_of_fit.front().equations.front();
    fmt::print("fit of all records: off by {:.3g} times what the measurement repeats to (p = {:.2g}{})\n",
               fit.misfit_ratio, fit.p_value,
               full.noise_misjudged ? ": the noise is misjudged, and nothing is said of the model"
               : fit.significant    ? ", the model does not hold"
                                    : ", nothing wrong");
    fmt::print("parameters\n");
    print_parameters(id);
    print_following(id);
    print_not_separated(id.estimate);
  } else {
    fmt::print("no numbers: the fit did not come to an end\n");
  }
  print_disturbances(id.disturbances, id.campaign, id.looked_at);
  fmt::print("written: {0}/estimate.json, {0}/report.html, {0}/response.svg\n", folder);
}

void print_summary(const Identification& id, const std::string& folder) {
  const report::PlainNumbers plain(prints_for_programs());
  for (const ObservationSet& set : id.measured)
    fmt::print("model {}, case {}: {} observations\n", id.model->name, set.resonance->name,
               set.observations.size());
  fmt::print("parameters{}\n", id.refinement ? ", " + text_of(*id.refinement) : "");
  print_parameters(id);
  for (const std::string& line : scatter_lines(id.estimate)) fmt::print("  {}\n", line);
  print_following(id);
  fmt::print("lumps\n");
  for (const ObservationSet& set : id.measured) {
    if (id.measured.size() > 1) fmt::print(" case {}\n", set.resonance->name);
    for (const EstimatedValue& v : id.estimate.lumps)
      if (v.value && v.resonance == set.resonance->name) print_value(v);
  }
  for (const CaseLackOfFit& tests : id.estimate.lack_of_fit) {
    const auto worst =
        std::max_element(tests.equations.begin(), tests.equations.end(),
                         [](const LackOfFit& a, const LackOfFit& b) { return a.p_value > b.p_value; });
    fmt::print("fit of {}: worst equation {} off by {:.2f} times what repeats explain (p = {:.2g}{})\n",
               tests.resonance.empty() ? "the decays in one piece" : "case " + tests.resonance, worst->name,
               worst->misfit_ratio, worst->p_value, worst->significant ? "" : ", nothing wrong");
  }
  for (const DampingComparison& damping : id.estimate.damping) {
    std::string terms;
    for (const std::string& term : damping.laws[damping.chosen].terms) terms += (terms.empty() ? "" : " + ") + term;
    fmt::print("damping of {}: {}{}\n", damping.mode, terms,
               damping.decided ? " (decided: laws without these terms predict left-out conditions worse)"
                               : " (not decided: others predict left-out conditions no worse)");
  }
  print_not_separated(id.estimate);
  for (const HeldOutPrediction& p : id.held_out) {
    const bool angle = id.coordinate_unit == "rad";
    fmt::print("held out: {:.1f} s to {:.1f} s predicted within {:.3g} {} RMS\n", p.from_s, p.to_s,
               angle ? p.rms * 180 / std::numbers::pi : p.rms, angle ? "degrees" : id.coordinate_unit);
  }
  print_disturbances(id.disturbances, id.campaign, id.looked_at);
  fmt::print("written: {0}/estimate.json, {0}/report.html, {0}/response.svg\n", folder);
}

// The exit status.
int run(IdentifyArguments& options, const std::string& command) {
  ProgressLine line("fits (about)");
  options.request.progress = [&line](std::size_t done, std::size_t expected) { line(done, expected); };
  options.request.note = print_note;
  const Identification result = identify(options.request, read_campaign(options.campaign));
  const std::string json = estimate_json(result);
  const report::Figure response = response_figure(result);
  const std::string html = identification_report(result, response, command);
  const std::string figure = report::render_figure(response, "response", report::FigureUse::standalone).svg;
  options.output.write({{"estimate.json", json}, {"report.html", html}, {"response.svg", figure}});
  if (options.timings)
    for (const auto& [stage, seconds] : result.seconds) fmt::print(stderr, "{:<30} {:7.3f} s\n", stage, seconds);
  print_warnings(folded(result.estimate.warnings, result.campaign));
  if (options.json)
    fmt::print("{}", json);
  else if (result.full)
    print_full_summary(result, options.output.path());
  else
    print_summary(result, options.output.path());
  if (result.mostly_left_out) fmt::print(stderr, "secular: {}\n", *result.mostly_left_out);
  return result.mostly_left_out || (result.full && !result.full->has_converged) ? 1 : 0;
}

}  // namespace

void add_identify_command(CLI::App* command, Action& chosen) {
  auto options = std::make_shared<IdentifyArguments>();
  options->request.threads = std::max(1U, std::thread::hardware_concurrency());
  command->add_option("CAMPAIGN", options->campaign, "campaign folder")->required();
  command->add_option("--model", options->request.model, "model file, or the name of a shipped model")->required();
  options->output.add_to(*command, "folder for estimate.json and report.html");
  command
      ->add_option("--case", options->request.resonances,
                   "resonance case, may be given several times; chosen from the records without it")
      ->allow_extra_args(false);
  command->add_option("--bootstrap", options->request.bootstrap, "resamples of the conditions, for intervals")
      ->check(CLI::Range(0, 100000));
  command->add_option("--seed", options->request.seed, "of the bootstrap");
  command->add_flag("--refine", options->request.refine,
                    "maximum likelihood with errors in amplitudes, phases, forces and frequencies");
  command
      ->add_option(
          "--by", options->by,
          "full-equations: of motion, all kinds of records in one likelihood (sweeps, broadband records and "
          "impacts need them, and choose them); modulation-equations: of the resonance cases, dwells and "
          "free decays alone; both-equations: free decays by the modulation equations, refined by those of motion "
          "where "
          "these hold all along them")
      ->check(one_of({"full-equations", "modulation-equations", "both-equations"}))
      ->option_text("full-equations|modulation-equations|both-equations");
  options->selection.add_to(*command);
  command->add_option(
      "--fix", options->fixed,
      "NAME=VALUE: a symbol of the model that is known, in every case. CASE:NAME=VALUE: a lump of one case that "
      "is known; what its name stands for differs from case to case");
  command->add_flag("--interpret", options->request.interpret, "no compiled code: slower, same results");
  command->add_option("--threads", options->request.threads, "threads; the result does not depend on it")
      ->check(CLI::Range(1U, 1024U));
  command->add_flag("--timings", options->timings, "wall time of every stage, on standard error");
  command->add_flag("--json", options->json, "print estimate.json instead of the summary");
  command->footer("Example: secular identify campaign --model two_mass_mode1 -o results");
  command->callback([options, command, &chosen] {
    chosen = [options, command] {
      parse_fixed(*options);
      if (!options->by.empty()) options->request.by = equations_named(options->by);
      options->output.check(
          {{"the campaign", options->campaign, true}, {"the model", options->request.model, false}});
      options->request.window = options->selection.window();
      return run(*options, command_line_of(*command));
    };
  });
}

}  // namespace secular::app

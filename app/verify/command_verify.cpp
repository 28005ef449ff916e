#include <fmt/format.h>

#include <CLI/App.hpp>
#include <algorithm>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "app/shared/commands.hpp"
#include "app/shared/output_target.hpp"
#include "app/shared/progress_line.hpp"
#include "app/verify/errata_page.hpp"
#include "jobs/shared/shipped_models.hpp"
#include "perturb/model.hpp"
#include "thesis/verify/verification.hpp"

namespace secular::app {
namespace {

using verify::Verdict;

std::string verdict_table(const verify::PrintedSource& source, const std::vector<Verdict>& verdicts) {
  std::string text = source.source + "\n\n";
  std::size_t unexpected = 0;
  std::map<std::string, int> count;
  for (const Verdict& v : verdicts) {
    ++count[v.verdict];
    text += fmt::format("{:<10} {:<10} {}{}\n", v.equation, v.verdict, v.part.empty() ? v.kind : v.part,
                        v.as_recorded() ? "" : fmt::format("   NOT AS RECORDED ({})", v.recorded));
    if (!v.reason.empty()) text += fmt::format("{:21}{}\n", "", v.reason);
    if (!v.corrected.empty() && v.term_printed != v.printed && !v.term_printed.empty())
      text += fmt::format("{:21}printed: {}\n{:21}right:   {}\n", "", v.term_printed, "", v.term_right);
    else if (!v.corrected.empty())
      text += fmt::format("{:21}right: {}\n", "", v.corrected);
    if (!v.evidence.empty()) text += fmt::format("{:21}evidence: {}\n", "", v.evidence);
    if (!v.proof.empty()) text += fmt::format("{:21}{}{}\n", "", v.proof, v.proved ? "" : "   DOES NOT DECIDE");
    if (!v.remark.empty()) text += fmt::format("{:21}remark: {}\n", "", v.remark);
    if (!v.as_recorded()) ++unexpected;
  }
  text += "\n";
  for (const auto& [verdict, number] : count) text += fmt::format("{} {}, ", number, verdict);
  text += unexpected == 0 ? "every verdict as recorded\n" : fmt::format("{} NOT AS RECORDED\n", unexpected);
  return text;
}

std::string verdict_json(const verify::PrintedSource& source, const std::vector<Verdict>& verdicts) {
  nlohmann::ordered_json result;
  result["source"] = source.source;
  result["as_recorded"] =
      std::all_of(verdicts.begin(), verdicts.end(), [](const Verdict& v) { return v.as_recorded(); });
  result["verdicts"] = nlohmann::ordered_json::array();
  for (const Verdict& v : verdicts) {
    nlohmann::ordered_json entry{{"equation", v.equation}, {"part", v.part},
                                 {"kind", v.kind},         {"verdict", v.verdict},
                                 {"recorded", v.recorded}, {"as_recorded", v.as_recorded()}};
    if (!v.printed.empty()) entry["printed"] = v.printed;
    if (!v.reason.empty()) entry["reason"] = v.reason;
    if (!v.corrected.empty()) {
      entry["corrected"] = v.corrected;
      entry["term"] = {{"printed", v.term_printed}, {"right", v.term_right}};
    }
    if (!v.evidence.empty()) entry["evidence"] = v.evidence;
    if (!v.proof.empty()) {
      entry["proof"] = v.proof;
      entry["proved"] = v.proved;
    }
    if (!v.remark.empty()) entry["remark"] = v.remark;
    result["verdicts"].push_back(std::move(entry));
  }
  return result.dump(2) + "\n";
}

}  // namespace

void add_verify_command(CLI::App* command, Action& chosen) {
  struct Options {
    std::string source = "thesis";
    OutputFile output;
    bool json = false, errata = false, without_proofs = false;
  };
  auto options = std::make_shared<Options>();
  command->add_option("--source", options->source, "thesis, or a file of printed statements")
      ->capture_default_str();
  command->add_flag(
      "--without-proofs", options->without_proofs,
      "leave out the integration of the full equations, which decides a second time what a motion can show");
  CLI::Option* json = command->add_flag("--json", options->json, "machine-readable verdicts");
  command->add_flag("--errata", options->errata, "a page of errata with the evidence for each, in Markdown")
      ->excludes(json);
  options->output.add_to(*command);
  command->footer(
      "Exit status 1 if a verdict is not the recorded one, or a proof does not decide for the corrected form.\n"
      "Examples: secular verify\n"
      "          secular verify --errata -o errata.md");
  command->callback([options, &chosen] {
    chosen = [options] {
      options->output.check({{"the source", options->source, false}});
      const std::string name = options->source == "thesis" ? "printed/fahey2000" : options->source;
      const verify::PrintedSource source = verify::read_printed_source(resolve_model(name));
      ProgressLine line("statements");
      verify::VerificationSettings settings;
      settings.proofs = !options->without_proofs;
      settings.progress = [&line](std::size_t done, std::size_t total) { line(done, total); };
      const std::vector<Verdict> verdicts = verify::verify_source(
          source, [](const std::string& model) { return read_model(resolve_model(model)); }, settings);
      const std::string text = options->json     ? verdict_json(source, verdicts)
                               : options->errata ? errata_page(source, verdicts, settings.proofs)
                                                 : verdict_table(source, verdicts);
      options->output.write(text);
      return std::all_of(verdicts.begin(), verdicts.end(), [](const Verdict& v) { return v.as_recorded(); }) ? 0
                                                                                                             : 1;
    };
  });
}

}  // namespace secular::app

#include "blind/measured_page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <system_error>

#include "blind/measured_score.hpp"
#include "blind/sealed_files.hpp"
#include "input/input_error.hpp"

namespace secular::blind {
namespace {

using nlohmann::json;
using nlohmann::ordered_json;
using Outcome = MeasuredResult::Outcome;

// For a shell in which DATA is set.
std::string command_text(const std::vector<std::string>& arguments) {
  std::string text = "secular";
  for (const std::string& argument : arguments)
    text += argument.find_first_of(" ()*&;<>|$") == std::string::npos || argument.starts_with("$DATA/")
                ? " " + argument
                : " '" + argument + "'";
  return text;
}

// Of a channel: rms before and after in the channel's unit, as simulated from `part` of the diagnosis.
ordered_json errors_of(const json& diagnosis, const char* part, const MeasuredResult& result) {
  ordered_json list = ordered_json::array();
  for (const json& e : diagnosis.value("simulated", json::object()).value(part, json::array())) {
    const auto unit = result.units.find(e.at("channel").get<std::string>());
    list.push_back({{"channel", e.at("channel")},
                    {"unit", unit == result.units.end() ? "" : unit->second},
                    {"signal_rms", e.at("signal_rms")},
                    {"before_rms", e.at("before_rms")},
                    {"after_rms", e.at("after_rms")}});
  }
  return list;
}

ordered_json said_json(const MeasuredResult& result) {
  const json& d = result.diagnosis;
  std::vector<std::string> kinds;
  for (const json& found : d.value("disturbances", json::array()))
    if (const std::string kind = found.at("kind"); std::find(kinds.begin(), kinds.end(), kind) == kinds.end())
      kinds.push_back(kind);
  const json& gap = d.at("gap");
  ordered_json said = {{"verdict", d.at("verdict")},
                       {"cause", d.value("cause", json())},
                       {"set", d.value("set", json::array())},
                       {"together", d.value("together", json::array())},
                       {"second_or", d.value("second_or", json::array())},
                       {"unknown_because", d.value("unknown_because", "")},
                       {"before", gap.at("before")},
                       {"after", gap.at("after")},
                       {"detected", gap.at("detected")},
                       {"closed", gap.at("closed")},
                       {"closed_ci95", gap.at("closed_ci95")},
                       {"errors_in_segments", errors_of(d, "segments", result)},
                       {"errors_held_out", errors_of(d, "check", result)},
                       {"data_used", d.at("data_used")},
                       {"disturbances", kinds},
                       {"left_out", records_left_out(d)}};
  return said;
}

std::string joined(const ordered_json& names, const std::string& between) {
  return fmt::format("{}", fmt::join(names.get<std::vector<std::string>>(), between));
}

// A cell of a table: no bars, no line breaks.
std::string cell(std::string text) {
  for (std::size_t at = 0; (at = text.find_first_of("|\n", at)) != std::string::npos; at += 2)
    text.replace(at, 1, text[at] == '|' ? "\\|" : "  ");
  return text;
}

std::string said_text(const ordered_json& row) {
  if (row.at("outcome") == "refused") return "refused: " + row.at("reason").get<std::string>();
  if (row.at("outcome") == "failed") return "failed: " + row.at("reason").get<std::string>();
  const ordered_json& said = row.at("said");
  const std::string verdict = said.at("verdict");
  if (verdict == "no_gap") return "no gap";
  std::string text = verdict + ": ";
  if (verdict == "cause")
    text += said.at("cause").get<std::string>();
  else if (verdict == "unknown")
    text = "unknown" + (said.at("set").empty() ? "" : ", nearest " + joined(said.at("set"), ", "));
  else
    text += joined(said.at("set"), " or ");
  if (!said.at("together").empty()) text += "; together " + joined(said.at("together"), " and ");
  if (!said.at("second_or").empty()) text += " (or " + joined(said.at("second_or"), " or ") + ")";
  return text;
}

std::string closed_text(const ordered_json& said) {
  if (!said.at("detected").get<bool>()) return "";
  return fmt::format("{:.1f} % [{:.0f}, {:.0f}]", 100 * said.at("closed").get<double>(),
                     100 * said.at("closed_ci95").at(0).get<double>(),
                     100 * said.at("closed_ci95").at(1).get<double>());
}

std::string errors_text(const ordered_json& errors) {
  std::string text;
  for (const ordered_json& e : errors)
    text += fmt::format("{}{:.3g}, {:.3g} {}", text.empty() ? "" : "; ", e.at("before_rms").get<double>(),
                        e.at("after_rms").get<double>(), e.at("unit").get<std::string>());
  return text;
}

bool names_nothing(const ordered_json& row) {
  const std::string verdict = row.at("said").at("verdict");
  return verdict == "unknown" || verdict == "no_gap";
}

std::string judgement(const ordered_json& row) {
  if (!row.at("met").get<bool>()) return "**missed**";
  return names_nothing(row) ? "met, nothing named" : "met";
}

std::string table_row(const ordered_json& row) {
  const bool diagnosed = row.at("outcome") == "diagnosed";
  const ordered_json& said = row.at("said");
  return fmt::format("| [{0}](#{0}) | {1} | {2} | {3} | {4} | {5} | {6:.0f} | {7} |\n",
                     row.at("name").get<std::string>(), cell(said_text(row)), diagnosed ? closed_text(said) : "",
                     diagnosed ? errors_text(said.at("errors_in_segments")) : "",
                     diagnosed ? errors_text(said.at("errors_held_out")) : "",
                     diagnosed ? fmt::format("{:.1f} %", 100 * said.at("data_used").get<double>()) : "",
                     row.at("seconds").get<double>(), judgement(row));
}

std::string section(const ordered_json& row) {
  std::string text = fmt::format("\n### {}\n\n{}. {}\n\n```sh\n", row.at("name").get<std::string>(),
                                 row.at("title").get<std::string>(), row.at("known").get<std::string>());
  for (const ordered_json& command : row.at("commands")) text += command.get<std::string>() + "\n";
  text += fmt::format("```\n\n- aim: {}\n- said: {}\n", row.at("aim").get<std::string>(), said_text(row));
  if (row.at("outcome") == "diagnosed") {
    const ordered_json& said = row.at("said");
    if (const std::string why = said.at("unknown_because"); !why.empty()) text += "- unknown because " + why + "\n";
    text += fmt::format("- gap: {:.3g} times the repeatability", said.at("before").get<double>());
    if (said.at("detected").get<bool>()) text += fmt::format(", {:.3g} after", said.at("after").get<double>());
    text += "\n";
    if (!said.at("disturbances").empty()) text += "- disturbances: " + joined(said.at("disturbances"), ", ") + "\n";
    if (!said.at("left_out").empty()) text += "- left out: " + joined(said.at("left_out"), ", ") + "\n";
  }
  return text + (row.at("met").get<bool>() ? "- **met**\n"
                                           : fmt::format("- **missed**: {}\n", joined(row.at("missed"), "; ")));
}

std::string head_text(const ordered_json& page) {
  std::size_t met = 0, silent = 0;
  std::vector<std::string> missed_names;
  for (const ordered_json& row : page.at("sets")) {
    if (!row.at("met").get<bool>()) {
      missed_names.push_back(row.at("name"));
      continue;
    }
    ++met;
    if (names_nothing(row)) ++silent;
  }
  std::string text = fmt::format(
      "# Measured records\n\nWhat the program says of records that nobody on this project made, beside what is "
      "known "
      "of them. Made by\n\n```sh\n{}\n```\n\nfrom the list `{}`, which says what would be right of each set; no "
      "result is written by hand. `DATA` below is `{}`.\n\n",
      page.at("command").get<std::string>(), page.at("list").get<std::string>(),
      page.at("data").get<std::string>());
  text +=
      "Named is what a verdict other than `unknown` says acts ([the "
      "verdicts](reading_a_diagnosis.md#which-effect-is-"
      "it)); what is nearest to an unknown cause is not. Closed is the share of the gap on conditions held out of "
      "the "
      "fit, with its 95 % interval. Errors are root mean squares of measured minus simulated, before and after the "
      "best explanation: in segments with a state of each segment's own, which the fit has seen, and held out over "
      "the window of `--check-from` and `--check-to`, in one piece, where a set has one. Time is wall time of both "
      "commands beside whatever else the machine did; everything else comes out the same again. Where several "
      "modes "
      "ring, `--band` runs from three quarters to five quarters of the mode's known frequency.\n\n";
  text += fmt::format(
      "**{} of {} sets meet their aim**: {} with the right name, {} where nothing wrong is named, and nothing "
      "right.",
      met, page.at("sets").size(), met - silent, silent);
  if (!missed_names.empty()) text += fmt::format(" Missed: {}.", fmt::join(missed_names, ", "));
  return text + "\n\n";
}

}  // namespace

ordered_json measured_json(const MeasuredPageHead& head, const MeasuredList& list,
                           const std::vector<MeasuredResult>& results) {
  ordered_json rows = ordered_json::array();
  for (std::size_t i = 0; i < list.sets.size(); ++i) {
    const MeasuredSet& set = list.sets[i];
    const MeasuredResult& result = results.at(i);
    const std::vector<std::string> misses = missed(i, list, results);
    const MeasuredCommands commands = commands_of(set, list.folder, "$DATA", head.work / set.name);
    rows.push_back({{"name", set.name},
                    {"title", set.title},
                    {"known", set.known},
                    {"commands", {command_text(commands.import), command_text(commands.diagnose)}},
                    {"aim", aim_text(set)},
                    {"outcome", result.outcome},
                    {"reason", result.reason},
                    {"said", result.outcome == Outcome::diagnosed ? said_json(result) : ordered_json()},
                    {"met", misses.empty()},
                    {"missed", misses},
                    {"seconds", result.seconds}});
  }
  return {{"schema", 1},
          {"command", head.command},
          {"list", head.list.string()},
          {"data", head.data.string()},
          {"sets", rows}};
}

std::string measured_markdown(const ordered_json& page) {
  std::string text = head_text(page);
  text +=
      "| set | said | closed | error in segments: before, after | held out: before, after | data used | wall time, "
      "s "
      "| aim |\n|---|---|---|---|---|---|---|---|\n";
  for (const ordered_json& row : page.at("sets")) text += table_row(row);
  text += "\n## The sets\n";
  for (const ordered_json& row : page.at("sets")) text += section(row);
  return text;
}

void write_measured(const ordered_json& page, const std::filesystem::path& folder) {
  make_folder(folder);
  write_text(folder / "measured.json", page.dump(1) + "\n");
  write_text(folder / "measured.md", measured_markdown(page));
}

}  // namespace secular::blind

#include "blind/measured_score.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <optional>
#include <string_view>

namespace secular::blind {
namespace {

using nlohmann::json;
using Outcome = MeasuredResult::Outcome;

bool holds(const std::vector<std::string>& list, const std::string& name) {
  return std::find(list.begin(), list.end(), name) != list.end();
}

bool lists_disturbance(const json& diagnosis, const std::string& kind) {
  const json found = diagnosis.value("disturbances", json::array());
  return std::any_of(found.begin(), found.end(), [&](const json& d) { return d.at("kind") == kind; });
}

// The first effect of a verdict; empty where it has none.
std::string leading_effect(const json& diagnosis) {
  const json set = diagnosis.value("set", json::array());
  return set.empty() ? "" : set.front().get<std::string>();
}

std::optional<std::string> other_verdict(const json& diagnosis, const std::string& name, const MeasuredList& list,
                                         const std::vector<MeasuredResult>& results) {
  for (std::size_t i = 0; i < list.sets.size(); ++i) {
    if (list.sets[i].name != name) continue;
    const json& other = results[i].diagnosis;
    const bool same = results[i].outcome == Outcome::diagnosed && other.at("verdict") == diagnosis.at("verdict") &&
                      leading_effect(other) == leading_effect(diagnosis);
    return same ? std::nullopt : std::optional("not the verdict of " + name);
  }
  return name + " was not run";
}

std::vector<std::string> missed_of(const Aim& aim, const json& diagnosis, const MeasuredList& list,
                                   const std::vector<MeasuredResult>& results) {
  std::vector<std::string> phrases;
  const std::vector<std::string> named = named_effects(diagnosis);
  const std::string verdict = diagnosis.at("verdict");
  for (const std::vector<std::string>& any : aim.named)
    if (std::none_of(any.begin(), any.end(), [&](const std::string& effect) { return holds(named, effect); }))
      phrases.push_back(fmt::format("{} not named", fmt::join(any, " or ")));
  for (const std::string& effect : aim.never_named)
    if (holds(named, effect)) phrases.push_back(effect + " named");
  if (!aim.verdicts.empty() && !holds(aim.verdicts, verdict)) phrases.push_back("verdict " + verdict);
  if (!aim.same_verdict_as.empty())
    if (const auto phrase = other_verdict(diagnosis, aim.same_verdict_as, list, results))
      phrases.push_back(*phrase);
  if (aim.closed_at_least && !(diagnosis.at("gap").at("closed").get<double>() >= *aim.closed_at_least))
    phrases.push_back(fmt::format("less than {:.0f} % closed", 100 * *aim.closed_at_least));
  for (const std::string& kind : aim.disturbances)
    if (!lists_disturbance(diagnosis, kind)) phrases.push_back(kind + " not listed as a disturbance");
  if (aim.every_record)
    for (const std::string& record : records_left_out(diagnosis)) phrases.push_back(record + " left out");
  return phrases;
}

std::string text_of(const Aim& aim) {
  std::vector<std::string> parts;
  if (!aim.verdicts.empty()) parts.push_back(fmt::format("verdict {}", fmt::join(aim.verdicts, " or ")));
  if (!aim.named.empty()) {
    std::vector<std::string> each;
    for (const std::vector<std::string>& any : aim.named) each.push_back(fmt::format("{}", fmt::join(any, " or ")));
    parts.push_back(fmt::format("named: {}", fmt::join(each, ", with ")));
  }
  if (!aim.same_verdict_as.empty()) parts.push_back("the verdict of " + aim.same_verdict_as);
  if (aim.closed_at_least) parts.push_back(fmt::format("at least {:.0f} % closed", 100 * *aim.closed_at_least));
  if (!aim.disturbances.empty())
    parts.push_back(fmt::format("listed as a disturbance: {}", fmt::join(aim.disturbances, ", ")));
  if (aim.every_record) parts.push_back("no record left out");
  if (!aim.never_named.empty()) parts.push_back(fmt::format("not named: {}", fmt::join(aim.never_named, ", ")));
  return fmt::format("{}", fmt::join(parts, "; "));
}

}  // namespace

std::vector<std::string> named_effects(const json& diagnosis) {
  std::vector<std::string> named;
  const std::string verdict = diagnosis.at("verdict");
  if (verdict == "unknown" || verdict == "no_gap") return named;
  const auto add = [&](const std::string& effect) {
    if (!holds(named, effect)) named.push_back(effect);
  };
  if (const json cause = diagnosis.value("cause", json()); cause.is_string()) add(cause);
  for (const char* list : {"set", "together", "second_or"})
    for (const json& effect : diagnosis.value(list, json::array())) add(effect);
  return named;
}

std::vector<std::string> records_left_out(const json& diagnosis) {
  std::vector<std::string> records;
  for (const std::string text : diagnosis.value("warnings", json::array()))
    if (std::string_view(text).ends_with(", left out"))
      records.push_back(text.substr(0, text.find(": ")));
    else if (text.starts_with("left out "))
      records.push_back(text.substr(text.find(": ") + 2));
  return records;
}

std::vector<std::string> missed(std::size_t set, const MeasuredList& list,
                                const std::vector<MeasuredResult>& results) {
  const MeasuredResult& result = results.at(set);
  if (result.outcome != Outcome::diagnosed) return {"no diagnosis"};
  std::optional<std::vector<std::string>> fewest;
  for (const Aim& aim : list.sets.at(set).aims) {
    std::vector<std::string> phrases = missed_of(aim, result.diagnosis, list, results);
    if (!fewest || phrases.size() < fewest->size()) fewest = std::move(phrases);
  }
  return fewest.value();
}

std::string aim_text(const MeasuredSet& set) {
  std::vector<std::string> texts;
  for (const Aim& aim : set.aims) texts.push_back(text_of(aim));
  return fmt::format("{}", fmt::join(texts, "; or "));
}

}  // namespace secular::blind

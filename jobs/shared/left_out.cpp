#include "jobs/shared/left_out.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <string_view>

#include "estimator/identification/short_list.hpp"

namespace secular {
namespace {

constexpr std::string_view ending = ", left out";

// "FILE: text" about a record.
struct About {
  std::size_t record = 0;
  std::string text, kind;  // kind: the text without its numbers
};

std::optional<About> about_record(const std::string& warning, const Campaign& campaign) {
  for (std::size_t r = 0; r < campaign.records.size(); ++r) {
    const std::string start = campaign.records[r].file + ": ";
    if (!warning.starts_with(start)) continue;
    About about{r, warning.substr(start.size()), {}};
    for (const char c : about.text)
      if (std::string_view("0123456789.+-e").find(c) == std::string_view::npos) about.kind += c;
    return about;
  }
  return std::nullopt;
}

}  // namespace

std::vector<std::string> folded(const std::vector<std::string>& warnings, const Campaign& campaign) {
  struct Kind {
    std::vector<About> members;
    std::vector<std::string> files;
    bool alike = true;
  };
  std::map<std::string, Kind> kinds;
  for (const std::string& warning : warnings)
    if (const auto about = about_record(warning, campaign)) {
      Kind& kind = kinds[about->kind];
      kind.members.push_back(*about);
      kind.files.push_back(campaign.records[about->record].file);
      kind.alike = kind.alike && about->text == kind.members.front().text;
    }
  std::vector<std::string> result;
  for (const std::string& warning : warnings) {
    const auto about = about_record(warning, campaign);
    if (!about || kinds[about->kind].members.size() == 1) {
      result.push_back(warning);
      continue;
    }
    Kind& kind = kinds[about->kind];
    if (!kind.files.empty())
      result.push_back(fmt::format("{} times ({}): {}{}", kind.files.size(), short_list(kind.files), about->text,
                                   kind.alike ? "" : " (numbers of the first)"));
    kind.files.clear();
  }
  return result;
}

std::optional<std::string> mostly_left_out(const std::vector<std::string>& warnings, const Campaign& campaign,
                                           const std::set<std::size_t>& given, const std::set<std::size_t>& used) {
  std::map<std::string, std::set<std::size_t>> kinds;
  std::map<std::string, std::string> texts;
  std::set<std::size_t> dropped;
  for (const std::string& warning : warnings) {
    const auto about = about_record(warning, campaign);
    if (!about || !about->text.ends_with(ending) || !given.contains(about->record) || used.contains(about->record))
      continue;
    dropped.insert(about->record);
    kinds[about->kind].insert(about->record);
    texts.emplace(about->kind, about->text.substr(0, about->text.size() - ending.size()));
  }
  if (2 * dropped.size() <= given.size()) return std::nullopt;
  const auto common = std::max_element(
      kinds.begin(), kinds.end(), [](const auto& a, const auto& b) { return a.second.size() < b.second.size(); });
  return fmt::format("{} of {} records are left out; {} of them as {}: {}", dropped.size(), given.size(),
                     common->second.size(), campaign.records[*common->second.begin()].file, texts[common->first]);
}

}  // namespace secular

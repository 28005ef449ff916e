#include "blind/measured_sets.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <sstream>

#include "input/input_error.hpp"
#include "input/toml_table.hpp"

namespace secular::blind {
namespace {

namespace fs = std::filesystem;

// Half the width of the band about a mode that is one of several, as a share of its frequency: well below the
// factor of two to the next mode of a beam, well above what amplitudes shift a mode by. A choice, one for all sets.
constexpr double band_share = 0.25;

std::vector<std::string> words(const TomlTable& table, std::string_view key) {
  const std::string text = table.string_or(key, "");
  if (text.find_first_of("'\"\\") != std::string::npos)
    table.fail(key, "holds quotes", "arguments without blanks, separated by blanks");
  std::istringstream stream(text);
  std::vector<std::string> result;
  for (std::string word; stream >> word;) result.push_back(word);
  return result;
}

std::vector<std::string> strings_or_none(const TomlTable& table, std::string_view key) {
  return table.has(key) ? table.strings(key) : std::vector<std::string>{};
}

std::vector<std::string> alternatives(const std::string& text) {
  constexpr std::string_view between = " or ";
  std::vector<std::string> result;
  std::size_t begin = 0;
  for (std::size_t end; (end = text.find(between, begin)) != std::string::npos; begin = end + between.size())
    result.push_back(text.substr(begin, end - begin));
  result.push_back(text.substr(begin));
  return result;
}

Aim read_aim(const TomlTable& table) {
  table.refuse_unknown_keys(
      {"named", "never_named", "verdicts", "same_verdict_as", "closed_at_least", "disturbances", "every_record"});
  if (table.keys().empty()) table.fail("", "an aim without a condition", "named, verdicts or another condition");
  Aim aim;
  for (const std::string& text : strings_or_none(table, "named")) aim.named.push_back(alternatives(text));
  aim.never_named = strings_or_none(table, "never_named");
  aim.verdicts = strings_or_none(table, "verdicts");
  for (const std::string& verdict : aim.verdicts)
    if (!std::set<std::string>{"no_gap", "cause", "set", "approximate", "unknown"}.contains(verdict))
      table.fail("verdicts", "there is no verdict " + verdict, "no_gap, cause, set, approximate, unknown");
  aim.same_verdict_as = table.string_or("same_verdict_as", "");
  aim.closed_at_least = table.optional_number("closed_at_least");
  aim.disturbances = strings_or_none(table, "disturbances");
  aim.every_record = table.boolean_or("every_record", false);
  return aim;
}

MeasuredSet read_set(const TomlTable& table) {
  table.refuse_unknown_keys({"name", "title", "files", "import", "model", "diagnose", "mode_hz", "known", "aim"});
  MeasuredSet set;
  set.name = table.string("name");
  if (set.name.empty() || set.name.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789_") != std::string::npos)
    table.fail("name", "is no name of a folder", "lower case letters, digits and _");
  set.title = table.string("title");
  set.known = table.string("known");
  set.files = table.strings("files");
  if (set.files.empty()) table.fail("files", "names no file");
  set.import = words(table, "import");
  set.model = table.string("model");
  set.model_is_data = set.model.has_parent_path();
  set.diagnose = words(table, "diagnose");
  if (const std::optional<double> mode = table.optional_number("mode_hz")) {
    if (!(*mode > 0)) table.fail("mode_hz", "is no frequency", "more than 0");
    set.diagnose.insert(set.diagnose.end(), {"--band", fmt::format("{:.6g}:{:.6g}", (1 - band_share) * *mode,
                                                                   (1 + band_share) * *mode)});
  }
  for (const TomlTable& aim : table.tables("aim")) set.aims.push_back(read_aim(aim));
  if (set.aims.empty()) table.fail("name", "has no aim", "[[set.aim]]");
  return set;
}

}  // namespace

MeasuredList read_measured_list(const fs::path& file) {
  const TomlTable table = TomlTable::from_file(file);
  table.refuse_unknown_keys({"schema", "set"});
  if (table.integer("schema") != 1) table.fail("schema", "is not known", "1");
  MeasuredList list{file.parent_path(), {}};
  std::set<std::string> names;
  const std::vector<TomlTable> tables = table.tables("set");
  for (const TomlTable& entry : tables) {
    list.sets.push_back(read_set(entry));
    if (!names.insert(list.sets.back().name).second) entry.fail("name", "is the name of another set as well");
  }
  for (std::size_t i = 0; i < tables.size(); ++i)
    for (const Aim& aim : list.sets[i].aims)
      if (!aim.same_verdict_as.empty() && !names.contains(aim.same_verdict_as))
        tables[i].fail("aim", fmt::format("there is no set {} to compare with", aim.same_verdict_as));
  return list;
}

MeasuredList only_sets(MeasuredList list, const std::vector<std::string>& names) {
  if (names.empty()) return list;
  MeasuredList chosen{list.folder, {}};
  for (const std::string& name : names)
    if (std::none_of(list.sets.begin(), list.sets.end(), [&](const MeasuredSet& s) { return s.name == name; })) {
      std::vector<std::string> known;
      for (const MeasuredSet& s : list.sets) known.push_back(s.name);
      throw InputError("--only", "", "there is no set " + name, fmt::format("{}", fmt::join(known, ", ")));
    }
  for (MeasuredSet& set : list.sets)
    if (std::find(names.begin(), names.end(), set.name) != names.end()) chosen.sets.push_back(std::move(set));
  return chosen;
}

void require_data(const MeasuredList& list, const fs::path& data) {
  std::set<std::string> missing;
  for (const MeasuredSet& set : list.sets) {
    for (const std::string& file : set.files)
      if (!fs::exists(data / file)) missing.insert((data / file).string());
    const fs::path model = (set.model_is_data ? data : list.folder) / set.model;
    if (!fs::exists(model)) missing.insert(model.string());
  }
  if (!missing.empty())
    throw InputError(data.string(), "", fmt::format("these files are missing: {}", fmt::join(missing, ", ")),
                     "the folder of the measured data, or --only with sets that are there");
}

}  // namespace secular::blind

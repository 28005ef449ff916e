#include "jobs/inspect/proposed_import.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <vector>

#include "measure/data/campaign.hpp"
#include "measure/data/frequency_names.hpp"
#include "measure/data/names.hpp"
#include "measure/formats/channel_name.hpp"
#include "measure/formats/data_file.hpp"
#include "measure/formats/matrix_lines.hpp"
#include "measure/formats/number_table.hpp"
#include "measure/formats/uff_frf.hpp"
#include "measure/formats/unit.hpp"

namespace secular {
namespace {

constexpr std::size_t most_named = 24;  // more channels make no line that can be read

std::size_t samples_of(const VariableInspection& variable) {
  std::size_t count = 1;
  for (const std::size_t length : variable.shape) count *= length;
  return count;
}

// For a shell.
std::string quoted(const std::string& text) {
  if (text.find_first_of(" ()[]{}<>*?$&|;!#~`\"\\'") == std::string::npos) return text;
  std::string inside;
  for (const char c : text) inside += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return "'" + inside + "'";
}

struct Numbered {
  std::string pattern;  // run(*).tip
  int number = 0;
};

// The first number in brackets of a name that stands for one of several: run(2).tip, records{2}.tip.
std::optional<Numbered> numbered_name(const std::string& name) {
  for (const auto& [open, close] : {std::pair('(', ')'), std::pair('{', '}')}) {
    const std::size_t begin = name.find(open), end = name.find(close, begin);
    if (end == std::string::npos || end == begin + 1 || end - begin > 6) continue;
    const std::string digits = name.substr(begin + 1, end - begin - 1);
    if (digits.find_first_not_of("0123456789") != std::string::npos) continue;
    return Numbered{name.substr(0, begin + 1) + "*" + name.substr(end), std::stoi(digits)};
  }
  return std::nullopt;
}

// Names that several numbers share are one name with a "*": each number is a record.
class RecordPatterns {
 public:
  explicit RecordPatterns(const FileInspection& file) {
    for (const VariableInspection& variable : file.variables)
      if (const auto numbered = numbered_name(variable.name)) numbers_[numbered->pattern].insert(numbered->number);
  }
  std::string of(const std::string& name) const {
    const auto numbered = numbered_name(name);
    return numbered && numbers_.at(numbered->pattern).size() > 1 ? numbered->pattern : name;
  }

 private:
  std::map<std::string, std::set<int>> numbers_;
};

// "tip" of run(*).tip (m/s^2), "data2" of data(:,2), "Signal_1" of the first part of Signal_1.y.values.
std::string short_name(const std::string& variable, bool first_part) {
  std::string name = variable, line;
  if (is_matrix_line(name)) {
    for (const char c : name.substr(name.rfind('(')))
      if (c >= '0' && c <= '9') line += c;
    name.resize(name.rfind('('));
  } else {
    name = bracketed_unit(name).name;
  }
  const std::size_t point = first_part ? name.find('.') : name.rfind('.');
  if (point != std::string::npos && point > 0 && point + 1 < name.size())
    name = first_part ? name.substr(0, point) : name.substr(point + 1);
  if (const std::size_t bracket = name.find_first_of("({"); bracket != std::string::npos && bracket > 0)
    name.resize(bracket);
  return name + line;
}

// What channels may be called: the last part of their variables' names, else the first, else numbers.
std::vector<std::string> short_names(const std::vector<std::string>& variables) {
  for (const bool first_part : {false, true}) {
    std::vector<std::string> names;
    for (const std::string& variable : variables) names.push_back(short_name(variable, first_part));
    const std::set<std::string> different(names.begin(), names.end());
    const bool usable = std::all_of(names.begin(), names.end(), [](const std::string& name) {
      return channel_name_fault(name).empty() && name.find('=') == std::string::npos;
    });
    if (usable && different.size() == names.size()) return names;
  }
  std::vector<std::string> names;
  for (std::size_t c = 1; c <= variables.size(); ++c) names.push_back(fmt::format("channel{}", c));
  return names;
}

std::string unit_part(const VariableInspection& variable, const FileInspection& file) {
  if (!variable.unit.empty()) return "";
  const bool counts = file.format == "WAV" || !other_measure(variable.stated_unit).empty();
  return counts ? ":QUANTITY:UNIT:FACTOR" : ":QUANTITY:UNIT";
}

// 0, 1, 2, ... of a first column without a name.
bool is_row_number(const VariableInspection& variable) {
  const ChannelQuality& q = *variable.quality;
  return !q.noise && q.minimum >= 0 && q.maximum - q.minimum + 1 == static_cast<double>(samples_of(variable));
}

// Channels go with the time, or, without one, are as long as the longest variable.
std::vector<const VariableInspection*> channels_in(const FileInspection& file) {
  std::size_t length = 0;
  for (const VariableInspection& variable : file.variables)
    if (variable.quality && (file.time.empty() || variable.name == file.time))
      length = std::max(length, samples_of(variable));
  std::vector<const VariableInspection*> channels;
  for (const VariableInspection& variable : file.variables)
    if (variable.quality && 2 * variable.quality->missing < length && samples_of(variable) == length &&
        variable.name != file.time && !is_called_time(variable.name) && !holds_word_time(variable.name) &&
        !is_row_number(variable) && !(variable.name.ends_with(".im") || variable.name.ends_with(".re")))
      channels.push_back(&variable);
  return channels;
}

// "--sample-rate 2048" from a number beside the samples that is called a rate or a step.
std::string sample_rate(const FileInspection& file) {
  constexpr std::array<std::string_view, 9> rates = {
      "fs",  "samplerate",  "samplingrate",  "samplefrequency", "samplingfrequency",
      "f_s", "sample_rate", "sampling_rate", "fsample"};
  constexpr std::array<std::string_view, 8> steps = {
      "dt", "ts", "deltat", "increment", "wf_increment", "time_step", "sampleinterval", "samplinginterval"};
  for (const VariableInspection& variable : file.variables) {
    if (!variable.quality || samples_of(variable) != 1 || !(variable.quality->mean > 0)) continue;
    std::string name = variable.name.substr(variable.name.rfind('.') + 1);
    for (char& c : name)
      if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    const double value = variable.quality->mean;
    if (std::find(rates.begin(), rates.end(), name) != rates.end())
      return fmt::format("--sample-rate {:.10g}", value);
    if (std::find(steps.begin(), steps.end(), name) != steps.end())
      return fmt::format("--sample-rate {:.10g}", 1 / value);
  }
  return "--sample-rate HZ";
}

// "run(2).freq", "Frequency [Hz]", "omega": may hold the frequencies of a table.
bool may_be_frequency(const std::string& variable) {
  std::string name = bracketed_unit(variable).name;
  name = name.substr(name.rfind('.') + 1);
  return is_frequency_name(name) || name == "omega" || name == "Omega";
}

// The first column whose unit is that of a frequency, whatever it is called ("Frequenz"); empty where none is.
std::string column_in_hertz(const FileInspection& file) {
  for (const VariableInspection& variable : file.variables)
    if (variable.quality && other_measure(variable.stated_unit) == "frequency" && samples_of(variable) > 1)
      return variable.name;
  return {};
}

// Whether a column of a table of lines is the phase of another one.
bool may_be_phase(const VariableInspection& variable) {
  std::string name = variable.name;
  std::transform(name.begin(), name.end(), name.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  return variable.unit == "rad" || name.find("phas") != std::string::npos;
}

// " --channel 'tip=Tip disp [mm]:response' --column 'tip.phase=Phase [deg]'": a phase is that of the channel before
// it.
std::string table_columns(const FileInspection& file, const std::string& frequency) {
  std::vector<const VariableInspection*> channels;
  std::vector<std::string> variables;
  std::map<std::size_t, std::string> phases;
  bool phase_unit_missing = false;
  for (const VariableInspection* variable : channels_in(file)) {
    if (variable->name == frequency) continue;
    if (may_be_phase(*variable) && !channels.empty()) {
      phases[channels.size() - 1] = variable->name;
      phase_unit_missing = phase_unit_missing || variable->unit.empty();
    } else {
      channels.push_back(variable);
      variables.push_back(variable->name);
    }
  }
  const std::vector<std::string> names = short_names(variables);
  std::string text;
  for (std::size_t c = 0; c < std::min(most_named, names.size()); ++c) {
    const bool drives = channels[c]->unit == si_unit(Quantity::force) || (c == 0 && !phases.contains(0));
    text += " --channel " +
            quoted(fmt::format("{}{}:{}{}", names[c] == variables[c] ? "" : names[c] + "=", variables[c],
                               drives ? "excitation" : "response", unit_part(*channels[c], file)));
    if (const auto phase = phases.find(c); phase != phases.end())
      text += " --column " + quoted(fmt::format("{}.phase={}", names[c], phase->second));
  }
  if (!phases.empty()) text += phase_unit_missing ? " --phases DEG_OR_RAD" : "";
  return text;
}

}  // namespace

std::string proposed_import(const std::filesystem::path& path, const FileInspection& file) {
  const RecordPatterns patterns(file);
  // A channel that stands still, as a thermometer beside a test, is no channel of it.
  const auto stands_still = [](const VariableInspection* variable) {
    return variable->quality->maximum == variable->quality->minimum;
  };
  std::vector<const VariableInspection*> channels_shown = channels_in(file);
  if (!std::all_of(channels_shown.begin(), channels_shown.end(), stands_still))
    std::erase_if(channels_shown, stands_still);
  std::vector<std::string> variables;
  std::vector<const VariableInspection*> shown;
  std::set<std::string> seen = {patterns.of(file.time)};
  for (const VariableInspection* variable : channels_shown)
    if (const std::string pattern = patterns.of(variable->name); seen.insert(pattern).second) {
      variables.push_back(pattern);
      shown.push_back(variable);
    }
  if (variables.empty()) return {};
  const std::vector<std::string> names = short_names(variables);
  std::string channels;
  bool unit_missing = false;
  for (std::size_t c = 0; c < std::min(most_named, names.size()); ++c) {
    const std::string unit = unit_part(*shown[c], file);
    unit_missing = unit_missing || !unit.empty();
    const char* const role = shown[c]->unit == si_unit(Quantity::force) ? "excitation" : "response";
    channels += " --channel " + quoted(fmt::format("{}{}:{}{}", names[c] == variables[c] ? "" : names[c] + "=",
                                                   variables[c], role, unit));
  }
  std::string rate = sample_rate(file);
  if (!file.time.empty()) rate = "--time " + quoted(patterns.of(file.time));
  std::string text = fmt::format("secular import {} -o CAMPAIGN --kind KIND{}{}", quoted(path.string()), channels,
                                 file.time == "t" ? "" : " " + rate);
  text += fmt::format("\nKIND is {}; write excitation for response where a channel drives", record_kind_list);
  if (unit_missing) text += "; QUANTITY and UNIT as in acceleration:g or force:N";
  if (names.size() > most_named)
    text += fmt::format("; {} more variables are not named here", names.size() - most_named);
  return text + ".";
}

std::string table_import(const std::filesystem::path& path, const FileInspection& file) {
  std::string frequency, channels;
  bool responses = false;
  for (const VariableInspection& variable : file.variables) {
    if (frequency.empty() && may_be_frequency(variable.name)) frequency = variable.name;
    if (variable.name.ends_with(".re") && variable.type.starts_with(frequency_response)) {
      channels += fmt::format(" --channel {}:response{}", variable.name.substr(0, variable.name.size() - 3),
                              variable.unit.empty() ? ":QUANTITY:UNIT" : "");
      responses = true;
    }
  }
  if (frequency.empty() && file.time.empty()) frequency = column_in_hertz(file);
  if (frequency.empty()) return {};
  if (responses) channels = " --channel NAME:excitation:QUANTITY:UNIT --level LEVEL" + channels;
  if (!responses) channels = table_columns(file, frequency);
  const bool usual = is_frequency_name(bracketed_unit(frequency).name);
  return fmt::format(
      "secular import {} -o CAMPAIGN --kind lines{}{}\nThe excitation is guessed: write response for it, and "
      "excitation "
      "where another channel drives",
      quoted(path.string()), usual ? "" : fmt::format(" --column 'f={}'", frequency), channels);
}

}  // namespace secular

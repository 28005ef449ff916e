#include "measure/data/line_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <numeric>
#include <set>
#include <utility>

#include "input/input_error.hpp"
#include "measure/data/number_range.hpp"
#include "measure/formats/number_table.hpp"
#include "measure/formats/uff_frf.hpp"
#include "measure/formats/unit.hpp"
#include "measure/thresholds.hpp"
#include "numerics/hertz.hpp"

namespace secular {
namespace {

using Complex = std::complex<double>;

/// What may stand between a channel's name and a part of it.
constexpr const char* joints[] = {".", "_", " "};

/// Names of the column of frequencies, where none is given.
constexpr const char* frequency_names[] = {"f", "freq", "frequency", "Freq", "Frequency"};

/// Relative, within which repeats of a setting are the same.
constexpr auto& same_frequency = measure_thresholds().repeat_frequency;
constexpr auto& same_level = measure_thresholds().repeat_level;

/// No line of a higher multiple, and none of a smaller part, is read: a longer number is no line's.
constexpr int largest_multiple = 999;

std::optional<LineNumber> parsed_number(std::string_view text) {
  const auto whole = [](std::string_view digits) -> std::optional<int> {
    int value = 0;
    const auto end = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    if (digits.empty() || end.ec != std::errc() || end.ptr != digits.data() + digits.size() || value < 0 ||
        value > largest_multiple)
      return std::nullopt;
    return value;
  };
  const std::size_t slash = text.find('/');
  const auto over = whole(text.substr(0, slash));
  const auto under = slash == std::string_view::npos ? std::optional(1) : whole(text.substr(slash + 1));
  if (!over || !under || *under == 0) return std::nullopt;
  const int common = std::gcd(*over, *under);
  return LineNumber{*over / common, *under / common};
}

double peak_of(TableConvention::Amplitude amplitude) {
  switch (amplitude) {
    case TableConvention::Amplitude::rms:
      return std::numbers::sqrt2;
    case TableConvention::Amplitude::peak_to_peak:
      return 0.5;
    default:
      return 1;
  }
}

/// Columns of one line of one channel; those that are not there are empty.
struct LineSource {
  std::size_t channel;
  LineNumber number;
  std::string amplitude, phase, real, imaginary, sd, phase_sd;

  bool found() const { return !amplitude.empty() || !real.empty(); }
};

class TableReader {
 public:
  TableReader(const std::filesystem::path& path, const TableRequest& request)
      : path_(path), file_(path.string()), request_(request), variables_(describe_data_file(path)) {
    // A file may say itself that its numbers are frequency response functions.
    per_excitation_ =
        request.convention.per_excitation ||
        std::any_of(variables_.begin(), variables_.end(), [&](const DataVariable& variable) {
          return variable.type.starts_with(frequency_response) &&
                 std::any_of(request.channels.begin(), request.channels.end(), [&](const TableChannel& channel) {
                   return variable.name.starts_with(channel.variable + ".") ||
                          variable.name.starts_with(channel.name + ".");
                 });
        });
  }

  LineTable read() {
    require_one_excitation();
    frequency_ = frequency_column();
    condition_ = named("condition").value_or(look_up(unclaimed({"condition"})).value_or(""));
    for (std::size_t c = 0; c < request_.channels.size(); ++c) find_lines(c);
    for (const auto& [part, variable] : request_.columns)
      if (used_parts_.count(part) == 0)
        throw InputError(file_, "column " + part, "belongs to no channel of the table",
                         "parts are f, condition, and CHANNEL, CHANNEL.phase, .re, .im, .sd, .phase_sd, also of "
                         "CHANNEL@N at N times the excitation's frequency");
    load();
    LineTable table;
    for (std::size_t i = 0; i < rows_; ++i) read_row(i, table);
    require_repeats(table.rows);
    for (const DataVariable& variable : variables_)
      if (taken_.count(variable.name) == 0 && variable.fault.empty()) table.unused.push_back(variable.name);
    if (table.rows.empty())
      throw InputError(file_, "", "has no row that can be used",
                       table.damaged.empty() ? "a row for every settled dwell was expected"
                                             : "its first: " + table.damaged.front());
    return table;
  }

 private:
  void require_one_excitation() {
    std::size_t count = 0;
    for (std::size_t c = 0; c < request_.channels.size(); ++c)
      if (request_.channels[c].role == ChannelRole::excitation) {
        excitation_ = c;
        ++count;
      }
    if (count != 1)
      throw InputError(file_, "", fmt::format("a table of lines with {} excitation channels", count),
                       "exactly one channel with the role excitation was expected: its level is a column of the "
                       "table, or given");
  }

  // The variable that a part was given, if it was.
  std::optional<std::string> named(const std::string& part) {
    const auto given = request_.columns.find(part);
    if (given == request_.columns.end()) return std::nullopt;
    used_parts_.insert(part);
    const auto found = look_up({given->second});
    if (!found)
      throw InputError(file_, "column " + part, fmt::format("there is no variable '{}'", given->second),
                       "its variables are " + names());
    return found;
  }

  std::string names() const {
    std::string list;
    for (std::size_t i = 0; i < std::min<std::size_t>(20, variables_.size()); ++i)
      list += (i ? ", " : "") + variables_[i].name;
    return list + (variables_.size() > 20 ? fmt::format(" and {} more", variables_.size() - 20) : "");
  }

  // The first of these names that is a variable's, with the unit behind it or without.
  std::optional<std::string> look_up(const std::vector<std::string>& candidates) {
    for (const std::string& name : candidates) {
      for (const DataVariable& variable : variables_)
        if (variable.name == name || bracketed_unit(variable.name).name == name) {
          taken_.insert(variable.name);
          return variable.name;
        }
    }
    return std::nullopt;
  }

  static bool contains(const std::vector<std::string>& names, const std::string& name) {
    return std::find(names.begin(), names.end(), name) != names.end();
  }

  bool has_real_part(const std::string& base) const {
    return std::any_of(std::begin(joints), std::end(joints), [&](const char* joint) {
      return std::any_of(variables_.begin(), variables_.end(), [&](const DataVariable& variable) {
        return bracketed_unit(variable.name).name == base + joint + "re";
      });
    });
  }

  // Without those that hold amplitudes of a channel.
  std::vector<std::string> unclaimed(std::vector<std::string> usual) const {
    std::erase_if(usual, [&](const std::string& name) {
      return !has_real_part(name) &&
             std::any_of(request_.channels.begin(), request_.channels.end(),
                         [&](const TableChannel& c) { return c.name == name || c.variable == name; });
    });
    return usual;
  }

  std::string frequency_column() {
    if (const auto given = named("f")) return *given;
    const std::vector<std::string> usual = unclaimed({std::begin(frequency_names), std::end(frequency_names)});
    if (const auto found = look_up(usual)) {
      for (const DataVariable& other : variables_)
        if (other.name != *found && contains(usual, bracketed_unit(other.name).name))
          throw InputError(file_, "", fmt::format("{} and {} both have a name of frequencies", *found, other.name),
                           fmt::format(fmt::runtime(request_.words.column), "f"));
      return *found;
    }
    throw InputError(file_, "",
                     "which column holds the excitation's frequency is not known: its variables are " + names(),
                     fmt::format(fmt::runtime(request_.words.column), "f"));
  }

  std::vector<std::string> bases_of(const TableChannel& channel) const {
    if (channel.variable == channel.name) return {channel.name};
    return {channel.variable, channel.name};
  }

  // Column of a part of a line ("", "phase", "re", ...); empty: none.
  std::string part_of(const TableChannel& channel, LineNumber number, const std::string& part) {
    const std::string of_line = line_suffix(number);
    if (const auto given = named(channel.name + of_line + (part.empty() ? "" : "." + part))) return *given;
    std::vector<std::string> candidates;
    for (const std::string& base : bases_of(channel)) {
      if (part.empty()) candidates.push_back(base + of_line);
      for (const char* const joint : joints)
        if (!part.empty()) candidates.push_back(base + of_line + joint + part);
    }
    return look_up(candidates).value_or("");
  }

  std::set<LineNumber> numbers_of(const TableChannel& channel) const {
    std::set<LineNumber> numbers = {LineNumber{}};
    const auto add = [&](const std::string& name, const std::string& base) {
      if (!name.starts_with(base + "@")) return;
      std::string text = name.substr(base.size() + 1);
      text.resize(std::min(text.find_first_not_of("0123456789/"), text.size()));
      if (const auto number = parsed_number(text)) numbers.insert(*number);
    };
    for (const auto& [part, variable] : request_.columns) add(part, channel.name);
    for (const DataVariable& variable : variables_)
      for (const std::string& base : bases_of(channel)) add(variable.name, base);
    return numbers;
  }

  void find_lines(std::size_t c) {
    const TableChannel& channel = request_.channels[c];
    const bool drives = channel.role == ChannelRole::excitation;
    for (const LineNumber number : numbers_of(channel)) {
      LineSource source{c, number, "", "", "", "", "", ""};
      const std::string name = channel.name + line_suffix(number);
      source.real = part_of(channel, number, "re");
      source.imaginary = part_of(channel, number, "im");
      if (source.real.empty() != source.imaginary.empty())
        throw InputError(file_, "channel " + name,
                         fmt::format("has a{} part and no{} part", source.real.empty() ? "n imaginary" : " real",
                                     source.real.empty() ? " real" : " imaginary"),
                         fmt::format("columns {0}.re and {0}.im, or {0} and {0}.phase", name));
      if (source.real.empty()) {
        source.amplitude = part_of(channel, number, "");
        if (!number.is_mean()) source.phase = part_of(channel, number, "phase");
        if (source.phase.empty() && number == LineNumber{} && !drives && only_response())
          source.phase = look_up({"phase"}).value_or("");
      }
      source.sd = part_of(channel, number, "sd");
      source.phase_sd = part_of(channel, number, "phase_sd");
      require_parts(source, name, drives);
      if (source.found()) sources_.push_back(std::move(source));
    }
  }

  bool only_response() const { return request_.channels.size() == 2; }

  void require_parts(const LineSource& source, const std::string& name, bool drives) {
    if (!source.found()) {
      if (drives && source.number == LineNumber{}) {
        if (!request_.convention.level)
          throw InputError(
              file_, "channel " + name,
              fmt::format("{}its level is not known: there is no column {}",
                          per_excitation_ ? "responses are given per unit of it, and a nonlinear structure answers "
                                            "to its level; "
                                          : "",
                          name),
              request_.words.level);
        return;
      }
      throw InputError(file_, "channel " + name, "has no column of amplitudes: its variables are " + names(),
                       fmt::format(fmt::runtime(request_.words.column), name));
    }
    if (drives && source.number == LineNumber{} && request_.convention.level)
      throw InputError(file_, "channel " + name, "has a column of levels and is given another one",
                       "leave the level out, or name the channel as no column is");
    if (!source.amplitude.empty() && source.phase.empty() && !drives && !source.number.is_mean())
      throw InputError(file_, "channel " + name,
                       fmt::format("has amplitudes ({}) and no phases against the excitation: its variables are {}",
                                   source.amplitude, names()),
                       fmt::format(fmt::runtime(request_.words.column), name + ".phase"));
  }

  void load() {
    std::vector<std::string> wanted = {frequency_};
    if (!condition_.empty()) wanted.push_back(condition_);
    for (const LineSource& source : sources_)
      for (const std::string* column :
           {&source.amplitude, &source.phase, &source.real, &source.imaginary, &source.sd, &source.phase_sd})
        if (!column->empty() && std::find(wanted.begin(), wanted.end(), *column) == wanted.end())
          wanted.push_back(*column);
    data_ = read_data_file(path_, wanted, MissingNumbers::keep_gaps);
    hertz_ = hertz_of_frequency();  // before its unit is lost
    convert_csv_units(data_);
    rows_ = data_.vector(frequency_).values.size();
    for (const std::string& column : wanted) {
      const std::vector<double>& values = data_.vector(column).values;
      if (values.size() != rows_)
        throw InputError(file_, "variable " + column,
                         fmt::format("has {} numbers, {} has {}", values.size(), frequency_, rows_),
                         "all columns of a table have one length");
      require_number_range(values, file_, "variable " + column);
    }
    for (const LineSource& source : sources_) {
      for (const std::string* column : {&source.amplitude, &source.real, &source.imaginary, &source.sd})
        if (!column->empty()) require_quantity(*column, request_.channels[source.channel]);
      if (!source.amplitude.empty() && !source.number.is_mean()) require_no_decibels(source.amplitude);
    }
  }

  // A frequency response function states the unit of a quotient, if any.
  void require_quantity(const std::string& column, const TableChannel& channel) const {
    const DataVariable& variable = data_.vector(column);
    const std::string stated =
        variable.stated_unit.empty() ? bracketed_unit(variable.name).unit : variable.stated_unit;
    if (stated == "dB")
      throw InputError(file_, "variable " + column, "is in dB", "amplitudes, or real and imaginary parts");
    if (per_excitation_ && channel.role == ChannelRole::response) return;
    if (const std::string fault = quantity_fault(variable, channel.quantity); !fault.empty())
      throw InputError(file_, "variable " + column, fault,
                       fmt::format("channel {} is one of {}", channel.name, to_string(channel.quantity)));
  }

  double hertz_of_frequency() {
    const DataVariable& variable = data_.vector(frequency_);
    std::string unit = variable.stated_unit;
    if (unit.empty()) unit = bracketed_unit(variable.name).unit;
    if (unit.empty()) unit = request_.convention.frequency_unit;
    const std::string name = variable.name.substr(variable.name.rfind('.') + 1);
    const bool circular = name.starts_with("omega") || name.starts_with("Omega") || name == "w";
    if (unit.empty() && circular)
      throw InputError(file_, "variable " + variable.name, "has a name of frequencies in rad/s, and no unit",
                       request_.words.frequency_unit);
    const auto hertz = hertz_in(unit.empty() ? "Hz" : unit);
    if (!hertz)
      throw InputError(file_, "variable " + variable.name,
                       "has the unit '" + unit + "', which is none of frequency", request_.words.frequency_unit);
    return *hertz;
  }

  void require_no_decibels(const std::string& column) const {
    const std::vector<double>& values = data_.vector(column).values;
    const auto negative = std::find_if(values.begin(), values.end(), [](double x) { return x < 0; });
    if (negative != values.end())
      throw InputError(
          file_,
          fmt::format("variable {}, {}", column,
                      data_.place.of(static_cast<std::size_t>(negative - values.begin()))),
          "is a negative amplitude",
          "amplitudes beside a phase are positive numbers, not dB; a real part needs its imaginary part "
          "(.re, .im)");
  }

  double at(const std::string& column, std::size_t row) const { return data_.vector(column).values[row]; }

  // Of a column of phases, or of their sd.
  double radians_in(const std::string& column, const std::string& line) const {
    const DataVariable& variable = data_.vector(column);
    if (variable.quantity == Quantity::angle) return 1;  // stated by the file, and converted
    if (const auto meaning = unit_meaning(usual_spelling(variable.stated_unit));
        meaning && meaning->quantity == Quantity::angle)
      return meaning->si_factor;
    const std::string stated =
        variable.stated_unit.empty() ? bracketed_unit(variable.name).unit : variable.stated_unit;
    if (!stated.empty() && stated != "deg" && stated != "rad")
      throw InputError(file_, "variable " + column,
                       fmt::format("has the unit '{}', which is none of the phases of {}", stated, line),
                       "deg or rad");
    if (!request_.convention.degrees)
      throw InputError(file_, "variable " + column,
                       fmt::format("whether the phases of {} are degrees or radians is not known", line),
                       request_.words.phases);
    return *request_.convention.degrees ? std::numbers::pi / 180 : 1;
  }

  double factor_of(const std::string& column, std::size_t channel, bool mean) const {
    const DataVariable& variable = data_.vector(column);
    const TableChannel& own = request_.channels[channel];
    const bool over_excitation = per_excitation_ && own.role == ChannelRole::response;
    const double unit = variable.unit.empty() ? own.si_factor : 1;
    return unit * (mean || over_excitation ? 1 : peak_of(request_.convention.amplitude));
  }

  // As the table has it: amplitude and phase in SI units, peak; nothing where the row has no such number.
  std::optional<TableLine> line_at(const LineSource& source, std::size_t row) const {
    const std::string name = request_.channels[source.channel].name + line_suffix(source.number);
    const bool mean = source.number.is_mean();
    TableLine line{source.channel, source.number, {}, std::nullopt};
    const TableConvention& convention = request_.convention;
    const bool drives = request_.channels[source.channel].role == ChannelRole::excitation;
    if (!source.real.empty()) {
      line.amplitude = Complex(at(source.real, row) * factor_of(source.real, source.channel, mean),
                               at(source.imaginary, row) * factor_of(source.imaginary, source.channel, mean));
    } else {
      const double phase = source.phase.empty() ? 0 : at(source.phase, row) * radians_in(source.phase, name);
      const double size = at(source.amplitude, row) * factor_of(source.amplitude, source.channel, mean);
      if (!std::isfinite(phase)) return std::nullopt;
      line.amplitude = mean ? Complex(size) : std::polar(std::max(0.0, size), phase);
      if (!std::isfinite(size)) return std::nullopt;
    }
    if (!std::isfinite(line.amplitude.real()) || !std::isfinite(line.amplitude.imag())) return std::nullopt;
    if (convention.lags) line.amplitude = std::conj(line.amplitude);
    if (!drives && !mean) line.amplitude *= std::polar(1.0, convention.phase_offset_rad);
    double squares = 0, count = 0;
    for (const std::string* sd : {&source.sd, &source.phase_sd})
      if (!sd->empty() && at(*sd, row) < 0) {
        line.sd = at(*sd, row);  // read_row refuses it
        return line;
      }
    if (!source.sd.empty()) {
      squares += std::pow(at(source.sd, row) * factor_of(source.sd, source.channel, mean), 2);
      ++count;
    }
    if (!source.phase_sd.empty()) {
      squares +=
          std::pow(std::abs(line.amplitude) * at(source.phase_sd, row) * radians_in(source.phase_sd, name), 2);
      ++count;
    }
    if (count > 0 && std::isfinite(squares)) line.sd = std::sqrt(squares / count);
    return line;
  }

  void read_row(std::size_t i, LineTable& table) const {
    LineRow row;
    row.place = data_.place.of(i);
    const auto damaged = [&](const std::string& why) { table.damaged.push_back(row.place + ": " + why); };
    row.frequency_hz = at(frequency_, i) * hertz_;
    if (!std::isfinite(row.frequency_hz)) return damaged(frequency_ + " is no number");
    if (!(row.frequency_hz > 0)) return damaged(fmt::format("the frequency is {}", at(frequency_, i)));
    if (!condition_.empty()) {
      const double label = at(condition_, i);
      if (!(label == std::round(label)) || !(std::abs(label) < 1e15))
        return damaged(fmt::format("condition is {}, no whole number", label));
      row.condition = static_cast<long long>(label);
    }
    Complex force = request_.convention.level.value_or(0) * peak_of(request_.convention.amplitude);
    std::set<std::size_t> there;
    for (const LineSource& source : sources_) {
      const auto line = line_at(source, i);
      const std::string name = request_.channels[source.channel].name + line_suffix(source.number);
      if (!line) {
        if (source.number == LineNumber{}) return damaged(name + " is no number");
        continue;
      }
      if (line->sd && !(*line->sd > 0))
        return damaged(fmt::format("the standard deviation of {} is {}", name, *line->sd));
      row.lines.push_back(*line);
      if (source.number == LineNumber{}) there.insert(source.channel);
      if (source.channel == excitation_ && source.number == LineNumber{}) force = line->amplitude;
    }
    if (there.count(excitation_) == 0) row.lines.push_back({excitation_, {}, force, std::nullopt});
    if (!(std::abs(force) > 0)) return damaged(request_.channels[excitation_].name + " is zero");
    if (per_excitation_)
      for (TableLine& line : row.lines) {
        if (line.channel == excitation_) continue;
        const double turns = static_cast<double>(line.number.numerator) / line.number.divisor;
        line.amplitude *= std::polar(std::abs(force), turns * std::arg(force));
        if (line.sd) *line.sd *= std::abs(force);
      }
    std::sort(row.lines.begin(), row.lines.end(), [](const TableLine& a, const TableLine& b) {
      return std::pair(a.channel, a.number) < std::pair(b.channel, b.number);
    });
    table.rows.push_back(std::move(row));
  }

  // Rows with one label are of one condition, an excitation frequency with a level.
  void require_repeats(const std::vector<LineRow>& rows) const {
    std::map<long long, const LineRow*> first;
    for (const LineRow& row : rows) {
      if (!row.condition) continue;
      const LineRow& before = *first.try_emplace(*row.condition, &row).first->second;
      const double level = std::abs(row.find(excitation_, {})->amplitude),
                   level_before = std::abs(before.find(excitation_, {})->amplitude);
      if (std::abs(row.frequency_hz - before.frequency_hz) > same_frequency * before.frequency_hz ||
          std::abs(level - level_before) > same_level * level_before)
        throw InputError(
            file_, row.place,
            fmt::format("condition {} is at {:.6g} Hz with level {:.4g}, in {} it is at {:.6g} Hz with "
                        "level {:.4g}",
                        *row.condition, row.frequency_hz, level, before.place, before.frequency_hz, level_before),
            "rows with one label are repeats, of one frequency and level; without repeats leave the "
            "column out, or call it otherwise");
    }
  }

  const std::filesystem::path& path_;
  std::string file_;
  const TableRequest& request_;
  std::vector<DataVariable> variables_;
  std::set<std::string> taken_, used_parts_;
  std::size_t excitation_ = 0, rows_ = 0;
  std::string frequency_, condition_;
  double hertz_ = 1;
  bool per_excitation_ = false;
  std::vector<LineSource> sources_;
  DataFile data_;
};

}  // namespace

TableConvention convention_of(const ConventionWords& words, const RefuseWord& refuse) {
  TableConvention convention;
  const auto is_one = [&](const char* word, const std::string& is, const std::string& first,
                          const std::string& second) {
    if (!is.empty() && is != first && is != second)
      refuse(word, is, "is no convention", first + " or " + second + " was expected");
    return is == second;
  };
  if (words.amplitudes == "rms")
    convention.amplitude = TableConvention::Amplitude::rms;
  else if (words.amplitudes == "peak_to_peak")
    convention.amplitude = TableConvention::Amplitude::peak_to_peak;
  else if (!words.amplitudes.empty() && words.amplitudes != "peak")
    refuse("amplitudes", words.amplitudes, "is no convention", "peak, rms or peak_to_peak was expected");
  const bool degrees = is_one("phases", words.phases, "rad", "deg");
  if (!words.phases.empty()) convention.degrees = degrees;
  convention.lags = is_one("phase_sign", words.phase_sign, "lead", "lag");
  convention.phase_offset_rad = words.phase_offset_deg * std::numbers::pi / 180;
  convention.per_excitation = words.per_excitation;
  convention.frequency_unit = words.frequency_unit;
  if (!words.frequency_unit.empty() && !hertz_in(words.frequency_unit))
    refuse("frequency_unit", words.frequency_unit, "is no unit of frequency",
           std::string(frequency_unit_list) + " was expected");
  return convention;
}

std::optional<double> hertz_in(const std::string& unit) {
  if (unit == "Hz" || unit == "hz" || unit == "1/s") return 1;
  if (unit == "kHz") return 1e3;
  if (unit == "rad/s") return 1 / two_pi;
  if (unit == "1/min" || unit == "rpm") return 1.0 / 60;
  return std::nullopt;
}

std::string line_suffix(LineNumber number) {
  if (number == LineNumber{}) return "";
  if (number.divisor == 1) return fmt::format("@{}", number.numerator);
  return fmt::format("@{}/{}", number.numerator, number.divisor);
}

LineTable read_line_table(const std::filesystem::path& path, const TableRequest& request) {
  return TableReader(path, request).read();
}

TableColumns columns_of(const std::vector<LineRow>& rows, const std::vector<Channel>& channels) {
  TableColumns table;
  const auto column = [&](const std::string& name, const auto& value) {
    table.names.push_back(name);
    std::vector<double>& values = table.columns.emplace_back();
    for (const LineRow& row : rows) values.push_back(value(row));
  };
  const double none = std::numeric_limits<double>::quiet_NaN();
  column("f", [](const LineRow& row) { return row.frequency_hz; });
  if (std::any_of(rows.begin(), rows.end(), [](const LineRow& row) { return row.condition.has_value(); }))
    column("condition",
           [none](const LineRow& row) { return row.condition ? static_cast<double>(*row.condition) : none; });
  std::set<std::pair<std::size_t, LineNumber>> lines;
  std::set<std::pair<std::size_t, LineNumber>> with_sd;
  for (const LineRow& row : rows)
    for (const TableLine& line : row.lines) {
      lines.emplace(line.channel, line.number);
      if (line.sd) with_sd.emplace(line.channel, line.number);
    }
  for (const auto& key : lines) {
    const auto& [channel, number] = key;
    const std::string name = channels[channel].name + line_suffix(number);
    const auto put = [&, channel = channel, number = number](const char* part, const auto& of) {
      column(name + part, [&, none](const LineRow& row) {
        const TableLine* line = row.find(channel, number);
        return line ? of(*line) : none;
      });
    };
    if (number.is_mean()) {
      put("", [](const TableLine& line) { return line.amplitude.real(); });
    } else {
      put(".re", [](const TableLine& line) { return line.amplitude.real(); });
      put(".im", [](const TableLine& line) { return line.amplitude.imag(); });
    }
    if (with_sd.count(key) > 0) put(".sd", [none](const TableLine& line) { return line.sd.value_or(none); });
  }
  return table;
}

LineRow relative_to_base(const Campaign& campaign, LineRow row) {
  const auto base = base_channel(campaign);
  if (!base) return row;
  const LineRow measured = row;
  for (TableLine& line : row.lines) {
    if (campaign.channels[line.channel].frame != Frame::absolute) continue;
    const TableLine* of_base = measured.find(*base, line.number);
    if (!of_base) continue;
    line.amplitude -= of_base->amplitude;
    if (line.sd && of_base->sd) line.sd = std::hypot(*line.sd, *of_base->sd);
  }
  return row;
}

}  // namespace secular

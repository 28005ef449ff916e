#include "measure/formats/data_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <system_error>
#include <utility>

#include "input/input_error.hpp"
#include "measure/formats/csv_header.hpp"
#include "measure/formats/hdf5_file.hpp"
#include "measure/formats/lvm_file.hpp"
#include "measure/formats/mat_file.hpp"
#include "measure/formats/matrix_lines.hpp"
#include "measure/formats/uff_file.hpp"
#include "measure/formats/uff_variables.hpp"
#include "measure/formats/unit.hpp"
#include "measure/formats/unread_format.hpp"
#include "measure/formats/wav_file.hpp"

namespace secular {
namespace {

namespace fs = std::filesystem;

std::string lower_extension(const fs::path& path) {
  std::string extension = path.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  return extension;
}

void convert_stated_units(std::vector<DataVariable>& variables) {
  for (DataVariable& variable : variables) {
    const std::string unit = usual_spelling(variable.stated_unit);
    const std::optional<UnitMeaning> meaning = unit_meaning(unit);
    if (variable.quantity || !meaning || is_bare_ratio(unit)) continue;
    variable.quantity = meaning->quantity;
    variable.unit = si_unit(meaning->quantity);
    if (meaning->si_factor != 1)
      for (double& value : variable.values) value *= meaning->si_factor;
  }
}

struct TimeName {
  bool is_time = false;
  std::string name, unit;  // in lower case, and as it stands
};

// A unit of time at the end of a name, behind a mark or as TimeMs has it; where the name is nothing else, the name.
std::size_t time_unit_in(const std::string& name) {
  const std::size_t mark = name.find_last_of("_ :,-");
  if (mark != std::string::npos && seconds_in(name.substr(mark + 1))) {
    // T_d is a period: d and h alone say less than s.
    const bool other = name.size() == mark + 2 && name.back() != 's' && mark < 2;
    return other ? std::string::npos : mark + 1;
  }
  const auto is_capital = [&](std::size_t i) { return name[i] >= 'A' && name[i] <= 'Z'; };
  for (std::size_t i = name.size(); i-- > 1;)
    if (is_capital(i) && !is_capital(i - 1) && name.size() > i + 1)
      return seconds_in(name.substr(i)) ? i : std::string::npos;
  return name.size() > 1 && seconds_in(name) ? 0 : std::string::npos;
}

// "run.Time (ms)", "Zeit/ms" -> ms; "t_us", "tUs" -> us; "t" -> none.
TimeName time_name(const std::string& path) {
  std::string name = path.substr(path.rfind('.') + 1);
  TimeName found;
  if (is_matrix_line(name)) return found;
  if (const CsvName bracketed = bracketed_unit(name); !bracketed.unit.empty()) {
    found.unit = bracketed.unit;
    name = bracketed.name;
  } else if (const std::size_t begin = time_unit_in(name); begin != std::string::npos) {
    found.unit = name.substr(begin);
    name.resize(name.find_last_not_of("_ :,-", begin > 0 ? begin - 1 : 0) + 1);
    if (begin == 0) name.clear();
  }
  for (char& c : name)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  constexpr std::string_view names_of_time[] = {"t", "time", "zeit", "temps", "tempo", "tiempo"};
  found.is_time = std::find(std::begin(names_of_time), std::end(names_of_time), name) != std::end(names_of_time);
  if (!found.is_time && !seconds_in(found.unit)) found.unit.clear();
  found.name = std::move(name);
  return found;
}

DataFile with_variables(const fs::path& path, const char* format, std::vector<MatVariable> variables,
                        std::size_t limit) {
  DataFile data{path.string(), format, {}, {"element", 1}};
  for (MatVariable& variable : variables) {
    std::size_t count = 1;
    for (const std::size_t length : variable.shape) count *= length;
    data.partial = data.partial || (variable.fault.empty() && count > limit);
    data.variables.push_back({std::move(variable.path), std::move(variable.shape), std::move(variable.type),
                              std::move(variable.values), std::move(variable.fault)});
    data.variables.back().stated_unit = std::move(variable.unit);
  }
  convert_stated_units(data.variables);
  return data;
}

DataFile read_csv_file(const fs::path& path, const std::vector<std::string>& wanted, MissingNumbers missing,
                       std::size_t limit, DecimalMark mark) {
  NumberTable table = read_csv(path, wanted, missing, limit, mark);
  DataFile data{path.string(), "CSV", {}, {"line", table.first_line}};
  data.partial = table.rows() < table.total_rows;
  data.last_row = std::move(table.last_row);
  for (std::size_t c = 0; c < table.names.size(); ++c) {
    std::vector<double>& values = table.columns[c];
    const bool any = std::any_of(values.begin(), values.end(), [](double x) { return std::isfinite(x); });
    data.variables.push_back(
        {table.names[c], {table.total_rows}, any ? "number" : "text", {}, any ? "" : "holds no number"});
    data.variables.back().stated_unit = table.units[c];
    if (any) data.variables.back().values = std::move(values);
  }
  return data;
}

DataFile read_hdf5_file(const fs::path& path, const std::vector<std::string>& wanted, std::size_t limit,
                        std::size_t) {
  return with_variables(path, looks_like_mat(path) ? "MAT v7.3" : "HDF5", read_hdf5(path, wanted, limit), limit);
}

DataFile read_mat_file(const fs::path& path, const std::vector<std::string>& wanted, std::size_t limit,
                       std::size_t) {
  return with_variables(path, "MAT v5", read_mat(path, wanted, limit), limit);
}

DataFile read_lvm_file(const fs::path& path, const std::vector<std::string>& wanted, std::size_t limit,
                       std::size_t segment) {
  DataFile data = with_variables(path, "LVM", read_lvm(path, wanted, limit, segment), limit);
  data.segment = segment;
  return data;
}

DataFile read_wav_file(const fs::path& path, const std::vector<std::string>& wanted, std::size_t limit,
                       std::size_t) {
  return read_wav(path, wanted, limit);
}

struct Format {
  bool (*looks_like)(const fs::path&);
  std::array<std::string_view, 4> extensions;
  DataFile (*read)(const fs::path&, const std::vector<std::string>& wanted, std::size_t limit, std::size_t segment);
  std::size_t (*count_segments)(const fs::path&) = [](const fs::path&) -> std::size_t { return 1; };
};

// Every format but CSV, in the order in which content is asked: MAT v7.3 is HDF5.
constexpr Format formats[] = {
    {looks_like_hdf5, {".h5", ".hdf5", ".hdf"}, read_hdf5_file},
    {looks_like_mat, {".mat"}, read_mat_file},
    {looks_like_uff, {".uff", ".unv", ".uf", ".bunv"}, read_uff_variables, count_uff_segments},
    {looks_like_lvm, {".lvm"}, read_lvm_file, count_lvm_segments},
    {looks_like_wav, {".wav"}, read_wav_file}};

// nullptr: a CSV.
const Format* format_of(const fs::path& path) {
  const std::string expected = fmt::format("a {} file was expected", data_formats);
  std::error_code ignored;
  if (!fs::exists(path, ignored)) throw InputError(path.string(), "", "does not exist", expected);
  if (!fs::is_regular_file(path, ignored)) throw InputError(path.string(), "", "is not a regular file", expected);
  for (const Format& format : formats)
    if (format.looks_like(path)) return &format;
  const std::string extension = lower_extension(path);
  for (const Format& format : formats)
    for (const std::string_view usual : format.extensions)
      if (!usual.empty() && extension == usual) return &format;
  if (const UnreadFormat* const unread = unread_format(path)) {
    std::string way(unread->way);
    for (std::size_t at = 0; (at = way.find("NAME", at)) != std::string::npos;) {
      // NAME stands for the file, NAME.csv for one beside it.
      const bool beside = way.compare(at + 4, 1, ".") == 0;
      const std::string name = beside ? path.stem().string() : path.filename().string();
      way.replace(at, 4, name);
      at += name.size();
    }
    throw InputError(path.string(), "", fmt::format("is {}, which is not read", unread->name), way);
  }
  return nullptr;
}

// Numbers without a unit count as seconds, unless they cannot be: their name says that they count samples, as
// seconds they lie thousands of years off (a computer's clock, which counts milliseconds), or they are days as
// MATLAB and spreadsheets count them.
void require_seconds(const DataVariable& time, const std::string& file) {
  constexpr std::string_view counters[] = {"sample", "samples", "index", "idx", "count", "counter", "row",
                                           "point",  "points",  "nr",    "no",  "#",     "scan",    "step"};
  constexpr double latest = 1e11;  // derived: the year 5138
  struct Days {
    double begin, end, finest;  // of two centuries; steps that are finer are no seconds
  };
  constexpr Days days[] = {{693961, 767011, 1e-5}, {20000, 73050, 1e-6}};  // MATLAB's, of a spreadsheet
  const auto wrong = [&](const std::string& what, const std::string& right) {
    return InputError(file, "variable " + time.name, what, right);
  };
  const std::string say = "give --time NAME:UNIT with s, ms, us, ns, min, h or d, or --sample-rate HZ in its place";
  const std::string name = time_name(time.name).name;
  if (counts_rows(time)) throw wrong("has no name and counts rows, from 0 or 1 on", say);
  if (std::find(std::begin(counters), std::end(counters), name) != std::end(counters))
    throw wrong("counts samples, by its name, and states no unit of time", say);
  if (time.values.size() < 2) return;
  const double first = time.values.front(), step = std::abs(time.values[1] - first);
  if (std::abs(first) > latest)
    throw wrong(fmt::format("begins at {:.6g}, which cannot be seconds, and states no unit", first), say);
  for (const Days& d : days)
    if (first > d.begin && first < d.end && step < d.finest)
      throw wrong(fmt::format("begins at {:.9g} in steps of {:.3g}, as days do, and states no unit", first, step),
                  say);
}

}  // namespace

std::string quantity_fault(const DataVariable& variable, Quantity quantity) {
  if (!variable.quantity || *variable.quantity == quantity) return {};
  return fmt::format("measures {} in {}", to_string(*variable.quantity), variable.stated_unit);
}

void convert_csv_units(DataFile& data) {
  if (data.format == "CSV") convert_stated_units(data.variables);
}

void convert_to_seconds(DataVariable& time, const std::string& file, const std::string& given) {
  std::string unit = given.empty() ? time.stated_unit : given;
  if (unit.empty()) unit = time_name(time.name).unit;
  if (unit.find(':') != std::string::npos) unit = "s";  // hh:mm:ss, of times of day (clock_stamp)
  const std::optional<double> seconds = unit.empty() ? 1 : seconds_in(unit);
  if (!seconds)
    throw InputError(file, "variable " + time.name,
                     fmt::format("has the unit '{}', which is no known unit of time", unit),
                     "give --time NAME:UNIT with s, ms, us, ns, min, h or d, or --sample-rate HZ in its place");
  if (unit.empty()) require_seconds(time, file);
  scale_to_seconds(time.values, *seconds);
  time.stated_unit = unit;
  time.unit = unit.empty() ? "" : "s";
}

bool counts_rows(const DataVariable& variable) {
  const std::vector<double>& values = variable.values;
  if (!is_nameless_column(variable.name) && !is_matrix_line(variable.name)) return false;
  if (values.size() < 2 || (values.front() != 0 && values.front() != 1)) return false;
  for (std::size_t i = 1; i < values.size(); ++i)
    if (values[i] != values.front() + static_cast<double>(i)) return false;
  return true;
}

bool is_called_time(const std::string& name) {
  return time_name(name).is_time;
}

bool holds_word_time(const std::string& name) {
  const std::string plain = "_" + time_name(name).name + "_";
  return plain.find("_time_") != std::string::npos || plain.find("_zeit_") != std::string::npos;
}

bool may_be_time(const std::string& name) {
  const TimeName found = time_name(name);
  return found.is_time || found.name.starts_with("t_") || found.name.starts_with("time");
}

std::string DataFile::names() const {
  std::string list;
  std::size_t listed = 0;
  for (const DataVariable& variable : variables) {
    if (++listed > 20) return list + fmt::format(" and {} more", variables.size() - 20);
    list += (list.empty() ? "" : ", ") + variable.name;
  }
  return list;
}

std::size_t DataFile::index_of(const std::string& name) const {
  const auto found =
      std::find_if(variables.begin(), variables.end(), [&](const DataVariable& v) { return v.name == name; });
  if (found == variables.end()) {
    std::vector<std::string> all;
    for (const DataVariable& variable : variables) all.push_back(variable.name);
    if (const std::string fault = matrix_fault(name, all); !fault.empty())
      throw InputError(file, "variable " + name, fault, "a row or a column of real numbers was expected");
    throw InputError(file, "", "has no numeric variable '" + name + "'",
                     variables.empty() ? "it holds no numeric variables" : "its variables are " + names());
  }
  if (!found->fault.empty())
    throw InputError(file, "variable " + name, found->fault, "a row or a column of real numbers was expected");
  return static_cast<std::size_t>(found - variables.begin());
}

const DataVariable& DataFile::vector(const std::string& name) const {
  return variables[index_of(name)];
}

DataVariable& DataFile::vector(const std::string& name) {
  return variables[index_of(name)];
}

DataFile read_data_file(const fs::path& path, const std::vector<std::string>& wanted, MissingNumbers missing,
                        std::size_t limit, DecimalMark mark, std::size_t segment) {
  const Format* format = format_of(path);
  if (!format) return read_csv_file(path, wanted, missing, limit, mark);
  if (mark != DecimalMark::by_dialect)
    throw InputError("--decimal-mark", "", fmt::format("{} is no CSV", path.string()), "leave it out");
  DataFile data = format->read(path, wanted, limit, segment);
  if (missing != MissingNumbers::refuse) return data;
  for (const DataVariable& variable : data.variables)
    for (std::size_t i = 0; i < variable.values.size(); ++i)
      if (!std::isfinite(variable.values[i]))
        throw InputError(data.file, fmt::format("variable {}, {}", variable.name, data.place.of(i)),
                         "is not a finite number", "cut the record around missing samples");
  return data;
}

std::size_t count_segments(const fs::path& path) {
  const Format* format = format_of(path);
  return format ? format->count_segments(path) : 1;
}

std::vector<DataVariable> describe_data_file(const fs::path& path) {
  if (format_of(path)) return read_data_file(path, {}, MissingNumbers::keep_as_nan, 0).variables;
  std::vector<DataVariable> variables;
  NumberTable table = read_csv_header(path);
  for (std::size_t c = 0; c < table.names.size(); ++c) {
    variables.push_back({std::move(table.names[c]), {}, "number", {}, {}});
    variables.back().stated_unit = std::move(table.units[c]);
  }
  convert_stated_units(variables);
  return variables;
}

}  // namespace secular

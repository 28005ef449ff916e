#include "measure/formats/lvm_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <string_view>
#include <utility>

#include "input/input_error.hpp"
#include "measure/formats/csv_header.hpp"
#include "measure/formats/file_bytes.hpp"
#include "measure/formats/mapped_file.hpp"

namespace secular {
namespace {

constexpr std::string_view lvm_begin = "LabVIEW Measurement", lvm_end_of_header = "***End_of_Header***",
                           lvm_times = "X_Value", lvm_comment = "Comment",
                           lvm_begin_special = "***Start_Special***", lvm_end_special = "***End_Special***";

std::vector<std::string_view> lvm_fields(std::string_view line, char separator) {
  std::vector<std::string_view> fields;
  for (bool more = true; more;) {
    const std::size_t end = line.find(separator);
    more = end != std::string_view::npos;
    fields.push_back(unquoted(trimmed(line.substr(0, end))));
    if (more) line.remove_prefix(end + 1);
  }
  return fields;
}

// What the headers state, by key: one field a channel, or one.
struct LvmHeaders {
  std::map<std::string, std::vector<std::string>, std::less<>> fields;
  char separator = '\t';
  bool decimal_comma = false;

  std::string at(std::string_view key, std::size_t field) const {
    const auto found = fields.find(key);
    return found == fields.end() || field >= found->second.size() ? std::string() : found->second[field];
  }
};

class LvmReader {
 public:
  LvmReader(const std::filesystem::path& path, std::size_t limit, std::size_t segment)
      : file_(path.string()), mapped_(path), rest_(mapped_.bytes()), limit_(limit), segment_(segment) {}

  std::vector<MatVariable> run() {
    read_headers();
    for (std::size_t passed = 0; passed < segment_; ++passed) {
      pass_over_rows();
      headers_ = of_file_;  // what the next segment does not state is not the last one's
      read_headers();
    }
    read_names();
    read_rows();
    make_times();
    return std::move(variables_);
  }

 private:
  [[noreturn]] void refuse(const std::string& wrong, const std::string& right) const {
    throw InputError(file_, fmt::format("line {}", line_), wrong, right);
  }

  std::string_view next() {
    ++line_;
    const std::string_view line = next_line(rest_, '\n');
    if (!trimmed(line).starts_with(lvm_begin_special)) return line;
    while (!rest_.empty()) {
      ++line_;
      if (trimmed(next_line(rest_, '\n')).starts_with(lvm_end_special)) return {};
    }
    refuse(fmt::format("the text ends within what begins with {}", lvm_begin_special),
           fmt::format("a line {}", lvm_end_special));
  }

  // Whether the line is the first one of the header of another segment; it is not taken then.
  bool begins_segment() {
    std::string_view after = rest_;
    const std::string_view line = trimmed(next_line(after, '\n'));
    return lvm_fields(line, headers_.separator).front() == "Channels" || line.starts_with(lvm_end_of_header);
  }

  void pass_over_rows() {
    while (!rest_.empty() && !begins_segment()) next();
  }

  // Up to the line of names: a header of the file and one of the segment.
  void read_headers() {
    while (!rest_.empty()) {
      const std::string_view line = trimmed(next());
      if (line.starts_with(lvm_end_of_header) && of_file_.fields.empty()) of_file_ = headers_;
      if (line.empty() || line.starts_with(lvm_end_of_header)) continue;
      // Commas may part the fields of a file that says so in its second line or later.
      const char separator = line.starts_with("Separator") && line.ends_with("Comma") ? ',' : headers_.separator;
      std::vector<std::string_view> fields = lvm_fields(line, separator);
      if (fields.front() == lvm_times) return take_names(std::move(fields));
      if (fields.front() == "Separator" && fields.size() > 1)
        headers_.separator = fields[1] == "Comma" ? ',' : '\t';
      if (fields.front() == "Decimal_Separator") headers_.decimal_comma = line.ends_with(',');
      std::vector<std::string>& values = headers_.fields[std::string(fields.front())];
      values.assign(fields.begin() + 1, fields.end());
    }
    refuse(fmt::format("the text ends without a line of names that begins with {}", lvm_times),
           fmt::format("names of the channels below {} of two headers", lvm_end_of_header));
  }

  void take_names(std::vector<std::string_view> fields) {
    while (!fields.empty() && (fields.back().empty() || fields.back() == lvm_comment)) fields.pop_back();
    names_.assign(fields.begin(), fields.end());
  }

  // With times for every channel, what a header states of a channel may stand above its column, with nothing above
  // the times between, or in the order of the channels.
  bool units_stand_above_columns() const {
    const auto stated = headers_.fields.find("Y_Unit_Label");
    if (std::count(names_.begin(), names_.end(), lvm_times) < 2 || stated == headers_.fields.end()) return false;
    for (std::size_t column = 1; column < names_.size(); ++column)
      if (names_[column] == lvm_times && column - 1 < stated->second.size() && !stated->second[column - 1].empty())
        return false;
    return true;
  }

  void read_names() {
    std::size_t channel = 0, time = 0;
    const bool above_columns = units_stand_above_columns();
    for (const std::string& name : names_) {
      MatVariable& variable = variables_.emplace_back();
      const bool is_time = name == lvm_times;
      variable.path = !is_time ? name : ++time > 1 ? fmt::format("{} {}", lvm_times, time) : "t";
      variable.type = "number";
      variable.unit = is_time ? "s" : headers_.at("Y_Unit_Label", above_columns ? variables_.size() - 2 : channel);
      if (!is_time) ++channel;
      if (name.empty()) refuse("a column has no name", "every channel has a name");
      const auto same = std::find_if(variables_.begin(), variables_.end() - 1,
                                     [&](const MatVariable& other) { return other.path == variable.path; });
      if (same != variables_.end() - 1)
        refuse(fmt::format("names two channels '{}'", name), "every channel has its own name");
    }
    if (channel == 0) refuse("names no channel", "names of channels behind X_Value");
  }

  double number(std::string_view field, const std::string& name) const {
    double value = 0;
    const FieldFault fault = parse_number(field, headers_.decimal_comma, value);
    if (fault == FieldFault::text)
      refuse(fmt::format("column {}: {} is not a number", name, shown(field)), "a number was expected");
    return fault == FieldFault::none ? value : std::numeric_limits<double>::quiet_NaN();
  }

  void read_rows() {
    while (!rest_.empty() && !begins_segment()) {
      const std::string_view line = next();
      if (trimmed(line).empty()) continue;
      const std::vector<std::string_view> fields = lvm_fields(line, headers_.separator);
      if (fields.size() < names_.size())
        refuse(fmt::format("has {} fields, the names are {}", fields.size(), names_.size()),
               "every row has one number for every column");
      for (std::size_t c = 0; c < names_.size(); ++c)
        if (variables_[c].values.size() < limit_) variables_[c].values.push_back(number(fields[c], names_[c]));
      ++rows_;
    }
    if (rows_ == 0) refuse("holds no rows", "rows of numbers below the names");
    require_one_time();
    for (MatVariable& variable : variables_) variable.shape = {std::max(rows_, variable.values.size())};
  }

  // Channels stand in one table: what begins or steps otherwise would be put at wrong times.
  void require_one_time() {
    const auto refuse_other = [&](const std::string& what) {
      throw InputError(file_, "", "has channels with times of their own (" + what + ")",
                       "channels of one time in a file: save the others to files of their own");
    };
    for (const char* const key : {"X0", "Delta_X"})
      if (const auto stated = headers_.fields.find(key); stated != headers_.fields.end())
        for (const std::string& other : stated->second)
          if (!other.empty() && other != stated->second.front()) refuse_other(key);
    const std::vector<double>& first = variables_.front().values;
    std::erase_if(variables_, [&](const MatVariable& variable) {
      if (&variable == &variables_.front() || !variable.path.starts_with(lvm_times)) return false;
      for (std::size_t i = 0; i < first.size(); ++i)
        if (std::isfinite(variable.values[i]) && variable.values[i] != first[i]) refuse_other(variable.path);
      return true;
    });
  }

  // Without columns of times: from the first one and the step.
  void make_times() {
    std::vector<double>& first = variables_.front().values;
    if (std::any_of(first.begin(), first.end(), [](double x) { return std::isfinite(x); })) return;
    const auto stated = [&](std::string_view key) {
      const std::string text = headers_.at(key, 0);
      double value = 0;
      if (parse_number(text, headers_.decimal_comma, value) != FieldFault::none)
        throw InputError(file_, "header", fmt::format("states no number for {}, and rows have no times", key),
                         "a header with X0 and Delta_X");
      return value;
    };
    const double begin = stated("X0"), step = stated("Delta_X");
    for (std::size_t i = 0; i < first.size(); ++i) first[i] = begin + step * static_cast<double>(i);
  }

  const std::string file_;
  MappedFile mapped_;
  std::string_view rest_;
  const std::size_t limit_, segment_;
  std::size_t line_ = 0, rows_ = 0;
  LvmHeaders headers_, of_file_;
  std::vector<std::string> names_;
  std::vector<MatVariable> variables_;
};

}  // namespace

std::vector<MatVariable> read_lvm(const std::filesystem::path& path, const std::vector<std::string>& wanted,
                                  std::size_t limit, std::size_t segment) {
  if (!looks_like_lvm(path))
    throw InputError(path.string(), "line 1", "is not the begin of an LVM file",
                     fmt::format("{} was expected", lvm_begin));
  std::vector<MatVariable> variables = LvmReader(path, limit, segment).run();
  for (MatVariable& variable : variables)
    if (!wanted.empty() && std::find(wanted.begin(), wanted.end(), variable.path) == wanted.end())
      variable.values.clear();
  return variables;
}

std::size_t count_lvm_segments(const std::filesystem::path& path) {
  const MappedFile mapped(path);
  std::string_view rest = mapped.bytes();
  std::size_t headers = 0;
  while (!rest.empty())
    if (trimmed(next_line(rest, '\n')).starts_with(lvm_end_of_header)) ++headers;
  return headers < 2 ? 1 : headers - 1;  // the first one is the file's
}

bool looks_like_lvm(const std::filesystem::path& path) {
  return some_bytes(path, lvm_begin.size()) == lvm_begin;
}

}  // namespace secular

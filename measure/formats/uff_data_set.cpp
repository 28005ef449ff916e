#include "measure/formats/uff_data_set.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

#include "measure/formats/damaged_file.hpp"
#include "measure/formats/fortran_number.hpp"

namespace secular {
namespace {

// The four numbers behind "58b", by the blanks between them or by columns that they fill.
bool read_binary_head(std::string_view text, bool by_blanks, UffDataSetHead& head) {
  constexpr std::size_t widths[] = {6, 6, 12, 12};
  const std::size_t* width = widths;
  for (long long* field : {&head.byte_order, &head.float_format, &head.header_lines, &head.bytes}) {
    if (by_blanks) text = text.substr(std::min(text.find_first_not_of(' '), text.size()));
    const std::size_t end = std::min(by_blanks ? text.find_first_of(" \t\r") : *width, text.size());
    const auto value = whole_number(text.substr(0, end));
    if (!value || *value < 0) return false;
    *field = *value;
    text.remove_prefix(end);
    ++width;
  }
  return true;
}

UffDataSetHead read_head(UffLines& lines) {
  const std::string_view line = lines.take();
  UffDataSetHead head;
  const auto number = whole_number(line.substr(0, 6));
  if (!number || *number <= 0)
    lines.fail("is no number of a data set", "behind the delimiter -1 a number such as 58 was expected");
  head.number = *number;
  const std::size_t letter = std::min(line.find_first_not_of(' ', 6), line.size());
  head.binary = letter < line.size() && (line[letter] == 'b' || line[letter] == 'B');
  if (!head.binary) return head;
  const std::string_view rest = line.substr(letter + 1);
  if (!read_binary_head(rest, false, head) && !read_binary_head(rest, true, head))
    lines.fail("does not describe its binary data",
               "the byte order, the floating point format, the count of lines and of bytes were expected");
  return head;
}

}  // namespace

bool next_data_set(UffLines& lines, UffDataSetHead& head) {
  while (!lines.at_end()) {
    const std::string_view line = lines.take();
    if (stripped(line).find_first_not_of('\x1A') == std::string_view::npos) continue;  // empty, or the end in DOS
    if (!is_uff_delimiter(line))
      lines.fail("is no delimiter of a data set", "-1 in columns 5 and 6 and nothing else was expected");
    if (lines.at_end()) lines.fail("no data set follows the delimiter", whole_again);
    head = read_head(lines);
    return true;
  }
  return false;
}

void skip_data_set(const UffDataSetHead& head, UffLines& lines) {
  if (head.binary) {
    for (long long i = 0; i < head.header_lines && !lines.at_end(); ++i) lines.take();
    if (static_cast<unsigned long long>(head.bytes) > lines.left())
      lines.fail(fmt::format("announces {} bytes, {} follow", head.bytes, lines.left()), whole_again);
    lines.take_bytes(static_cast<std::size_t>(head.bytes));
  }
  while (!lines.at_end())
    if (is_uff_delimiter(lines.take())) return;
  lines.fail(fmt::format("data set {} does not end", head.number), whole_again);
}

}  // namespace secular

#include "measure/formats/uff_lines.hpp"

#include <algorithm>

#include "input/input_error.hpp"
#include "measure/formats/fortran_number.hpp"

namespace secular {

std::string_view UffLines::take() {
  begin_ = next_;
  const std::size_t end = std::min(text_.find('\n', next_), text_.size());
  next_ = std::min(end + 1, text_.size());
  ++line_;
  return text_.substr(begin_, end - begin_);
}

bool UffLines::skip_lines(std::size_t count, std::size_t bytes) {
  if (bytes == 0 || bytes > left() || text_[next_ + bytes - 1] != '\n') return false;
  next_ += bytes;
  line_ += count;
  return true;
}

std::string_view UffLines::take_bytes(std::size_t count) {
  begin_ = next_;
  next_ += count;
  binary_ = true;
  return text_.substr(begin_, count);
}

void UffLines::fail(const std::string& wrong, const std::string& right) const {
  throw InputError(file_, binary_ ? "byte " + std::to_string(begin_ + 1) : "line " + std::to_string(line_), wrong,
                   right);
}

bool is_uff_delimiter(std::string_view line) {
  const std::size_t end = line.find_last_not_of(" \t\r\n");
  return end != std::string_view::npos && end < 6 && stripped(line) == "-1";
}

}  // namespace secular

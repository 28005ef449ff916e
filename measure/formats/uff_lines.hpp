#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace secular {

/// Takes lines, and stretches of binary data, off the text of a universal file and knows where it is.
class UffLines {
 public:
  UffLines(std::string_view text, std::string file) : text_(text), file_(std::move(file)) {}

  bool at_end() const { return next_ == text_.size(); }
  std::size_t left() const { return text_.size() - next_; }
  /// The next line without its break; empty at the end.
  std::string_view take();
  /// Leaves out lines whose length is known. False, and nothing happens, unless a line ends there.
  bool skip_lines(std::size_t count, std::size_t bytes);
  /// The next bytes, of which there are enough.
  std::string_view take_bytes(std::size_t count);
  std::string_view rest() const { return text_.substr(next_); }
  /// Throws InputError for the line taken last: "line 7", or "byte 8200" behind binary data, which has no lines.
  [[noreturn]] void fail(const std::string& wrong, const std::string& right) const;

 private:
  std::string_view text_;
  std::string file_;
  std::size_t next_ = 0, begin_ = 0;  // begin_: of what was taken last
  std::size_t line_ = 0;
  bool binary_ = false;
};

/// True for the line that begins and ends data sets: -1 in columns 5 and 6 and nothing else.
bool is_uff_delimiter(std::string_view line);

}  // namespace secular

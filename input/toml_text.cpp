#include "input/toml_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>

#include "input/input_error.hpp"

namespace secular {
namespace {

/// Each part is a table in a table, which toml++ destroys by recursion; it lets values nest 256 deep itself, and
/// each level may have a key like this. Files of this program have keys of one or two parts.
constexpr std::size_t most_key_parts = 32;

bool begins_key(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-' ||
         c == '"' || c == '\'';
}

class Scan {
 public:
  Scan(std::string_view text, const std::string& file) : text_(text), file_(file) {
    if (text_.starts_with("\xEF\xBB\xBF")) line_begin_ = at_ = 3;
  }

  void run() {
    while (!at_end()) {
      const char c = text_[at_];
      if (c == '"' || c == '\'')
        string(c);
      else if (c == '#')
        comment();
      else
        token(c);
    }
  }

 private:
  bool at_end() const { return at_ >= text_.size(); }
  char now() const { return at_end() ? '\0' : text_[at_]; }

  [[noreturn]] void fail(const std::string& wrong, const std::string& right) const {
    throw InputError(file_, fmt::format("line {}, column {}", line_, at_ - line_begin_ + 1), wrong, right);
  }

  // A character of any place: counts lines, refuses what no text holds.
  void take() {
    const auto code = static_cast<unsigned char>(text_[at_]);
    if ((code < 0x20 && code != '\t' && code != '\n' && code != '\r') || code == 0x7f)
      fail(fmt::format("is a control character (code {})", code), "a TOML file is text");
    ++at_;
    if (code != '\n') return;
    ++line_;
    line_begin_ = at_;
  }

  void comment() {
    while (!at_end() && now() != '\n') take();
  }

  void string(char quote) {
    const std::string three(3, quote);
    const bool long_one = text_.substr(at_).starts_with(three);
    for (int i = 0; i < (long_one ? 3 : 1); ++i) take();
    while (!at_end()) {
      if (long_one ? text_.substr(at_).starts_with(three) : now() == quote) break;
      if (!long_one && now() == '\n') return;  // never closed: toml++ says so
      if (quote == '"' && now() == '\\' && at_ + 1 < text_.size()) take();
      take();
    }
    for (int i = 0; !at_end() && i < (long_one ? 3 : 1); ++i) take();
    while (long_one && now() == quote) take();  // up to two quotes may stand in front of those that close
    line_is_empty_ = false;
  }

  void token(char c) {
    if (static_cast<unsigned char>(c) >= 0x80)
      fail("a character that is not ASCII outside of strings and comments",
           "keys and values are ASCII; put text in quotes");
    if (c == '[' && line_is_empty_ && depth_ == 0) return header();
    if (c == '.' && ++points_ >= most_key_parts)
      fail(fmt::format("a key of more than {} parts", most_key_parts), "name tables with fewer points");
    if (std::string_view("=,[]{}\n").find(c) != std::string_view::npos) points_ = 0;
    if (c == '[' || c == '{') ++depth_;
    if ((c == ']' || c == '}') && depth_ > 0) --depth_;
    if (c == '\n')
      line_is_empty_ = true;
    else if (c != ' ' && c != '\t' && c != '\r')
      line_is_empty_ = false;
    take();
  }

  // [name] or [[name]]; its parts are tokens like others.
  void header() {
    take();
    if (now() == '[') take();
    while (now() == ' ' || now() == '\t') take();
    if (!begins_key(now())) fail("is no name of a table", "a header such as [nominal] or [[case]] was expected");
    line_is_empty_ = false;
    points_ = 0;
  }

  std::string_view text_;
  const std::string& file_;
  std::size_t at_ = 0, line_ = 1, line_begin_ = 0, points_ = 0, depth_ = 0;
  bool line_is_empty_ = true;
};

}  // namespace

void check_toml_text(std::string_view text, const std::string& file) {
  Scan(text, file).run();
}

}  // namespace secular

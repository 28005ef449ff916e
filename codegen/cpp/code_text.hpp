#pragma once

#include <string>

namespace secular {

/// Lines of C++ with indentation.
class CodeText {
 public:
  /// A line that is too long is broken before an operator; its trailing remark goes above it.
  CodeText& line(const std::string& text = {});
  /// A comment, broken at blanks.
  CodeText& comment(const std::string& text, const std::string& mark = "///");
  /// One statement that may run over several lines.
  void statement(const std::string& text);
  const std::string& text() const { return text_; }

 private:
  std::string text_;
  int depth_ = 0;
};

/// The text with what stands inside namespaces moved to the left margin.
std::string without_namespace_indentation(const std::string& text);

/// "a" and "-b" make "a - b".
void add_to_sum(std::string& sum, const std::string& addend);

/// Multiplications, divisions, additions and subtractions in a text of generated code.
int operations_in(const std::string& code);

/// A string literal.
std::string quoted(const std::string& text);

/// Text for a comment, which must not be able to end itself or continue on the next line.
std::string commented(std::string text);

}  // namespace secular

#pragma once

#include <string>
#include <vector>

namespace secular {

/// Lines of C++ with indentation.
class CodeText {
 public:
  /// A line that is too long is broken before an operator; its trailing remark goes above it.
  CodeText& line(const std::string& text = {});
  /// A line and the rest of what it begins.
  void wrapped(const std::string& first, const std::string& rest);
  /// A comment, broken at blanks.
  CodeText& comment(const std::string& text, const std::string& mark = "///");
  /// "OPEN first, second CLOSE", several to a line, those that are too long broken before an operator.
  void list(const std::string& open, const std::vector<std::string>& items, const std::string& close);
  const std::string& text() const { return text_; }

 private:
  std::string indent() const;
  void broken(const std::string& indent, std::string rest);

  std::string text_;
  int depth_ = 0;
};

/// The text with what stands inside namespaces moved to the left margin.
std::string without_namespace_indentation(const std::string& text);

/// "a" and "-b" make "a - b".
void add_to_sum(std::string& sum, const std::string& addend);

/// A string literal.
std::string quoted(const std::string& text);

/// The same as literals one after the other, none longer than fits a line.
std::vector<std::string> quoted_lines(const std::string& text);

/// Text for a comment, which must not be able to end itself or continue on the next line.
std::string commented(std::string text);

}  // namespace secular

#include "codegen/cpp/code_text.hpp"

#include <algorithm>
#include <sstream>

namespace secular {
namespace {

constexpr std::size_t widest = 118, widest_comment = 108;
constexpr int indentation = 2;

std::size_t position(std::size_t found) {
  return found == std::string::npos ? 0 : found;
}

}  // namespace

CodeText& CodeText::line(const std::string& text) {
  if (text.empty()) {
    text_ += "\n";
    return *this;
  }
  if (text.front() == '}') --depth_;
  const std::string indent(static_cast<std::size_t>(indentation * std::max(0, depth_)), ' ');
  std::string rest = text;
  const std::size_t remark = rest.find(";  // ");
  if (remark != std::string::npos && indent.size() + rest.size() > widest) {
    text_ += indent + rest.substr(remark + 3) + "\n";
    rest.resize(remark + 1);
  }
  std::string lead = indent;
  const bool breakable = rest.rfind("//", 0) != 0 && rest.find('"') == std::string::npos;
  while (breakable && lead.size() + rest.size() > widest) {
    const std::size_t room = widest - lead.size();
    std::size_t cut = std::max(position(rest.rfind(" + ", room)), position(rest.rfind(" - ", room)));
    if (cut == 0) cut = position(rest.rfind(" * ", room));
    if (cut == 0) break;
    text_ += lead + rest.substr(0, cut) + "\n";
    rest = rest.substr(cut + 1);
    lead = indent + "    ";
  }
  text_ += lead + rest + "\n";
  if (text.back() == '{') ++depth_;
  return *this;
}

CodeText& CodeText::comment(const std::string& text, const std::string& mark) {
  std::istringstream words(text);
  std::string row;
  for (std::string word; words >> word;) {
    if (!row.empty() && row.size() + word.size() > widest_comment) {
      line(mark + " " + row);
      row.clear();
    }
    row += (row.empty() ? "" : " ") + word;
  }
  return row.empty() ? *this : line(mark + " " + row);
}

void CodeText::statement(const std::string& text) {
  std::istringstream rows(text);
  bool first = true;
  for (std::string row; std::getline(rows, row); first = false) line((first ? "" : "    ") + row);
}

std::string without_namespace_indentation(const std::string& text) {
  std::istringstream lines(text);
  std::string result;
  int spaces = 0;
  for (std::string row; std::getline(lines, row);) {
    const std::size_t begin = row.find_first_not_of(' ');
    const std::string body = begin == std::string::npos ? "" : row.substr(begin);
    if (body.rfind("}  // namespace", 0) == 0) {
      --spaces;
      result += body + "\n";
      continue;
    }
    const auto shift = static_cast<std::size_t>(indentation * spaces);
    result += (row.size() >= shift ? row.substr(shift) : row) + "\n";
    if (body.rfind("namespace ", 0) == 0 && body.back() == '{') ++spaces;
  }
  return result;
}

void add_to_sum(std::string& sum, const std::string& addend) {
  if (sum.empty())
    sum = addend;
  else if (addend.front() == '-')
    sum += " - " + addend.substr(1);
  else
    sum += " + " + addend;
}

int operations_in(const std::string& code) {
  int count = 0;
  for (std::size_t i = 1; i + 1 < code.size(); ++i)
    if (code[i - 1] == ' ' && code[i + 1] == ' ' && std::string("+-*/").find(code[i]) != std::string::npos) ++count;
  return count;
}

std::string quoted(const std::string& text) {
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\')
      result += std::string("\\") + c;
    else if (static_cast<unsigned char>(c) < 0x20)
      result += ' ';
    else
      result += c;
  }
  return result + "\"";
}

std::string commented(std::string text) {
  for (char& c : text)
    if (static_cast<unsigned char>(c) < 0x20 || c == '\\') c = ' ';
  return text;
}

}  // namespace secular

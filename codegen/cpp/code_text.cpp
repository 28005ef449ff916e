#include "codegen/cpp/code_text.hpp"

#include <algorithm>
#include <sstream>
#include <vector>

namespace secular {
namespace {

constexpr std::size_t widest = 118, widest_comment = 108;
constexpr int indentation = 2;

std::size_t position(std::size_t found) {
  return found == std::string::npos ? 0 : found;
}

}  // namespace

std::string CodeText::indent() const {
  return std::string(static_cast<std::size_t>(indentation * std::max(0, depth_)), ' ');
}

void CodeText::broken(const std::string& indent, std::string rest) {
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
}

CodeText& CodeText::line(const std::string& text) {
  if (text.empty()) {
    text_ += "\n";
    return *this;
  }
  if (text.front() == '}') --depth_;
  std::string rest = text;
  const std::size_t remark = rest.find(";  // ");
  if (remark != std::string::npos && indent().size() + rest.size() > widest) {
    text_ += indent() + rest.substr(remark + 3) + "\n";
    rest.resize(remark + 1);
  }
  broken(indent(), rest);
  if (text.back() == '{') ++depth_;
  return *this;
}

void CodeText::list(const std::string& open, const std::vector<std::string>& items, const std::string& close) {
  const std::string continued = indent() + "    ";
  std::string row = indent() + open;
  const auto finish = [&] {
    const std::size_t lead = row.find_first_not_of(' ');
    broken(row.substr(0, lead), row.substr(lead));
  };
  bool started = false;  // with an item on the row
  for (std::size_t i = 0; i < items.size(); ++i) {
    const std::string piece = items[i] + (i + 1 == items.size() ? close : ",");
    if (started && row.size() + 1 + piece.size() > widest) {
      finish();
      row = continued + piece;
    } else {
      row += (started ? " " : "") + piece;
    }
    started = true;
  }
  if (items.empty()) row += close;
  finish();
}

void CodeText::wrapped(const std::string& first, const std::string& rest) {
  text_ += indent() + first + "\n";
  line("    " + rest);
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

std::vector<std::string> quoted_lines(const std::string& text) {
  std::vector<std::string> lines;
  std::string rest = text;
  while (rest.size() > widest_comment) {
    const std::size_t cut = rest.rfind(' ', widest_comment);
    if (cut == std::string::npos || cut == 0) break;
    lines.push_back(secular::quoted(rest.substr(0, cut + 1)));
    rest.erase(0, cut + 1);
  }
  lines.push_back(secular::quoted(rest));
  return lines;
}

std::string commented(std::string text) {
  for (char& c : text)
    if (static_cast<unsigned char>(c) < 0x20 || c == '\\') c = ' ';
  return text;
}

}  // namespace secular

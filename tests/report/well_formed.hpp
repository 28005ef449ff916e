#pragma once

#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace secular::report::test {

/// What is wrong with the markup, or nothing: every element closed in order (HTML's void elements apart), every
/// attribute quoted, every & the start of one of the references that the escaping writes.
inline std::string first_markup_error(std::string_view text) {
  static const std::set<std::string_view> void_elements = {"meta", "br", "hr", "wbr"};
  std::vector<std::string> open;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '&') {
      bool known = false;
      for (const std::string_view reference : {"&amp;", "&lt;", "&gt;", "&quot;", "&#39;"})
        known = known || text.substr(i).starts_with(reference);
      if (!known) return "bare & at " + std::string(text.substr(i, 20));
    }
    if (text[i] != '<') continue;
    if (text.substr(i).starts_with("<!DOCTYPE")) {
      i = text.find('>', i);
      continue;
    }
    if (text.substr(i).starts_with("<style>")) {
      i = text.find("</style>", i) + 7;
      continue;
    }
    const bool closing = i + 1 < text.size() && text[i + 1] == '/';
    const std::size_t name_begin = i + (closing ? 2 : 1);
    const std::size_t name_end = text.find_first_of(" />\n", name_begin);
    const std::string name(text.substr(name_begin, name_end - name_begin));
    if (name.empty() || name.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789") != std::string::npos)
      return "bare < at " + std::string(text.substr(i, 20));
    char quote = 0;
    std::size_t end = name_end;
    for (; end < text.size() && (quote != 0 || text[end] != '>'); ++end) {
      if (quote != 0 && text[end] == quote)
        quote = 0;
      else if (quote == 0 && (text[end] == '"' || text[end] == '\''))
        quote = text[end];
      else if (quote == 0 && text[end] == '<')
        return "< inside tag " + name;
    }
    if (end == text.size()) return "unfinished tag " + name;
    if (closing) {
      if (open.empty() || open.back() != name)
        return "</" + name + "> closes " + (open.empty() ? "nothing" : open.back());
      open.pop_back();
    } else if (text[end - 1] != '/' && void_elements.count(name) == 0) {
      open.push_back(name);
    }
    i = end;
  }
  return open.empty() ? "" : "never closed: " + open.back();
}

}  // namespace secular::report::test

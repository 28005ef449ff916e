#pragma once

#include <array>
#include <cmath>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace secular::report::test {

inline std::size_t count_of(std::string_view text, std::string_view part) {
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != std::string_view::npos; at = text.find(part, at + 1)) ++count;
  return count;
}

/// Texts between `begin` and `end`, in turn.
inline std::vector<std::string> parts_between(std::string_view text, std::string_view begin, std::string_view end) {
  std::vector<std::string> parts;
  for (std::size_t from = text.find(begin); from != std::string_view::npos; from = text.find(begin, from + 1)) {
    const std::size_t to = text.find(end, from + begin.size());
    if (to == std::string_view::npos) break;
    parts.emplace_back(text.substr(from + begin.size(), to - from - begin.size()));
  }
  return parts;
}

/// What a report page lacks: a sentence above the numbers; of every figure a name, a box that the keyboard reaches,
/// a caption, and axes with names; ids that are used once; headline numbers that do not break.
inline std::vector<std::string> structure_faults(const std::string& page) {
  std::vector<std::string> faults;
  const auto check = [&](bool holds, const std::string& fault) {
    if (!holds) faults.push_back(fault);
  };
  check(count_of(page, "<p class=\"verdict") == 1, "no verdict");
  check(page.find("class=\"verdict") < page.find("class=\"card "), "the verdict is below the numbers");
  std::set<std::string> ids;
  for (const std::string& id : parts_between(page, " id=\"", "\"")) check(ids.insert(id).second, "twice: id " + id);
  for (const std::string& id : parts_between(page, " id='", "'")) check(ids.insert(id).second, "twice: id " + id);
  for (const std::string& link : parts_between(page, "href=\"#", "\"")) check(ids.contains(link), "no id " + link);
  for (const std::string& figure : parts_between(page, "<figure>", "</figure>")) {
    const std::string name = parts_between(figure, "aria-label=\"", "\"").front();
    check(std::regex_search(name, std::regex("^Figure [0-9]+: .+")), "a figure without a title: " + name);
    check(figure.find("tabindex=\"0\"") != std::string::npos, "the keyboard does not reach " + name);
    check(std::regex_search(figure, std::regex("<figcaption><strong>Figure [0-9]+\\.</strong> .{20,}")),
          "no caption: " + name);
    check(figure.find("<title>") != std::string::npos, "no <title>: " + name);
    for (const char* axis : {"&quot;x&quot;:[&quot;", "&quot;y&quot;:[&quot;"})
      for (const std::string& label : parts_between(figure, axis, "&quot;"))
        check(!label.empty(), "no axis: " + name);
  }
  for (const std::string& table : parts_between(page, "<table", "</table>"))
    check(table.find("<th scope=\"col\"") != std::string::npos, "a table without headings");
  check(count_of(page, "<div class=\"scroll\"") >= count_of(page, "<table"), "a table outside of a scroll box");
  const std::regex number("class=\"value\">[0-9]");
  check(!std::regex_search(page, number), "a headline number that may break");
  check(page.find(".card .headline { white-space: nowrap; }") != std::string::npos, "headline numbers may break");
  return faults;
}

/// Relative luminance of "#RRGGBB" (WCAG 2.1).
inline double luminance(const std::string& color) {
  double sum = 0;
  constexpr std::array weights = {0.2126, 0.7152, 0.0722};
  for (std::size_t i = 0; i < 3; ++i) {
    const double c = std::stoi(color.substr(1 + 2 * i, 2), nullptr, 16) / 255.0;
    sum += weights[i] * (c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4));
  }
  return sum;
}

inline double contrast(const std::string& one, const std::string& other) {
  const double a = luminance(one), b = luminance(other);
  return (std::max(a, b) + 0.05) / (std::min(a, b) + 0.05);
}

/// Variables of a page's style sheet by theme: "", "dark", "print". Those that a theme does not set are those of
/// "".
inline std::map<std::string, std::map<std::string, std::string>> page_colors(const std::string& page) {
  std::map<std::string, std::map<std::string, std::string>> themes;
  const std::string style = parts_between(page, "<style>", "</style>").front();
  const std::regex block(R"((@media[^{]*\{\s*)?:root \{([^}]*)\})"), variable(R"(--([a-z]+):\s*(#[0-9a-fA-F]{6}))");
  for (std::sregex_iterator at(style.begin(), style.end(), block), end; at != end; ++at) {
    const std::string media = (*at)[1], body = (*at)[2];
    std::map<std::string, std::string>& colors = themes[media.find("dark") != std::string::npos    ? "dark"
                                                        : media.find("print") != std::string::npos ? "print"
                                                                                                   : ""];
    for (std::sregex_iterator v(body.begin(), body.end(), variable); v != end; ++v) colors[(*v)[1]] = (*v)[2];
  }
  for (auto& [theme, colors] : themes) colors.insert(themes[""].begin(), themes[""].end());
  return themes;
}

}  // namespace secular::report::test

#include "app/verify/errata_page.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace secular::app {
namespace {

using verify::Verdict;

std::string item(const char* label, const std::string& text, bool code) {
  if (text.empty()) return {};
  return code ? fmt::format("- {}: `{}`\n", label, text) : fmt::format("- {}: {}\n", label, text);
}

std::string entry(const Verdict& v) {
  std::string text = "### " + v.equation + (v.part.empty() ? "" : ", " + v.part) + "\n\n";
  text += item("printed", v.printed, true) + item("right", v.corrected, true);
  if (!v.term_printed.empty() && v.term_printed != v.printed)
    text += fmt::format("- term: `{}`, right `{}`\n", v.term_printed, v.term_right);
  text += item(v.kind == "arithmetic" || v.kind == "matrix" ? "arithmetic" : "where", v.reason, false);
  const bool by_derivation = v.proof.empty() && !v.corrected.empty();
  text += item("evidence", by_derivation ? "what the equations of motion give, symbol by symbol" : v.proof, false) +
          item("remark", v.remark, false);
  if (!v.as_recorded()) text += item("recorded as", v.recorded, false);
  return text + "\n";
}

}  // namespace

std::string errata_page(const verify::PrintedSource& source, const std::vector<Verdict>& verdicts) {
  const auto number = [&](const char* verdict) {
    return std::count_if(verdicts.begin(), verdicts.end(), [&](const Verdict& v) { return v.verdict == verdict; });
  };
  std::string text = "# Errata\n\n" + source.source + "\n\n";
  text += fmt::format(
      "{} statements confirmed, {} entries agree. The language of the formulas is explained in `{}`.\n\n",
      number("confirmed"), number("agrees"), source.name + ".toml");
  const struct {
    const char *verdict, *title;
  } sections[] = {{"misprint", "Misprints and errors"},
                  {"disagrees", "Numbers that do not follow from the others"},
                  {"convention", "Other notation"},
                  {"unresolved", "Neither as printed nor as corrected"}};
  for (const auto& section : sections) {
    if (number(section.verdict) == 0) continue;
    text += fmt::format("## {} ({})\n\n", section.title, number(section.verdict));
    for (const Verdict& v : verdicts)
      if (v.verdict == section.verdict) text += entry(v);
  }
  text.pop_back();
  return text;
}

}  // namespace secular::app

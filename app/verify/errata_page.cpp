#include "app/verify/errata_page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

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
  text += item("evidence", v.proof.empty() ? v.evidence : v.evidence + ": " + v.proof, false) +
          item("remark", v.remark, false);
  if (!v.as_recorded()) text += item("recorded as", v.recorded, false);
  return text + "\n";
}

}  // namespace

std::string errata_page(const verify::PrintedSource& source, const std::vector<Verdict>& verdicts, bool proofs) {
  const auto number = [&](const char* verdict) {
    return std::count_if(verdicts.begin(), verdicts.end(), [&](const Verdict& v) { return v.verdict == verdict; });
  };
  std::string text = "# Errata\n\n" + source.source + "\n\n";
  text += fmt::format(
      "{} statements confirmed, {} entries agree. The language of the formulas is explained in `{}`.\n\n",
      number("confirmed"), number("agrees"), source.name + ".toml");
  if (number("misprint") > 0) {
    std::map<std::string, int> by_evidence;
    for (const Verdict& v : verdicts)
      if (v.verdict == "misprint") ++by_evidence[v.evidence];
    text += "What decides the misprints:\n\n";
    for (const auto& [evidence, count] : by_evidence) text += fmt::format("- {}: {}\n", evidence, count);
    text += "\n";
  }
  if (!proofs) text += "The integration of the equations of motion was left out (`--without-proofs`).\n\n";
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

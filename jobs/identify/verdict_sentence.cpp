#include "jobs/identify/verdict_sentence.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "report/number_format.hpp"

namespace secular {
namespace {

/// Counts of parameters that were to be estimated.
struct Known {
  std::size_t all = 0, numbers = 0, doubtful = 0;
  const EstimatedValue *sharpest = nullptr, *bluntest = nullptr;  ///< of those that differ from zero
};

double relative(const EstimatedValue& v) {
  return v.sd / std::abs(*v.value);
}

Known known_of(const Estimate& estimate) {
  Known known;
  for (const EstimatedValue& v : estimate.parameters) {
    if (v.fixed) continue;
    ++known.all;
    if (!v.value) continue;
    ++known.numbers;
    if (v.doubtful) ++known.doubtful;
    if (!v.significant || v.doubtful) continue;
    if (!known.sharpest || relative(v) < relative(*known.sharpest)) known.sharpest = &v;
    if (!known.bluntest || relative(v) > relative(*known.bluntest)) known.bluntest = &v;
  }
  return known;
}

/// The equation that holds worst among those that do not hold; null: none, or none was tested.
const LackOfFit* worst_misfit(const Estimate& estimate) {
  const LackOfFit* worst = nullptr;
  for (const CaseLackOfFit& tests : estimate.lack_of_fit)
    for (const LackOfFit& test : tests.equations)
      if (test.significant && (!worst || test.misfit_ratio > worst->misfit_ratio)) worst = &test;
  return worst;
}

std::string percent(const EstimatedValue& v) {
  return v.name + " to " + report::format_number(100 * relative(v), 2) + " %";
}

}  // namespace

std::string verdict_sentence(const Estimate& estimate) {
  const Known known = known_of(estimate);
  const LackOfFit* misfit = worst_misfit(estimate);
  std::string text = misfit ? fmt::format(
                                  "The model does not hold as it is (its equations miss by {} times what repeats "
                                  "explain), so read the numbers with care: ",
                                  report::format_number(misfit->misfit_ratio, 2))
                     : estimate.lack_of_fit.empty() ? ""
                                                    : "The model holds within the scatter of repeats: ";
  text +=
      fmt::format("{} of {} parameters ha{} a number", known.numbers, known.all, known.numbers == 1 ? "s" : "ve");
  if (known.sharpest) text += ", " + percent(*known.sharpest);
  if (known.bluntest != known.sharpest) text += " at best and " + percent(*known.bluntest) + " at worst";
  if (known.doubtful > 0)
    text += fmt::format("; {} of them {} doubtful", known.doubtful, known.doubtful == 1 ? "is" : "are");
  text += ".";
  if (text.front() >= 'a' && text.front() <= 'z') text.front() = static_cast<char>(text.front() - 'a' + 'A');
  return text;
}

report::Tone verdict_tone(const Estimate& estimate) {
  const Known known = known_of(estimate);
  if (known.numbers == 0) return report::Tone::bad;
  return worst_misfit(estimate) || known.doubtful > 0 ? report::Tone::caution : report::Tone::good;
}

}  // namespace secular

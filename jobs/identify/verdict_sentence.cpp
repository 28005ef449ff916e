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

std::size_t equations_tested(const Estimate& estimate) {
  std::size_t count = 0;
  for (const CaseLackOfFit& tests : estimate.lack_of_fit) count += tests.equations.size();
  return count;
}

/// What the tests say of the model.
std::string tested_text(const Estimate& estimate) {
  if (const LackOfFit* misfit = worst_misfit(estimate))
    return fmt::format(
        "The model does not hold as it is (its equations miss by {} times what repeats explain), so read the "
        "numbers with care: ",
        report::format_number(misfit->misfit_ratio, 2));
  const std::size_t tested = equations_tested(estimate);
  if (tested == 0) return "No equation could be tested: ";
  if (estimate.cases.empty()) return "No contradiction in the test of all rows together: ";
  return fmt::format("No contradiction in {} equation{} tested: ", tested, tested == 1 ? "" : "s");
}

std::string percent(const EstimatedValue& v) {
  return v.name + " to " + report::format_number(100 * relative(v), 2) + " %";
}

}  // namespace

std::string verdict_sentence(const Estimate& estimate, const ComparedInTime& in_time) {
  const Known known = known_of(estimate);
  std::string text = tested_text(estimate);
  text += known.all == 0 ? "all parameters were given"
                         : fmt::format("{} of {} parameters ha{} a number", known.numbers, known.all,
                                       known.numbers == 1 ? "s" : "ve");
  if (known.sharpest) text += ", " + percent(*known.sharpest);
  if (known.bluntest != known.sharpest) text += " at best and " + percent(*known.bluntest) + " at worst";
  if (known.doubtful > 0)
    text += fmt::format("; {} of them {} doubtful", known.doubtful, known.doubtful == 1 ? "is" : "are");
  if (in_time.not_white > 0)
    text += fmt::format(
        "; compared in time, {} of {} record{} leave{} what is not white: motion that the model does not make, or "
        "coloured noise",
        in_time.not_white, in_time.records, in_time.records == 1 ? "" : "s", in_time.not_white == 1 ? "s" : "");
  return text + ".";
}

report::Tone verdict_tone(const Estimate& estimate, const ComparedInTime& in_time) {
  const Known known = known_of(estimate);
  if (known.all > 0 && known.numbers == 0) return report::Tone::bad;
  const bool says_little = equations_tested(estimate) == 0 || 2 * known.numbers < known.all;
  return worst_misfit(estimate) || known.doubtful > 0 || says_little || in_time.not_white > 0
             ? report::Tone::caution
             : report::Tone::good;
}

}  // namespace secular

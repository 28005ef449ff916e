#include "thresholds_page.hpp"

#include <algorithm>
#include <sstream>
#include <string_view>
#include <utility>
#include <variant>

#include "diagnose/thresholds_list.hpp"
#include "estimator/thresholds_list.hpp"
#include "measure/thresholds_list.hpp"
#include "motion/thresholds_list.hpp"

namespace secular::architecture {
namespace {

constexpr std::string_view head = R"(# Thresholds

Numbers that decide results and that no formula gives. `measure/thresholds.hpp`, `estimator/thresholds.hpp`,
`motion/thresholds.hpp` and `diagnose/thresholds.hpp` hold them; this page is made from the lists beside these structs:

```sh
cmake --build build/release --target draw_thresholds && build/release/tests/draw_thresholds docs/thresholds.md
```

| kind | meaning |
|---|---|
| alarm | the probability that something is said which is not there; where the number is one of standard deviations or of chi-squared, the column of sources states the probability |
| tuned | chosen because it works; "no record": not known on which draws |

Two kinds are not here. **Derived** numbers stand beside their formula in the file that uses them. **Rounding** is what
arithmetic or an iteration leaves, far below any error bar, and stands where it occurs. Sizes of buffers and of blocks of
samples, limits of file formats, grids that a search begins on and numbers of iterations are no thresholds; nor are the
options of `secular modal` (`measure/modal/modal_survey.hpp`, `stabilisation.hpp`), which a user sees.

Tests alone change the values (`tests/changed_thresholds.hpp`). `SlowThresholds` (`test_identification`) multiplies each tuned
one of `measure/` and `estimator/` by 1/2 and by 2 and prints what moves.

Of 781 campaigns of the blind check's structures (30 and 40 dB, three in four disturbed by lot) none notices these, by
half or by twice: `rarest_share`, `same_sample`, `two_level_share`, `coarse_levels`, `smallest_offset`, `decayed_share`,
`dwell_drift`, `repeats_of_short_decays`, `frequency_prior_sd`, `noise_ratio`. These draws hold no odd time stamps, no
clipped channels and no modes that come to rest, which half of them are for.
)";

template <typename Values>
void print(std::ostream& out, const Threshold<Values>& t) {
  const Values values;
  out << "| `" << t.name << "` | ";
  std::visit([&](auto member) { out << values.*member; }, t.value);
  out << " | " << t.unit << " | " << t.what << " | " << t.source << " | " << t.where << " |\n";
}

template <typename List>
void print(std::ostream& out, std::string_view folder, const List& list) {
  for (const auto& [kind, title] :
       {std::pair{ThresholdKind::alarm, "alarm levels"}, std::pair{ThresholdKind::tuned, "tuned"}}) {
    const auto count = std::count_if(list.begin(), list.end(), [&](const auto& t) { return t.kind == kind; });
    if (count == 0) continue;
    out << "\n## " << folder << "/: " << title << " (" << count << ")\n\n";
    out << "| name | value | unit | what it decides | source | where |\n|---|---|---|---|---|---|\n";
    for (const auto& t : list)
      if (t.kind == kind) print(out, t);
  }
}

}  // namespace

std::string thresholds_page() {
  std::ostringstream out;
  out << head;
  print(out, "measure", measure_threshold_list);
  print(out, "estimator", estimator_threshold_list);
  print(out, "motion", motion_threshold_list);
  print(out, "diagnose", diagnose_threshold_list);
  return out.str();
}

}  // namespace secular::architecture

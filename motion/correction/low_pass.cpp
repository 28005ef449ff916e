#include "motion/correction/low_pass.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "estimator/thresholds.hpp"
#include "measure/observe/observed_blocks.hpp"

namespace secular {
namespace {

const Observation* first_of(std::span<const ObservationSet> sets, std::string_view resonance, std::size_t record) {
  for (const ObservationSet& set : sets)
    if (set.resonance->name == resonance)
      for (const Observation& o : set.observations)
        if (o.record == record) return &o;
  return nullptr;
}

}  // namespace

std::optional<EqualPoles> shared_low_pass(std::span<const CaseLateness> lateness,
                                          std::span<const ObservationSet> measured) {
  double least = INFINITY, most = 0, sum = 0, frequencies = 0;
  std::size_t early = 0, records = 0;
  for (const CaseLateness& here : lateness) {
    if (here.finding != PhaseFinding::late) continue;
    for (const RecordLateness& record : here.records) {
      const Observation* o = first_of(measured, here.resonance, record.record);
      if (o == nullptr) continue;
      // Whole periods of the excitation are no more than a choice.
      const double late = std::remainder(record.late_s, record.period_s);
      const double w = late < 0 ? o->excitation_frequency.front() : o->rate[largest_mode(*o)].imag();
      if (std::abs(w * late) >= 0.5 * std::numbers::pi) return std::nullopt;
      early += late < 0 ? 1 : 0;
      least = std::min(least, std::abs(late));
      most = std::max(most, std::abs(late));
      sum += late;
      frequencies += w;
      ++records;
    }
  }
  if (records < 2 || (early > 0 && early < records)) return std::nullopt;
  const auto count = static_cast<double>(records);
  const double at_random = std::pow(1 - least / most, count - 1);
  const double counts = 1 - at_random / estimator_thresholds().sign_alarm;
  if (!(counts > 0)) return std::nullopt;
  EqualPoles filter;
  filter.late_s = counts * sum / count;
  filter.frequency = frequencies / count;
  return filter;
}

}  // namespace secular

#include "measure/data/table_repeats.hpp"

#include <fmt/format.h>

#include <cmath>
#include <map>

#include "input/input_error.hpp"
#include "measure/thresholds.hpp"

namespace secular {
namespace {

/// Relative, within which repeats of a setting are the same.
constexpr auto& same_frequency = measure_thresholds().same_setting;
constexpr auto& same_level = measure_thresholds().same_level;

}  // namespace

void require_repeats(const std::vector<LineRow>& rows, std::size_t excitation, const std::string& file) {
  std::map<long long, const LineRow*> first;
  for (const LineRow& row : rows) {
    if (!row.condition) continue;
    const LineRow& before = *first.try_emplace(*row.condition, &row).first->second;
    const double level = std::abs(row.find(excitation, {})->amplitude),
                 level_before = std::abs(before.find(excitation, {})->amplitude);
    if (std::abs(row.frequency_hz - before.frequency_hz) > same_frequency * before.frequency_hz ||
        std::abs(level - level_before) > same_level * level_before)
      throw InputError(
          file, row.place,
          fmt::format("condition {} is at {:.6g} Hz with level {:.4g}, in {} it is at {:.6g} Hz with level {:.4g}",
                      *row.condition, row.frequency_hz, level, before.place, before.frequency_hz, level_before),
          "rows with one label are repeats, of one frequency and level; without repeats leave the column out, or "
          "call it otherwise");
  }
}

}  // namespace secular

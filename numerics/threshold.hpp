#pragma once

#include <cstddef>
#include <string_view>
#include <variant>

namespace secular {

/// Kinds of the numbers that decide results. Two more stay beside the code that uses them, where their formula is:
/// derived ones, and rounding (what arithmetic or an iteration leaves, far below any error bar). Sizes of buffers
/// and tables, limits of file formats and numbers of iterations are no thresholds.
enum class ThresholdKind {
  alarm,  ///< the probability that something is said which is not there
  tuned,  ///< chosen because it works
};

/// One of the numbers of a struct of thresholds.
template <typename Values>
struct Threshold {
  std::string_view name;
  std::variant<double Values::*, std::size_t Values::*, std::ptrdiff_t Values::*> value;
  ThresholdKind kind;
  std::string_view unit, what, source, where;
};

/// The values of a struct of thresholds that are in use. Tests alone change them (tests/changed_thresholds.hpp),
/// and only while no other thread runs: threads read them without a lock.
template <typename Values>
inline constinit Values thresholds_in_use{};

}  // namespace secular

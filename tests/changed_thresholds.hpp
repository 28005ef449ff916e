#pragma once

#include <algorithm>
#include <cmath>
#include <type_traits>
#include <variant>

#include "numerics/threshold.hpp"

namespace secular::testing_support {

/// Changes thresholds until it goes. For the one thread that runs: `thresholds_in_use`.
template <typename Values>
class ChangedThresholds {
 public:
  ChangedThresholds() = default;
  ChangedThresholds(const ChangedThresholds&) = delete;
  ChangedThresholds& operator=(const ChangedThresholds&) = delete;
  ~ChangedThresholds() { thresholds_in_use<Values> = before_; }

  Values* operator->() { return &thresholds_in_use<Values>; }

  /// By a factor; a number of things stays one or more.
  void multiply(const Threshold<Values>& threshold, double factor) {
    std::visit(
        [&](auto member) {
          auto& value = thresholds_in_use<Values>.*member;
          using Number = std::remove_reference_t<decltype(value)>;
          if constexpr (std::is_same_v<Number, double>)
            value *= factor;
          else
            value = std::max(Number{1}, static_cast<Number>(std::lround(static_cast<double>(value) * factor)));
        },
        threshold.value);
  }

 private:
  Values before_ = thresholds_in_use<Values>;
};

}  // namespace secular::testing_support

#include "numerics/spread_by_size.hpp"

#include <algorithm>
#include <numeric>

namespace secular {
namespace {

/// A unit this little short of a part counts as one: by rounding it could hold two middles.
constexpr double nearly = 1 - 1e-9;

}  // namespace

std::vector<std::size_t> spread_by_size(std::span<const double> sizes, std::size_t kept) {
  kept = std::min(kept, sizes.size());
  std::vector<std::size_t> left(sizes.size()), taken;
  std::iota(left.begin(), left.end(), std::size_t{0});
  while (taken.size() < kept) {
    const bool some = std::any_of(left.begin(), left.end(), [&](std::size_t unit) { return sizes[unit] > 0; });
    const auto size_of = [&](std::size_t unit) { return some ? sizes[unit] : 1; };  // nothing: alike
    std::vector<double> sum;
    for (const std::size_t unit : left) sum.push_back((sum.empty() ? 0 : sum.back()) + size_of(unit));
    const std::size_t parts = kept - taken.size();
    const double part = sum.back() / static_cast<double>(parts);
    // No more than there are parts.
    const auto certain = std::stable_partition(left.begin(), left.end(),
                                               [&](std::size_t unit) { return size_of(unit) < nearly * part; });
    if (certain == left.end()) {
      for (std::size_t k = 0; k < parts; ++k) {
        const double middle = (static_cast<double>(k) + 0.5) * part;
        taken.push_back(
            left[static_cast<std::size_t>(std::upper_bound(sum.begin(), sum.end(), middle) - sum.begin())]);
      }
      break;
    }
    taken.insert(taken.end(), certain, left.end());
    left.erase(certain, left.end());
  }
  std::sort(taken.begin(), taken.end());
  return taken;
}

}  // namespace secular

#include "numerics/spread_by_size.hpp"

#include <algorithm>
#include <numeric>

namespace secular {
namespace {

/// A unit this little short of a part counts as one.
constexpr double nearly = 1 - 1e-9;

// The binary digits of part + 1 behind the point, the last one first: 1/2, 1/4, 3/4, 1/8, ...
double place_in(std::size_t part) {
  double place = 0, digit = 0.5;
  for (std::size_t rest = part + 1; rest > 0; rest /= 2, digit /= 2)
    if (rest % 2 == 1) place += digit;
  return place;
}

// Of `left`, one for each of the parts of their sum; sums[i]: of the sizes up to and with that of left[i]. Where a
// place lies in a unit that another one took, the next one that has a size is taken.
std::vector<std::size_t> one_of_each_part(const std::vector<std::size_t>& left, const std::vector<double>& sums,
                                          std::size_t parts) {
  std::vector<std::size_t> taken;
  std::vector<char> is_taken(left.size(), 0);
  const auto is_free = [&](std::size_t i) { return !is_taken[i] && sums[i] > (i == 0 ? 0 : sums[i - 1]); };
  for (std::size_t k = 0; k < parts; ++k) {
    const double place = (static_cast<double>(k) + place_in(k)) * sums.back() / static_cast<double>(parts);
    const auto first = static_cast<std::size_t>(std::upper_bound(sums.begin(), sums.end(), place) - sums.begin());
    std::size_t i = first;
    while (i < left.size() && !is_free(i)) ++i;
    if (i == left.size())
      for (i = first; !is_free(i);) --i;
    is_taken[i] = 1;
    taken.push_back(left[i]);
  }
  return taken;
}

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
      const std::vector<std::size_t> spread = one_of_each_part(left, sum, parts);
      taken.insert(taken.end(), spread.begin(), spread.end());
      break;
    }
    taken.insert(taken.end(), certain, left.end());
    left.erase(certain, left.end());
  }
  std::sort(taken.begin(), taken.end());
  return taken;
}

}  // namespace secular

#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace secular::blind {

/// A stream of random numbers that depends on its seed and number alone, the same for any number of threads.
/// Numbers by splitmix64 (G. L. Steele, D. Lea, C. H. Flood, OOPSLA 2014), written here once more: the check shares
/// no code with what it checks.
class Random {
 public:
  Random(std::uint64_t seed, std::uint64_t stream);

  double uniform(double low, double high);      ///< between them, neither included
  double log_uniform(double low, double high);  ///< both positive
  double sign();                                ///< +1 or -1
  bool chance(double probability);              ///< true with this probability
  std::size_t below(std::size_t count);         ///< 0 .. count - 1
  double gaussian();                            ///< of mean 0 and variance 1; Box and Muller

  template <class T>
  void shuffle(std::vector<T>& items) {
    for (std::size_t i = items.size(); i > 1; --i) std::swap(items[i - 1], items[below(i)]);
  }

 private:
  std::uint64_t next();
  double unit();  // in (0, 1)
  std::uint64_t state_;
  double spare_ = 0;
  bool has_spare_ = false;
};

}  // namespace secular::blind

// Work on several threads.
#include "numerics/in_parallel.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>
#include <string>
#include <vector>

namespace secular {
namespace {

TEST(InParallel, DoesEveryItemOnce) {
  for (const unsigned threads : {0U, 1U, 3U, 64U}) {
    std::vector<int> done(20, 0);
    in_parallel(done.size(), threads, [&](std::size_t i) { ++done[i]; });
    EXPECT_EQ(std::count(done.begin(), done.end(), 1), 20) << threads << " threads";
  }
}

TEST(InParallel, ThrowsWhatTheFirstFailureThrew) {
  for (const unsigned threads : {1U, 4U})
    for (int repeat = 0; repeat < 50; ++repeat) {
      std::string thrown;
      try {
        in_parallel(40, threads, [](std::size_t i) {
          if (i % 10 == 7) throw std::runtime_error(std::to_string(i));
        });
      } catch (const std::runtime_error& error) {
        thrown = error.what();
      }
      EXPECT_EQ(thrown, "7");
    }
}

}  // namespace
}  // namespace secular

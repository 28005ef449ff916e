#pragma once

#include <cstddef>
#include <random>
#include <string>
#include <utility>

#include "tests/campaign/damage.hpp"
#include "tests/campaign/largest_allocation.hpp"
#include "tests/campaign/temporary_folder.hpp"

namespace secular {

/// A fixture that damages valid files at random (seeded) and sees that the outcome is success or an InputError.
class Mutation : public TemporaryFolder {
 protected:
  std::size_t below(std::size_t n) { return static_cast<std::size_t>(random_() % n); }

  std::string damaged(std::string text) { return secular::damaged(std::move(text), random_); }

  // Damages `valid` `rounds` times, stores it as `name` and hands it to `use`; counts what came out.
  template <class Use>
  void run(const std::string& name, const std::string& valid, int rounds, const Use& use) {
    write(name, valid);
    ASSERT_NO_THROW(use());
    for (int round = 0; round < rounds; ++round) {
      const std::string text = damaged(valid);
      write(name, text);
      take_largest_allocation();
      try {
        use();
        ++accepted_;
      } catch (const InputError&) {
        ++refused_;
      } catch (const std::exception& error) {
        FAIL() << "round " << round << ": " << error.what();
      }
      // What a damaged header announces is not believed.
      ASSERT_LE(take_largest_allocation(), 100 * text.size() + (1 << 16)) << "round " << round;
    }
    EXPECT_GT(refused_, rounds / 10);
  }

  std::mt19937_64 random_{20};
  int accepted_ = 0, refused_ = 0;
};

}  // namespace secular

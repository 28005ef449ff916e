// A small sealed set through the program itself.
#include <gtest/gtest.h>

#include <boost/math/distributions/binomial.hpp>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <thread>

#include "blind/run_set.hpp"
#include "blind/score_set.hpp"
#include "blind/sealed_set.hpp"
#include "tests/places.hpp"
#include "tests/process_folder.hpp"

namespace secular::blind {
namespace {

namespace fs = std::filesystem;

const Figure& figure_of(const Score& score, const std::string& part) {
  for (const Figure& f : score.figures)
    if (f.name.find(part) != std::string::npos) return f;
  ADD_FAILURE() << "no figure " << part;
  return score.figures.front();
}

// A figure may miss its target by chance: fewer than one time in a thousand it lies beyond the band that is allowed
// here. A set that is so small that it could never be beyond would show nothing.
void expect_within_band(const Figure& f) {
  const double wanted = f.at_most ? *f.target : 1 - *f.target;
  const auto at_least = [&](double misses) {
    const boost::math::binomial chance(static_cast<double>(f.trials), wanted);
    return misses < 1 ? 1 : boost::math::cdf(boost::math::complement(chance, misses - 1));
  };
  ASSERT_LT(at_least(static_cast<double>(f.trials)), 1e-3) << f.name << ": only " << f.trials << " campaigns";
  const double misses = std::round((f.at_most ? f.value : 1 - f.value) * static_cast<double>(f.trials));
  EXPECT_GT(at_least(misses), 1e-3) << f.name << ": " << misses << " misses of " << f.trials;
}

// The first seed whose five campaigns hold what the figures need, two without a gap and three of one effect of at
// least 3 standard deviations, and are quick: primary resonances, effects without a shape of their own.
constexpr std::uint64_t seed_of_five = 130897;

TEST(SlowBlindCheck, AShortSetKeepsItsTargetsWithinChance) {
  const fs::path folder = testing_support::process_folder() / "secular_blind_check";
  fs::remove_all(folder);
  fs::create_directories(folder);
  if (!help_of_diagnose(testing_support::program())) GTEST_SKIP() << "there is no `secular diagnose`";
  const unsigned threads = std::max(1U, std::thread::hardware_concurrency());
  generate_set(folder, {.campaigns = 5, .seed = seed_of_five, .size = SetSize::short_set, .threads = threads}, {});
  const RunSummary run =
      run_set(folder, {.program = testing_support::program(), .threads = threads, .limit_s = 600}, {});
  for (const FailedCampaign& failed : run.failed)
    ADD_FAILURE() << "campaign " << failed.number << ": " << failed.reason;
  const Score score = score_set(folder);
  expect_within_band(figure_of(score, "false alarm"));
  expect_within_band(figure_of(score, "gap detected"));
  expect_within_band(figure_of(score, "contains the truth (at least"));
  fs::remove_all(folder);
}

}  // namespace
}  // namespace secular::blind

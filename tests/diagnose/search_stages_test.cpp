// Stages of the search for explanations, each by itself, on rows that are a few lines of algebra.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <vector>

#include "diagnose/inference/fits_afresh.hpp"
#include "diagnose/inference/near_fits.hpp"
#include "diagnose/inference/null_fit.hpp"
#include "diagnose/inference/pair_fits.hpp"
#include "diagnose/inference/single_fits.hpp"
#include "tests/diagnose/tone_signal.hpp"

namespace secular {
namespace {

using Eigen::VectorXd;
using testing_support::measured_signal;
using testing_support::readings;
using testing_support::signal_of;
using testing_support::tone_candidates;
using Members = std::vector<std::size_t>;

const std::vector<std::size_t> frequency_alone{0};
const InferenceOptions usual;

std::vector<Screening> screened(const std::vector<double>& gains) {
  std::vector<Screening> all;
  for (const double gain : gains) all.push_back({gain, 0, {}, {}});
  return all;
}

TEST(SingleFits, ThePromisingOnesAreAShareOfTheBestAndMoreThanTheLeast) {
  EXPECT_EQ(promising(screened({5, 1000, 0, 300, 30}), 10, 4), (Members{1, 3, 4}));
  EXPECT_EQ(promising(screened({5, 1000, 0, 300, 30}), 2, 4), (Members{1, 3}));
  EXPECT_EQ(promising(screened({3, 1}), 10, 4), Members{});
  EXPECT_EQ(promising(screened({3, 1, 0}), 10, 0), (Members{0, 1}));
  EXPECT_EQ(promising({}, 10, 0), Members{});
}

TEST(Fitter, GoesFromCoarseErrorsToTrueOnes) {
  Discrepancy discrepancy = measured_signal(signal_of(1, {{2, 0.5}}));
  Fitter fitter(discrepancy, 9, 1);
  const std::vector<LevelFit> fits = fitter.from_coarse_to_fine(signal_of(1.02), {0, 3});
  ASSERT_EQ(fits.size(), finest_level + 1);
  EXPECT_TRUE(fitter.at_true_errors());
  for (std::size_t l = 1; l < fits.size(); ++l) EXPECT_GT(fits[l].fit.chi_squared, fits[l - 1].fit.chi_squared);
  EXPECT_FALSE(fits.back().misses());
  EXPECT_NEAR(fits.back().fit.unknowns(3), 0.5, 0.02);
}

// Of known errors: where wide ones leave too much, no finer ones are tried.
TEST(Fitter, FollowsNoFitThatLeavesTooMuchAmongWideErrors) {
  Discrepancy discrepancy = measured_signal(signal_of(1, {{2, 0.5}}));
  Fitter fitter(discrepancy, 9, 1);
  const double at_level_two = fitter.from_coarse_to_fine(signal_of(1), {0})[2].fit.chi_squared;
  EXPECT_EQ(fitter.from_coarse_to_fine(signal_of(1), {0}, at_level_two / 2).size(), 3U);
  EXPECT_FALSE(fitter.at_true_errors());
}

TEST(Fitter, ReturnsToWhereItWas) {
  Discrepancy discrepancy = measured_signal(signal_of(1, {{2, 0.5}}));
  Fitter fitter(discrepancy, 9, 1);
  fitter.freeze(signal_of(1), 1e-3);
  const Fitter::Place here = fitter.place();
  const double left = fitter.left_by(signal_of(1.01));
  fitter.from_coarse_to_fine(signal_of(1.02), {0});
  EXPECT_NE(fitter.left_by(signal_of(1.01)), left);
  fitter.return_to(here);
  EXPECT_EQ(fitter.left_by(signal_of(1.01)), left);
  EXPECT_EQ(fitter.options().scale_guess, here.scales.all());
}

TEST(NullFit, OfAModelThatHoldsIsAtTrueErrors) {
  Discrepancy discrepancy = measured_signal(signal_of(1));
  const std::vector<Candidate> candidates = tone_candidates();
  ExplanationSearch search(discrepancy, candidates, frequency_alone, usual, 9);
  fit_null(search, signal_of(1.02));
  EXPECT_EQ(search.level, finest_level);
  EXPECT_TRUE(search.null_holds);
  EXPECT_NEAR(search.result.null.fit.unknowns(0), 1, 5e-3);
  EXPECT_EQ(search.result.degrees_of_freedom, readings - 1);
}

// What is missing is looked for among errors that the model can live with.
TEST(NullFit, OfAModelThatMissesStaysAmongWideErrors) {
  Discrepancy discrepancy = measured_signal(signal_of(1, {{0, 3}}));
  const std::vector<Candidate> candidates = tone_candidates();
  ExplanationSearch search(discrepancy, candidates, frequency_alone, usual, 9);
  fit_null(search, signal_of(1.1));
  EXPECT_LT(search.level, finest_level);
  EXPECT_FALSE(search.null_holds);
  EXPECT_FALSE(search.misses(search.result.null.fit));
  settle_null(search, search.result.null);  // what it is asked for may be the null itself
  EXPECT_EQ(search.level, finest_level);
  EXPECT_TRUE(search.misses(search.result.null.fit));
}

std::set<Members> fitted_members(const ExplanationSearch& search) {
  std::set<Members> all;
  for (const Explanation& e : search.found) {
    Members members = e.members;
    std::sort(members.begin(), members.end());
    all.insert(members);
  }
  return all;
}

TEST(PairFits, TwoThatActTogetherAreFoundAndNoneWhereOneIsEnough) {
  const std::vector<Candidate> candidates = tone_candidates();
  for (const double second : {0.0, 0.4}) {
    Discrepancy discrepancy = measured_signal(signal_of(1, {{2, 0.6}, {5, second}}));
    ExplanationSearch search(discrepancy, candidates, frequency_alone, usual, 9);
    search.level = finest_level;
    search.result.null = search.explain({}, signal_of(1));
    fit_singles(search);
    ASSERT_FALSE(search.found.empty());
    EXPECT_EQ(search.leaves_more_than_noise(search.found.front()), second > 0);
    add_pairs(search);
    if (second > 0) {
      EXPECT_TRUE(fitted_members(search).contains({2, 5}));
      EXPECT_EQ(search.found.front().members.size(), 2U);
      EXPECT_FALSE(search.leaves_more_than_noise(search.found.front()));
    } else {
      for (const Explanation& e : search.found) EXPECT_EQ(e.members.size(), 1U);
    }
  }
}

// Rows that saw a gap say what explains it; where they saw none, what shows first among these rows is tried as
// well.
TEST(NearFits, FollowWhatOtherRowsFoundAndScreenWhereTheyFoundNothing) {
  const std::vector<Candidate> candidates = tone_candidates();
  Discrepancy gap = measured_signal(signal_of(1, {{2, 0.6}, {5, 0.4}})), none = measured_signal(signal_of(1));
  const Inference seen = infer(gap, candidates, signal_of(1), frequency_alone, usual);
  const Inference unseen = infer(none, candidates, signal_of(1), frequency_alone, usual);
  for (const Inference* near : {&seen, &unseen}) {
    ExplanationSearch search(gap, candidates, frequency_alone, usual, 9);
    fit_near(search, *near);
    EXPECT_EQ(search.level, finest_level);
    EXPECT_EQ(search.result.linear_gain.size(), candidates.size());
    const bool screened_here =
        std::any_of(search.singles.begin(), search.singles.end(), [](const Screening& s) { return s.gain > 0; });
    EXPECT_EQ(screened_here, near == &unseen);
    add_pairs(search);
    ASSERT_FALSE(search.found.empty());
    Members best = search.found.front().members;
    std::sort(best.begin(), best.end());
    EXPECT_EQ(best, (Members{2, 5}));
  }
}

TEST(PairFits, WhereNoPairIsPossibleSinglesStay) {
  std::vector<Candidate> candidates = tone_candidates();
  for (Candidate& c : candidates)
    c.plausible = [](const VectorXd& unknowns) { return (unknowns.tail(8).array() != 0).count() < 2; };
  Discrepancy discrepancy = measured_signal(signal_of(1, {{2, 0.6}, {5, 0.4}}));
  ExplanationSearch search(discrepancy, candidates, frequency_alone, usual, 9);
  search.result.null = search.explain({}, signal_of(1));
  fit_singles(search);
  const std::set<Members> singles = fitted_members(search);
  add_pairs(search);
  EXPECT_EQ(fitted_members(search), singles);
}

TEST(PairFits, AnOpenLawHasNoPartner) {
  std::vector<Candidate> candidates = tone_candidates();
  candidates[5].open_law = true;
  Discrepancy discrepancy = measured_signal(signal_of(1, {{2, 0.6}, {5, 0.4}}));
  ExplanationSearch search(discrepancy, candidates, frequency_alone, usual, 9);
  search.result.null = search.explain({}, signal_of(1));
  fit_singles(search);
  add_pairs(search);
  for (const Explanation& e : search.found) EXPECT_FALSE(e.members.size() > 1 && has_open_law(e, candidates));
}

// The model's own frequency was taken for the tone that is missing: from there no step leads back.
TEST(FitsAfresh, LeadBackFromWhereTheModelsNumbersRanAway) {
  const std::vector<Candidate> candidates = tone_candidates();
  Discrepancy discrepancy = measured_signal(signal_of(1, {{0, 2}}));
  ExplanationSearch search(discrepancy, candidates, frequency_alone, usual, 9);
  search.level = finest_level;
  search.result.null = search.explain({}, signal_of(1.4));
  search.result.degrees_of_freedom = search.freedom_about_null();
  EXPECT_GT(search.result.null.fit.unknowns(0), 1.3);
  search.found = {search.explain({0}, signal_of(1.4, {{0, 1}}))};
  search.found.front().fit.unknowns(1) = 1;  // any: both are one tone there
  ASSERT_TRUE(search.leaves_more_than_noise(search.found.front()));
  EXPECT_TRUE(begin_afresh(search, signal_of(1.03)));
  EXPECT_FALSE(search.leaves_more_than_noise(search.found.front()));
  EXPECT_NEAR(search.found.front().fit.unknowns(0), 1, 5e-3);
  EXPECT_FALSE(begin_afresh(search, signal_of(1.03)));  // nothing is left to do
}

// Where no effect alone is enough, all is as it was before.
TEST(FitsAfresh, ThatBringNothingLeaveTheSearchAsItWas) {
  const std::vector<Candidate> candidates = tone_candidates();
  Discrepancy discrepancy = measured_signal(signal_of(1, {{2, 0.6}, {5, 0.4}}));
  ExplanationSearch search(discrepancy, candidates, frequency_alone, usual, 9);
  search.level = 1;
  search.freeze_at_level(signal_of(1));
  search.result.null = search.explain({}, signal_of(1));
  search.fitter.freeze(signal_of(1));
  search.result.degrees_of_freedom = search.freedom_about_null();
  search.found = {search.explain({2}, signal_of(1, {{2, 0.5}}))};
  const Explanation before = search.found.front();
  const double left = search.fitter.left_by(signal_of(1));
  EXPECT_FALSE(begin_afresh(search, signal_of(1)));
  EXPECT_EQ(search.found.front().fit.unknowns, before.fit.unknowns);
  EXPECT_EQ(search.fitter.left_by(signal_of(1)), left);
  EXPECT_EQ(search.level, 1U);
}

}  // namespace
}  // namespace secular

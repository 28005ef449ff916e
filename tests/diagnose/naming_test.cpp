// What is named where several explanations compete, on explanations that are made up.
#include "diagnose/verdict/naming.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <deque>
#include <map>
#include <stdexcept>

namespace secular {
namespace {

using Names = std::vector<std::string>;

/// A competition whose explanations change rows of three components by their own columns.
class Competition {
 public:
  Competition() { inference_.null.fit.rows = Eigen::Vector3d(9, 9, 0); }

  // `odds` against the first; `column`: which of the rows it moves.
  void enter(const Names& effects, double odds, int column, std::size_t unknowns = 1) {
    Explanation& e = explanations_.emplace_back();
    e.fit.rows = inference_.null.fit.rows;
    e.fit.rows(column) = 0;
    e.fit.jacobian = Eigen::MatrixXd::Identity(3, 3).col(column);
    e.unknowns = unknowns;
    for (const std::string& effect : effects)
      if (effect != "parameters") e.members.push_back(static_cast<std::size_t>(effect.front() - 'a'));
    rivals_.push_back({&e, std::log(odds), 0, effects, false});
  }

  // Candidate "a" explains more alone than "b", and so on.
  Naming named() {
    for (int i = 0; i < 26; ++i) inference_.linear_gain.push_back(26 - i);
    rank(rivals_);
    return name_effects(rivals_, inference_);
  }

  std::vector<Rival>& rivals() { return rivals_; }

 private:
  Inference inference_;
  std::deque<Explanation> explanations_;
  std::vector<Rival> rivals_;
};

TEST(Naming, ProbabilitiesAreThoseOfTheEvidence) {
  Competition competition;
  competition.enter({"b"}, 1, 0);
  competition.enter({"a"}, 3, 1);
  rank(competition.rivals());
  EXPECT_EQ(competition.rivals()[0].effects, Names{"a"});
  EXPECT_DOUBLE_EQ(competition.rivals()[0].probability, 0.75);
  EXPECT_DOUBLE_EQ(competition.rivals()[1].probability, 0.25);
}

// Whatever rounding makes of their evidence.
TEST(Naming, OfTwoThatDoTheSameTheFirstOfTheCatalogueIsNamed) {
  for (const double odds : {0.9999, 1.0001}) {
    Competition competition;
    competition.enter({"c", "b"}, 1, 0, 2);
    competition.enter({"a", "c"}, odds, 0, 2);
    const Naming naming = competition.named();
    EXPECT_EQ(naming.together, (Names{"a", "c"})) << odds;
  }
  Competition competition;
  competition.enter({"b"}, 1, 0);
  competition.enter({"a"}, 0.9, 1);
  EXPECT_EQ(competition.named().set.front(), "b");
}

TEST(Naming, WhatIsFarLessLikelyIsNotInTheSet) {
  Competition competition;
  competition.enter({"a"}, 1, 0);
  competition.enter({"b"}, 0.2, 1);
  competition.enter({"c"}, 1e-4, 2);
  EXPECT_EQ(competition.named().set, (Names{"a", "b"}));
}

// An effect that cannot be told from the best one stays, however little is left of its prior odds; but a more
// flexible one, of which the best is a limit, does not.
TEST(Naming, WhatCannotBeToldApartStaysUnlessItHasMoreUnknowns) {
  Competition competition;
  competition.enter({"a"}, 1, 0);
  competition.enter({"b"}, 1e-4, 0);
  competition.enter({"c"}, 1e-4, 0, 2);
  competition.enter({"d"}, 1e-4, 1);
  EXPECT_EQ(competition.named().set, (Names{"a", "b"}));
}

// A law of which the best effect is a limit is better by its further unknown alone, 1 in the mean: only a gain that
// chance does not bring once in twenty, 3.84, speaks for its shape.
TEST(Naming, ALawThatContainsTheBestStaysWhereItsShapeIsSeen) {
  for (const auto& [gain, set] : {std::pair{2.0, Names{"a"}}, {5.0, Names{"a", "b"}}}) {
    Competition competition;
    competition.enter({"a"}, 1, 0);
    competition.enter({"b"}, 0.3, 1, 2);
    Rival& general = competition.rivals()[1];
    Explanation better = *general.explanation;
    better.fit.chi_squared = -gain;
    general.explanation = &better;
    general.contains = {"a"};
    EXPECT_EQ(competition.named().set, set) << gain;
  }
}

// A law whose limit is far less likely, but only where few conditions say so; what is no limit of it is not asked
// about.
TEST(Naming, TheLimitOfALawStaysUntilTheLawIsShown) {
  for (const bool shown : {true, false}) {
    Competition competition;
    competition.enter({"hysteresis", "b"}, 1, 0, 2);
    competition.enter({"b", "coulomb_friction"}, 1e-30, 1);
    competition.enter({"b", "quadratic_damping"}, 1e-30, 1);
    competition.enter({"coulomb_friction"}, 1e-30, 1);
    Naming naming;
    naming.set = {"hysteresis"};
    naming.together = {"hysteresis", "b"};
    int asked = 0;
    keep_limits(naming, competition.rivals(), effect_catalogue(), [&](const Explanation&, const Explanation&) {
      ++asked;
      return shown;
    });
    EXPECT_EQ(asked, 1);
    EXPECT_EQ(naming.set, shown ? Names{"hysteresis"} : (Names{"hysteresis", "coulomb_friction"}));
    EXPECT_TRUE(naming.second_or.empty());
  }
}

// Of a gap of 10 the best pair leaves 2, its first effect alone 6: its second closes 4, and 3.6 of that is enough.
TEST(Naming, WhatClosesNearlyAsMuchIsANeighbourOfAnApproximateCause) {
  Competition competition;
  competition.enter({"a", "b"}, 1, 0, 2);
  competition.enter({"a", "c"}, 1e-9, 1, 2);
  competition.enter({"a", "d"}, 1e-9, 2, 2);
  competition.enter({"e", "b"}, 1e-9, 2, 2);  // without "b" alone nobody knows what "a" closes
  competition.enter({"a"}, 1e-9, 2);
  const std::map<Names, double> left = {{{"a", "c"}, 2.3}, {{"a", "d"}, 2.5}, {{"e", "b"}, 2}, {{"a"}, 6}};
  Naming naming = competition.named();
  ASSERT_EQ(naming.together, (Names{"a", "b"}));
  add_neighbours(naming, competition.rivals(), {10, 2, 0.9, 0.8, 0.95}, [&](const Explanation& e) {
    for (const Rival& r : competition.rivals())
      if (r.explanation == &e) return left.at(r.effects);
    return INFINITY * 1.0;
  });
  EXPECT_EQ(naming.set, Names{"a"});
  EXPECT_EQ(naming.second_or, Names{"c"});
}

TEST(Naming, OfTwoTogetherTheOneThatExplainsMoreLeads) {
  Competition competition;
  competition.enter({"d", "b"}, 1, 0);
  competition.enter({"b", "e"}, 0.5, 1);  // in the second's place
  competition.enter({"d", "c"}, 0.2, 2);  // in the first's place
  competition.enter({"e", "c"}, 0.5, 2);  // neither
  competition.enter({"f"}, 0.1, 2);       // alone
  competition.enter({"g"}, 0.001, 2);     // not credible
  const Naming naming = competition.named();
  EXPECT_EQ(naming.set, (Names{"b", "c", "f"}));
  EXPECT_EQ(naming.together, (Names{"b", "d"}));
  EXPECT_EQ(naming.second_or, Names{"e"});
}

TEST(Naming, MovedParametersThatAreEnoughStandAlone) {
  Competition competition;
  competition.enter({"parameters"}, 1, 0);
  competition.enter({"a"}, 0.5, 0);
  EXPECT_EQ(competition.named().set, Names{"parameters"});
}

TEST(Naming, NobodyIsNamedAmongNone) {
  Competition competition;
  EXPECT_THROW(competition.named(), std::invalid_argument);
}

}  // namespace
}  // namespace secular

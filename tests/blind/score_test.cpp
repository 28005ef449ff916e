// Figures of a score, computed by hand.
#include "blind/score.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace secular::blind {
namespace {

using nlohmann::json;

json label(int number, const std::string& kind, double snr, const std::vector<std::string>& effects,
           double sigma = 20, const std::vector<std::string>& same_as = {}) {
  json list = json::array();
  for (const std::string& effect : effects)
    list.push_back({{"effect", effect}, {"sigma", sigma}, {"same_as", same_as}});
  return {{"case", number}, {"kind", kind}, {"family", "primary"}, {"snr_db", snr}, {"effects", list}};
}

Said cause(const std::string& effect, double probability, double closed = 0.9) {
  return what_was_said({{"gap", {{"detected", true}, {"closed", closed}}},
                        {"verdict", "cause"},
                        {"cause", effect},
                        {"set", {effect}},
                        {"causes", {{{"effect", effect}, {"mode", "v"}, {"probability", probability}}}}});
}

const Figure& figure(const Score& score, const std::string& part) {
  for (const Figure& f : score.figures)
    if (f.name.find(part) != std::string::npos) return f;
  ADD_FAILURE() << "no figure " << part;
  return score.figures.front();
}

// Wilson 1927; values of 8 of 10 and 0 of 20 from the formula by hand.
TEST(BlindScore, WilsonInterval) {
  EXPECT_NEAR(wilson(8, 10).low, 0.4901625, 1e-6);
  EXPECT_NEAR(wilson(8, 10).high, 0.9433178, 1e-6);
  EXPECT_NEAR(wilson(0, 20).low, 0, 1e-12);
  EXPECT_NEAR(wilson(0, 20).high, 0.1611252, 1e-6);
}

TEST(BlindScore, ReadsTheContractsDiagnosis) {
  const Said said =
      what_was_said(json::parse(R"({"gap": {"detected": true, "closed": 0.7}, "verdict": "set", "cause": null,
      "set": ["cubic_stiffness", "cubic_inertia"],
      "causes": [{"effect": "cubic_inertia", "mode": "v1", "probability": 0.25},
                 {"effect": "cubic_stiffness", "mode": "v1", "probability": 0.3},
                 {"effect": "cubic_stiffness", "mode": "v2", "probability": 0.2}]})"));
  EXPECT_EQ(said.verdict, "set");
  EXPECT_EQ(said.cause, "cubic_stiffness");
  EXPECT_DOUBLE_EQ(said.probability.at("cubic_stiffness"), 0.5);
  EXPECT_DOUBLE_EQ(said.closed.value(), 0.7);
  for (const char* broken :
       {"{}", "[]", "null", R"({"verdict": "cause"})", R"({"gap": {"detected": true}, "verdict": "perhaps"})",
        R"({"gap": {"detected": true}, "verdict": "cause", "causes": [{"effect": 3}]})"})
    EXPECT_EQ(what_was_said(json::parse(broken)).verdict, "failed") << broken;
}

TEST(BlindScore, FiguresAreThoseComputedByHand) {
  const json sealed = {
      {"labels",
       {label(1, "single", 40, {"cubic_stiffness"}), label(2, "single", 40, {"coulomb_friction"}),
        label(3, "single", 30, {"cubic_inertia"}, 20, {"cubic_stiffness"}), label(4, "none", 30, {}),
        label(5, "none", 30, {}), label(6, "outside", 30, {"septic_stiffness"}),
        label(7, "pair", 30, {"coulomb_friction", "quadratic_stiffness"}),
        label(8, "single", 30, {"sensor_gain"}, 1), label(9, "single", 30, {"clipping"})}}};
  Said right = cause("cubic_stiffness", 0.9);
  Said wrong = cause("hysteresis", 0.6);
  wrong.probability["coulomb_friction"] = 0.3;
  Said set = what_was_said({{"gap", {{"detected", true}}},
                            {"verdict", "set"},
                            {"set", {"cubic_stiffness", "cubic_inertia"}},
                            {"causes",
                             {{{"effect", "cubic_stiffness"}, {"probability", 0.5}},
                              {{"effect", "cubic_inertia"}, {"probability", 0.5}}}}});
  const Said none = what_was_said({{"gap", {{"detected", false}}}, {"verdict", "no_gap"}});
  const Said unknown = what_was_said({{"gap", {{"detected", true}}}, {"verdict", "unknown"}});
  Said pair = cause("coulomb_friction", 0.8);
  pair.probability["quadratic_stiffness"] = 0.55;
  const Said clipping = cause("clipping", 1, 0.8);
  const Score score =
      score_of(sealed, {right, wrong, set, none, cause("drag", 0.5), unknown, pair, none, clipping});
  EXPECT_EQ(score.campaigns, 9u);
  EXPECT_EQ(score.failed, 0u);
  // campaigns 1, 2, 3, 9: all but 2 contain the truth
  EXPECT_DOUBLE_EQ(figure(score, "contains the truth (at least").value, 0.75);
  EXPECT_EQ(figure(score, "contains the truth (at least").trials, 4u);
  // 40 dB: 1 right, 2 wrong; 30 dB: 9 right (3 cannot be told from its look-alike, 8 is too weak)
  EXPECT_DOUBLE_EQ(figure(score, "40 dB").value, 0.5);
  EXPECT_EQ(figure(score, "tell, 30 dB").trials, 1u);
  EXPECT_NEAR(figure(score, "mean probability").value, (0.9 + 0.3 + 1) / 3, 1e-12);
  EXPECT_DOUBLE_EQ(figure(score, "false alarm").value, 0.5);
  EXPECT_TRUE(figure(score, "false alarm").at_most);
  // 1, 2, 3, 6, 7, 9 show a gap of at least 3 sigma, and it was seen
  EXPECT_DOUBLE_EQ(figure(score, "gap detected").value, 1);
  EXPECT_EQ(figure(score, "gap detected").trials, 6u);
  EXPECT_DOUBLE_EQ(figure(score, "is called unknown").value, 1);
  EXPECT_DOUBLE_EQ(figure(score, "named as another").value, 0);
  EXPECT_DOUBLE_EQ(figure(score, "both found, 30 dB").value, 1);
  EXPECT_DOUBLE_EQ(figure(score, "gap closed, right cause, 30 dB").value, 0.8);
  EXPECT_NEAR(figure(score, "gap closed, right cause, all").value, 0.85, 1e-12);
  EXPECT_EQ(score.confusion.at("coulomb_friction").at("hysteresis"), 1u);
  EXPECT_EQ(score.confusion.at("no_gap").at("drag"), 1u);
  ASSERT_EQ(score.wrong.size(), 2u);
  EXPECT_EQ(score.wrong[0].number, 2u);
  EXPECT_EQ(score.wrong[0].named, "hysteresis");
  EXPECT_EQ(score.wrong[1].number, 5u);
}

TEST(BlindScore, WithoutTheTruthOnlyWhatTheRestCannotExplainCounts) {
  const json sealed = {
      {"labels",
       {label(1, "single", 30, {"a"}), label(2, "single", 30, {"b"}), label(3, "single", 30, {"c"}),
        label(4, "single", 30, {"d"}), label(5, "single", 30, {"e"}, 1), label(6, "none", 30, {})}}};
  std::vector<Said> said = {cause("a", 1), cause("b", 1), cause("c", 1), cause("d", 1), cause("e", 1), Said{}};
  said[0].verdict_without = "unknown";
  said[1].verdict_without = "cause";
  said[2].verdict_without = "set";
  said[2].explained_by_rest = {"a"};
  said[4].verdict_without = "cause";
  said[0].placebo_closed = 0.02;
  said[1].placebo_closed = -0.01;
  const Score score = score_of(sealed, said);
  // 1 and 2: the rest explains 3, 4 was not tried, 5 is too weak.
  EXPECT_EQ(figure(score, "in turn: called unknown").trials, 2u);
  EXPECT_DOUBLE_EQ(figure(score, "in turn: called unknown").value, 0.5);
  EXPECT_DOUBLE_EQ(figure(score, "in turn: another one is named").value, 0.5);
  EXPECT_NEAR(figure(score, "placebo regressor, 30 dB").value, 0.005, 1e-12);
}

// It names effects, and says that they are not all.
TEST(BlindScore, AnApproximateExplanationNamesAndLeavesOpen) {
  const json sealed = {{"labels",
                        {label(1, "single", 40, {"cubic_stiffness"}), label(2, "single", 40, {"cubic_inertia"}),
                         label(3, "single", 40, {"coulomb_friction"}),
                         label(4, "outside", 30, {"septic_stiffness"}), label(5, "none", 30, {})}}};
  const Said approximate = what_was_said({{"gap", {{"detected", true}, {"closed", 0.95}}},
                                          {"verdict", "approximate"},
                                          {"cause", nullptr},
                                          {"set", {"cubic_stiffness", "cubic_inertia"}},
                                          {"causes",
                                           {{{"effect", "cubic_stiffness"}, {"probability", 1.0}},
                                            {{"effect", "cubic_inertia"}, {"probability", 0.0}}}}});
  const Score score = score_of(sealed, std::vector<Said>(5, approximate));
  EXPECT_NEAR(figure(score, "contains the truth (at least").value, 2.0 / 3, 1e-12);
  EXPECT_NEAR(figure(score, "40 dB").value, 1.0 / 3, 1e-12);  // the first of those that it names
  EXPECT_DOUBLE_EQ(figure(score, "is called unknown").value, 1);
  EXPECT_DOUBLE_EQ(figure(score, "named as another").value, 0);
  EXPECT_DOUBLE_EQ(figure(score, "false alarm").value, 1);
}

TEST(BlindScore, CalibrationCountsEveryStatedProbability) {
  const json sealed = {{"labels", {label(1, "single", 40, {"a"}), label(2, "single", 40, {"b"})}}};
  Said first = cause("a", 0.95), second = cause("c", 0.97);
  second.probability["b"] = 0.02;
  const Score score = score_of(sealed, {first, second});
  const CalibrationBin& top = score.calibration.back();
  EXPECT_EQ(top.stated, 2u);
  EXPECT_EQ(top.right, 1u);
  EXPECT_NEAR(top.mean_stated, 0.96, 1e-12);
  EXPECT_EQ(score.calibration.front().right, 1u);
  const std::string svg = calibration_svg(score.calibration);
  EXPECT_EQ(svg.substr(0, 4), "<svg");
  EXPECT_NE(svg.find("</svg>"), std::string::npos);
  const std::string page = score_markdown(score, "a set");
  EXPECT_NE(page.find("| 2 | primary | b | 20.0 | 40 |  | c |"), std::string::npos) << page;
  EXPECT_EQ(score_json(score)["confusion"]["b"]["c"], 1);
}

TEST(BlindScore, MissingDiagnosesAreFailures) {
  const json sealed = {{"labels", {label(1, "none", 40, {}), label(2, "single", 40, {"a"})}}};
  const Score score = score_of(sealed, {Said{}, Said{}});
  EXPECT_EQ(score.failed, 2u);
  EXPECT_EQ(score.wrong.size(), 2u);
  EXPECT_DOUBLE_EQ(figure(score, "false alarm").value, 1);
}

}  // namespace
}  // namespace secular::blind

// Structures of the blind check with nothing withheld, their campaigns disturbed by lot: no number of `identify`
// may be far off unless it is marked.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <thread>
#include <vector>

#include "blind/case_files.hpp"
#include "blind/random.hpp"
#include "blind/sealed_case.hpp"
#include "blind/sealed_set.hpp"
#include "tests/places.hpp"
#include "tests/process_folder.hpp"

namespace secular::blind {
namespace {

namespace fs = std::filesystem;
std::map<std::string, double> truth_of(const SealedCase& c) {
  std::map<std::string, double> truth;
  Structure own = c.specimen.structure;
  for (std::size_t k = 0; k < own.modes; ++k) truth[c.specimen.frequency_symbols[k]] = own.mode[k].omega;
  for (const OwnTerm& term : c.specimen.own) truth[term.symbol] = *coefficient(own, term.effect, term.mode);
  return truth;
}

struct Number {
  std::string name;
  bool given = false, doubtful = false, held = false;
  double off = 0;  ///< in standard deviations
};

// A campaign's numbers, as a user gets them.
std::vector<Number> identified(std::size_t number, std::uint64_t seed, const fs::path& folder) {
  CasePlan plan;
  plan.number = number + 1;
  plan.kind = "none";
  plan.family = families[number % families.size()];
  Random random(seed, number);
  plan.snr_db = random.chance(0.5) ? 40 : 30;
  plan.disturbed = true;
  SealedCase sealed = draw_case(plan, seed);
  sealed.parameters.clear();
  write_case(sealed, seed, folder);
  const std::string command = testing_support::program() + " identify " + (folder / "campaign").string() +
                              " --model " + (folder / "model.toml").string() + " -o " + (folder / "out").string() +
                              " --threads 1 >/dev/null 2>&1";
  EXPECT_EQ(std::system(command.c_str()), 0) << command;
  const auto estimate = nlohmann::json::parse(read_text(folder / "out/estimate.json"));
  std::vector<Number> numbers;
  for (const auto& [name, truth] : truth_of(sealed)) {
    Number& n = numbers.emplace_back();
    n.name = name;
    for (const auto& value : estimate.at("estimates")) {
      if (value.at("name") != name || !value.contains("value") || value["value"].is_null()) continue;
      n.given = true;
      n.doubtful = value.value("doubtful", false);
      n.off = (value["value"].get<double>() - truth) / value["sd"].get<double>();
      n.held = value["ci95"][0].get<double>() <= truth && truth <= value["ci95"][1].get<double>();
    }
  }
  return numbers;
}

TEST(SlowDisturbedLot, NoNumberIsFarOffUnmarked) {
  constexpr std::size_t campaigns = 12;
  constexpr std::uint64_t seed = 60606;
  const fs::path folder = testing_support::process_folder() / "disturbed_lot";
  std::vector<std::vector<Number>> lot(campaigns);
  in_parallel(campaigns, std::max(1U, std::thread::hardware_concurrency()), [&](std::size_t i) {
    lot[i] = identified(i, seed, case_folder(folder, i + 1));
    fs::remove_all(case_folder(folder, i + 1));
  });
  double asked = 0, given = 0, trusted = 0, held = 0, most = 0;
  for (std::size_t i = 0; i < campaigns; ++i) {
    most = std::max(most, static_cast<double>(lot[i].size()));
    for (const Number& n : lot[i]) {
      ++asked;
      if (!n.given) continue;
      ++given;
      if (n.doubtful) continue;
      ++trusted;
      held += n.held;
      EXPECT_LT(std::abs(n.off), 6) << "campaign " << i << ", " << n.name;
    }
  }
  // Three standard deviations of a binomial count whose numbers go together within a campaign.
  const double band = 3 * std::sqrt(0.05 * 0.95 * trusted * most);
  EXPECT_GE(held, 0.95 * trusted - band) << held << " of " << trusted;
  EXPECT_GE(given, 0.9 * asked) << given << " of " << asked;
  EXPECT_GT(trusted, 0.5 * given) << trusted << " of " << given;
}

}  // namespace
}  // namespace secular::blind

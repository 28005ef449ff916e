// Structures of the blind check with nothing withheld: a generator and an integrator that share no code with the
// estimator, numbers that nobody chose, decays beside dwells, real channels. SECULAR_COVERAGE_STRUCTURES asks for
// more structures of each family than the few of a test run, SECULAR_COVERAGE_DB for another noise than 50 dB below
// the responses, where what the expansion leaves out would be far larger than the error bars.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "blind/sealed_campaign.hpp"
#include "blind/sealed_files.hpp"
#include "jobs/identify/identification.hpp"
#include "numerics/confidence.hpp"
#include "tests/process_folder.hpp"

namespace secular::app {
namespace {

namespace fs = std::filesystem;

double real_from(const char* variable, double usual) {
  const char* text = std::getenv(variable);
  return text ? std::atof(text) : usual;
}

std::map<std::string, double> truth_of(const blind::SealedCampaign& sealed) {
  const blind::Specimen& specimen = sealed.specimen;
  blind::Structure structure = specimen.structure;
  std::map<std::string, double> truth;
  for (const blind::OwnTerm& term : specimen.own)
    truth[term.symbol] = *blind::coefficient(structure, term.effect, term.mode);
  for (std::size_t k = 0; k < specimen.frequency_symbols.size(); ++k)
    truth[specimen.frequency_symbols[k]] = structure.mode[k].omega;
  return truth;
}

struct Count {
  int numbers = 0, missed = 0, doubtful = 0, misfits = 0;
};

void count_values(const Estimate& estimate, const std::map<std::string, double>& truth, Count& count) {
  for (const EstimatedValue& v : estimate.parameters) {
    const auto known = truth.find(v.name);
    if (!v.value || known == truth.end()) continue;
    if (v.doubtful) {
      ++count.doubtful;
      continue;
    }
    const Interval interval = confidence_interval(*v.value, v.sd, v.degrees_of_freedom);
    ++count.numbers;
    count.missed += known->second < interval.low || known->second > interval.high;
  }
}

TEST(SlowDrawnStructures, IntervalsHoldTheTruth) {
  const int structures = static_cast<int>(real_from("SECULAR_COVERAGE_STRUCTURES", 3));
  Count all;
  std::vector<double> misfit_f;
  for (const std::string& family : blind::families_of(blind::Programme::dwells)) {
    Count here;
    for (int number = 1; number <= structures; ++number) {
      blind::CampaignPlan plan;
      plan.number = static_cast<std::size_t>(number);
      plan.kind = "none";
      plan.family = family;
      plan.snr_db = real_from("SECULAR_COVERAGE_DB", 50);
      plan.dwells = 40;
      const blind::SealedCampaign sealed = blind::draw_campaign(plan, 9);
      const fs::path place = testing_support::process_folder() / family;
      blind::write_sealed(sealed, 9, place);
      IdentificationRequest request;
      request.model = (place / "model.toml").string();
      request.threads = 2;
      const Estimate estimate = identify(request, read_campaign(place / "campaign")).estimate;
      bool misfit = false;
      for (const CaseLackOfFit& of_case : estimate.lack_of_fit)
        for (const LackOfFit& test : of_case.equations) {
          misfit_f.push_back(test.f);
          misfit = misfit || test.significant;
        }
      const int doubtful = here.doubtful;
      count_values(estimate, truth_of(sealed), here);
      if (misfit || here.doubtful > doubtful)
        std::printf("%s %d: %d doubtful%s\n", family.c_str(), number, here.doubtful - doubtful,
                    misfit ? ", a significant lack of fit" : "");
      all.misfits += misfit;
    }
    std::printf("%-22s %4d numbers, %5.1f %% of their intervals hold the truth, %d more are doubtful\n",
                family.c_str(), here.numbers, 100.0 * (here.numbers - here.missed) / here.numbers, here.doubtful);
    all.numbers += here.numbers;
    all.missed += here.missed;
    all.doubtful += here.doubtful;
  }
  // Numbers of one campaign are not independent: their misses have 1.5 times the binomial variance (0.8 to 1.9 in
  // eight groups of 24 to 40 campaigns). Three standard deviations: of seventy numbers ten may be missed,
  // and intervals of half the length miss twice as many.
  const double expected = 0.05 * all.numbers, sd = std::sqrt(1.5 * 0.95 * expected);
  EXPECT_LT(all.missed, expected + 3 * sd);
  EXPECT_GT(all.numbers, 20 * structures);
  EXPECT_LT(all.doubtful, 0.05 * all.numbers);
  // Models are right, and what is taken out for the truncation is known to less than the noise: F is neither large
  // nor, as it would be if much of that counted as unknown, small.
  EXPECT_LE(all.misfits, 1 + structures / 10);
  std::nth_element(misfit_f.begin(), misfit_f.begin() + static_cast<std::ptrdiff_t>(misfit_f.size() / 2),
                   misfit_f.end());
  EXPECT_NEAR(misfit_f[misfit_f.size() / 2], 1, 0.3);
}

}  // namespace
}  // namespace secular::app

// A whole survey: simulated impacts and free decays whose truth is known.
#include "measure/modal/modal_survey.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <string>

#include "input/input_error.hpp"
#include "measure/modal/modal_mass.hpp"
#include "measure/modal/pole.hpp"
#include "measure/modal/survey_bands.hpp"
#include "tests/campaign/write_campaign.hpp"
#include "tests/modal/structure_campaign.hpp"
#include "tests/process_folder.hpp"

namespace secular {
namespace {

namespace fs = std::filesystem;
using testing_support::CampaignData;
using testing_support::three_mass_structure;

class ModalSurveyOf : public testing::Test {
 protected:
  void SetUp() override {
    folder = testing_support::process_folder() /
             ("secular_modal_" + std::string(testing::UnitTest::GetInstance()->current_test_info()->name()));
    fs::remove_all(folder);
  }
  void TearDown() override { fs::remove_all(folder); }
  void write(const CampaignData& data) const { write_campaign(data.campaign, data.samples, folder); }
  std::string fault(const ModalSurveyOptions& options) const {
    try {
      modal_survey(folder, options);
    } catch (const InputError& error) {
      return error.what();
    }
    return "none";
  }

  fs::path folder;
};

ModalSurveyOptions impact_options() {
  ModalSurveyOptions options;
  options.lowest_hz = 5;
  options.highest_hz = 60;
  options.driving_points["uplx-"] = {"uprx+", -1};
  return options;
}

// Samples that a file holds wrongly are replaced as they are for everybody else: held ones, spikes, and numbers
// that stand for lost ones. What cannot be replaced is told.
TEST_F(ModalSurveyOf, WrongSamplesAreReplaced) {
  ModalSurveyOptions options;
  options.lowest_hz = 5;
  options.highest_hz = 60;
  const CampaignData clean = testing_support::decay_campaign(2, 0.01, 3);
  write(clean);
  const ModalSurvey expected = modal_survey(folder, options);
  ASSERT_EQ(expected.modes.size(), 3u);
  for (const int kind : {0, 1, 2}) {
    CampaignData faulty = clean;
    for (Record& record : faulty.samples)
      for (std::vector<double>& x : record.channels)
        for (std::size_t i = 150; i + 50 < x.size(); i += 97)
          x[i] = kind == 0 ? x[i] + (i % 2 == 0 ? 30 : -25) : kind == 1 ? -999 : x[i - 1];
    fs::remove_all(folder);
    write(faulty);
    const ModalSurvey survey = modal_survey(folder, options);
    ASSERT_EQ(survey.modes.size(), 3u) << kind;
    for (std::size_t r = 0; r < 3; ++r) {
      EXPECT_NEAR(survey.modes[r].natural_frequency_hz, expected.modes[r].natural_frequency_hz, 2e-3)
          << kind << " " << r;
      EXPECT_NEAR(survey.modes[r].damping_ratio, expected.modes[r].damping_ratio, 1e-4) << kind << " " << r;
    }
  }
  CampaignData broken = clean;
  std::fill_n(broken.samples[0].channels[0].begin() + 700, 40, -999.0);
  std::fill_n(broken.samples[0].channels[0].begin() + 900, 40, -999.0);
  std::fill_n(broken.samples[0].channels[0].begin() + 1300, 40, -999.0);
  fs::remove_all(folder);
  write(broken);
  const ModalSurvey survey = modal_survey(folder, options);
  EXPECT_TRUE(std::any_of(survey.warnings.begin(), survey.warnings.end(), [](const std::string& warning) {
    return warning.find("they are used as they are") != std::string::npos;
  }));
}

TEST_F(ModalSurveyOf, ImpactsGiveMassesAndMatrices) {
  write(testing_support::impact_campaign(3, 1e-3, 5));
  const ModalSurvey survey = modal_survey(folder, impact_options());
  const auto truth = three_mass_structure();
  ASSERT_EQ(survey.modes.size(), 3u);
  ASSERT_EQ(survey.references.size(), 3u);
  for (std::size_t r = 0; r < 3; ++r) {
    const std::complex<double> pole = truth.poles(static_cast<Eigen::Index>(r));
    const SurveyMode& mode = survey.modes[r];
    EXPECT_LT(std::abs(mode.pole / pole - 1.0), 1e-5) << r;
    EXPECT_NEAR(mode.damping_ratio / damping_ratio(pole), 1, 2e-3) << r;
    EXPECT_GT(mode.natural_frequency_sd_hz, 0) << r;
    EXPECT_GT(mode.phase_collinearity, 0.999) << r;
    ASSERT_TRUE(mode.mass) << r;
    EXPECT_NEAR(*mode.mass, 1 / truth.shapes.col(static_cast<Eigen::Index>(r)).squaredNorm(), 3e-3) << r;
  }
  EXPECT_FALSE(survey.modes[2].masses[0].used);  // struck in x: hardly moves in y
  const Eigen::MatrixXd shapes = *survey.mass_normalised();
  EXPECT_LT((shapes - truth.shapes).norm(), 0.01);
  const DynamicMatrices found =
      dynamic_matrices(shapes, Eigen::Vector3cd(survey.modes[0].pole, survey.modes[1].pole, survey.modes[2].pole));
  EXPECT_LT((found.mass - truth.mass).norm(), 0.01);
  EXPECT_LT((found.stiffness - truth.stiffness).norm(), 0.01 * truth.stiffness.norm());
}

TEST_F(ModalSurveyOf, BasisIsReadBackByACampaign) {
  const CampaignData data = testing_support::impact_campaign(2, 0, 5);
  write(data);
  const ModalSurvey survey = modal_survey(folder, impact_options());
  std::ifstream old(folder / "campaign.toml");
  std::string text((std::istreambuf_iterator<char>(old)), {});
  old.close();
  std::ofstream(folder / "campaign.toml") << text << "\n" << modal_basis_text(survey);
  const Campaign with_basis = read_campaign(folder);
  ASSERT_TRUE(with_basis.modal_basis);
  EXPECT_EQ(with_basis.modal_basis->modes, (std::vector<std::string>{"v1", "v2", "v3"}));
  const Eigen::MatrixXd shapes = *survey.mass_normalised();
  for (Eigen::Index c = 0; c < 3; ++c)
    for (Eigen::Index r = 0; r < 3; ++r)
      EXPECT_EQ(
          with_basis.modal_basis->mass_normalised_shapes[static_cast<std::size_t>(c)][static_cast<std::size_t>(r)],
          shapes(c, r));
}

// Seven decays, windows and overlap of section 2.2: the lines of Table 2.4 come back within their error bars.
TEST_F(ModalSurveyOf, DecaysGiveTheLinesOfTable24) {
  write(testing_support::decay_campaign(7, 0.05, 11));
  ModalSurveyOptions options;
  options.lowest_hz = 5;
  options.highest_hz = 60;
  options.modes = 3;
  options.window_s = 0.375;
  const ModalSurvey survey = modal_survey(folder, options);
  const auto truth = testing_support::two_mass_tables();
  ASSERT_EQ(survey.modes.size(), 3u);
  for (std::size_t r = 0; r < 3; ++r) {
    const auto row = static_cast<Eigen::Index>(r);
    const SurveyMode& mode = survey.modes[r];
    ASSERT_TRUE(mode.amplitude) << r;
    const AmplitudeDependence& line = *mode.amplitude;
    EXPECT_GT(line.windows, 40u);
    EXPECT_TRUE(line.frequency_hz.clustered);
    const auto expect_near = [&](double value, double exact, double sd, double least) {
      EXPECT_LT(std::abs(value - exact), std::max(4 * sd, least)) << r << ": " << value << " for " << exact;
    };
    expect_near(line.frequency_hz.intercept, truth.frequency_hz(row), line.frequency_hz.intercept_sd, 1e-4);
    expect_near(line.frequency_hz.slope, testing_support::frequency_slopes(row), line.frequency_hz.slope_sd, 1e-4);
    expect_near(line.damping_factor_hz.intercept, truth.damping_factor_hz(row), line.damping_factor_hz.intercept_sd,
                2e-4);
    expect_near(line.damping_factor_hz.slope, testing_support::damping_slopes(row), line.damping_factor_hz.slope_sd,
                1e-4);
    EXPECT_LT(line.frequency_hz.intercept_sd, 2e-3);
    Eigen::Vector3d shape = truth.shapes.col(row);
    EXPECT_LT((mode.shape.mean.real() - shape).norm(), 4e-3);
    EXPECT_EQ(mode.shape.windows, line.windows);
  }
}

TEST_F(ModalSurveyOf, MassesMayBeGiven) {
  write(testing_support::decay_campaign(2, 0.02, 3));
  ModalSurveyOptions options;
  options.highest_hz = 60;
  options.modes = 3;
  options.modal_masses = {0.523, 0.548, 0.523};
  const ModalSurvey survey = modal_survey(folder, options);
  ASSERT_TRUE(survey.mass_normalised());
  EXPECT_NEAR((*survey.mass_normalised())(0, 0), 1.1603, 0.01);
  options.modal_masses = {0.5};
  EXPECT_NE(fault(options).find("1 masses for 3 modes"), std::string::npos) << fault(options);
  options.modal_masses = {0.5, -1, 0.5};
  EXPECT_NE(fault(options).find("not positive"), std::string::npos) << fault(options);
  options.modal_masses.clear();
  EXPECT_THROW(modal_basis_text(modal_survey(folder, options)), InputError);
}

TEST_F(ModalSurveyOf, SaysWhatDoesNotFit) {
  CampaignData data = testing_support::decay_campaign(1, 0.02, 3, 2);
  data.campaign.records[0].kind = RecordKind::broadband;
  write(data);
  EXPECT_NE(fault({}).find("free_decay or impact"), std::string::npos) << fault({});
  fs::remove_all(folder);
  data.campaign.records[0].kind = RecordKind::free_decay;
  write(data);
  ModalSurveyOptions options;
  options.highest_hz = 128;
  EXPECT_NE(fault(options).find("half the sample rate"), std::string::npos) << fault(options);
  options = {};
  options.span.from_s = 1.9;
  EXPECT_NE(fault(options).find("between --from and --to"), std::string::npos) << fault(options);
  options = {};
  options.highest_hz = 2;
  EXPECT_NE(fault(options).find("too short"), std::string::npos) << fault(options);
  options = {};
  options.window_s = 100;
  EXPECT_NE(fault(options).find("does not fit"), std::string::npos) << fault(options);
}

struct Swing {
  double hz, damping, size;
};

// Of three channels with shapes that differ.
CampaignData decay_of(const std::vector<Swing>& swings, double rate, int rows) {
  constexpr double noise = 0.01;
  CampaignData data{testing_support::empty_campaign(rate, false), {}};
  testing_support::Gaussian gaussian(5);
  Record record;
  record.sample_rate_hz = rate;
  record.channels.assign(3, {});
  for (int i = 0; i < rows; ++i)
    for (std::size_t c = 0; c < 3; ++c) {
      double x = noise * gaussian();
      for (std::size_t m = 0; m < swings.size(); ++m) {
        const double omega = 2 * std::numbers::pi * swings[m].hz, t = i / rate;
        const double shape = std::cos(1.0 + 1.3 * static_cast<double>(m * (c + 1)));
        x += shape * swings[m].size * std::exp(-swings[m].damping * omega * t) *
             std::cos(std::sqrt(1 - swings[m].damping * swings[m].damping) * omega * t);
      }
      record.channels[c].push_back(x);
    }
  data.samples.push_back(record);
  RecordEntry entry;
  entry.file = "records/decay.csv";
  entry.kind = RecordKind::free_decay;
  data.campaign.records.push_back(entry);
  return data;
}

// Sampled fast and long: of a slow mode the first thousand rows hold two turns.
const std::vector<Swing> slow_to_fast = {{12, 0.006, 3}, {95, 0.002, 10}, {402, 0.002, 4}, {2200, 0.001, 8}};

// All modes are found as they are from records of their own bands.
TEST_F(ModalSurveyOf, SlowModesOfLongRecordsThatAreSampledFast) {
  write(decay_of(slow_to_fast, 10240, 20480));
  const ModalSurvey survey = modal_survey(folder, {});
  ASSERT_EQ(survey.modes.size(), slow_to_fast.size());
  for (std::size_t m = 0; m < slow_to_fast.size(); ++m) {
    const SurveyMode& mode = survey.modes[m];
    EXPECT_NEAR(mode.natural_frequency_hz, slow_to_fast[m].hz, 4 * mode.natural_frequency_sd_hz) << m;
    EXPECT_NEAR(mode.damping_ratio, slow_to_fast[m].damping, 4 * mode.damping_ratio_sd) << m;
    EXPECT_LT(mode.natural_frequency_sd_hz, 1e-3 * slow_to_fast[m].hz) << m;
  }
  for (const ModeWindow& window : survey.windows) {
    const double hz = slow_to_fast[static_cast<std::size_t>(window.mode)].hz;
    EXPECT_NEAR(std::abs(window.pole) / (2 * std::numbers::pi), hz, 0.05 * hz);
  }
  EXPECT_GT(survey.modes.front().window_s, survey.modes.back().window_s);
}

TEST_F(ModalSurveyOf, TheStrongestOfSlowAndFastModes) {
  write(decay_of(slow_to_fast, 10240, 20480));
  ModalSurveyOptions two;
  two.modes = 2;
  const ModalSurvey strongest = modal_survey(folder, two);
  ASSERT_EQ(strongest.modes.size(), 2u);
  EXPECT_NEAR(strongest.modes[0].natural_frequency_hz, 95, 1);
  EXPECT_NEAR(strongest.modes[1].natural_frequency_hz, 2200, 1);
}

// The fastest band holds no mode; the spectrum is that of the whole band all the same. A window that does not fit
// one band leaves the values of one fit.
TEST_F(ModalSurveyOf, SlowModeAloneOfALongRecord) {
  write(decay_of({{2, 0.01, 5}}, 2048, 16385));
  ModalSurveyOptions options;
  const ModalSurvey survey = modal_survey(folder, options);
  ASSERT_EQ(survey.modes.size(), 1u);
  EXPECT_NEAR(survey.modes.front().natural_frequency_hz, 2, 4 * survey.modes.front().natural_frequency_sd_hz);
  ASSERT_GT(survey.spectrum_hz.size(), 1000);
  EXPECT_NEAR(survey.spectrum_hz(survey.spectrum_hz.size() - 1), 1024, 10);
  options.window_s = 0.005;
  const ModalSurvey one_fit = modal_survey(folder, options);
  ASSERT_EQ(one_fit.modes.size(), 1u);
  EXPECT_TRUE(one_fit.windows.empty());
  EXPECT_FALSE(one_fit.modes.front().amplitude);
}

TEST(SurveyBands, CoverWhatIsAskedForAndOverlap) {
  EXPECT_EQ(survey_bands(most_decay_rows, 1000, 5, 0).size(), 1u);
  for (const double lowest : {0.0, 30.0}) {
    const std::vector<SurveyBand> bands = survey_bands(20 * most_decay_rows, 12800, lowest, 5000);
    ASSERT_EQ(bands.size(), 4u);
    EXPECT_EQ(bands.front().lowest_hz, lowest);
    EXPECT_EQ(bands.back().highest_hz, 5000);
    for (std::size_t b = 0; b + 1 < bands.size(); ++b) {
      EXPECT_LT(bands[b + 1].lowest_hz, bands[b].highest_hz);
      EXPECT_LT(bands[b].highest_hz, bands[b + 1].highest_hz);
    }
  }
  for (const SurveyBand& band : survey_bands(20 * most_decay_rows, 12800, 0, 600))
    EXPECT_LT(band.lowest_hz, band.highest_hz);
  // What lies below what is asked for is not looked at.
  EXPECT_EQ(survey_bands(20 * most_decay_rows, 12800, 2000, 5000).size(), 1u);
}

}  // namespace
}  // namespace secular

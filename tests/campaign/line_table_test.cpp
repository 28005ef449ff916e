// Tables of lines: what their columns mean, and what is said where they do not say it.
#include "measure/data/line_table.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "measure/data/campaign_text.hpp"
#include "measure/data/campaign_writer.hpp"
#include "measure/data/import_tables.hpp"
#include "tests/campaign/temporary_folder.hpp"
#include "tests/campaign/uff_write.hpp"

namespace secular {
namespace {

using Complex = std::complex<double>;

class LineTables : public TemporaryFolder {
 protected:
  void SetUp() override {
    TemporaryFolder::SetUp();
    options_.kind = "lines";
    options_.channels = {"force:excitation:force:N", "tip:response:displacement:m"};
  }

  // The campaign that a table becomes.
  Campaign campaign_of(const std::string& text) {
    options_.files = {write("table.csv", text)};
    return imported();
  }
  Campaign imported() {
    std::filesystem::remove_all(folder_ / "c");
    CampaignWriter writer(folder_ / "c");
    warnings_.clear();
    const ImportedCampaign made =
        import_tables(options_, [&](const Campaign& campaign, const RecordEntry& entry,
                                    const std::vector<LineRow>& rows) { writer.write(campaign, entry, rows); });
    writer.finish(made.campaign);
    for (const std::string& warning : made.warnings) warnings_ += warning + "\n";
    return read_campaign(folder_ / "c");
  }
  std::string complaint(const std::string& text) {
    return refusal([&] { campaign_of(text); });
  }
  static Complex tip(const Campaign& campaign, std::size_t row, LineNumber number = {}) {
    return campaign.records.at(row).row->find(1, number)->amplitude;
  }

  ImportOptions options_;
  std::string warnings_;
};

const std::string plain = "f,force,tip,tip.phase (rad)\n10,2,0.5,0.25\n11,2,0.75,-3\n";

void expect_near(Complex value, Complex expected) {
  EXPECT_NEAR(value.real(), expected.real(), 1e-14 * std::abs(expected));
  EXPECT_NEAR(value.imag(), expected.imag(), 1e-14 * std::abs(expected));
}

TEST_F(LineTables, AreRecordsRowByRow) {
  const Campaign campaign = campaign_of(plain);
  EXPECT_EQ(campaign.sample_rate_hz, 0);
  ASSERT_EQ(campaign.records.size(), 2u);
  EXPECT_EQ(campaign.records[1].file, "records/table.csv:3");
  EXPECT_EQ(campaign.records[1].kind, RecordKind::lines);
  EXPECT_EQ(campaign.records[1].excitation_frequency_hz, 11);
  EXPECT_EQ(campaign.records[1].excitation_amplitude, 2);
  expect_near(tip(campaign, 0), std::polar(0.5, 0.25));
  expect_near(tip(campaign, 1), std::polar(0.75, -3.0));
  EXPECT_TRUE(contains(warnings_, "standard deviation of tip:"));
  EXPECT_EQ(campaign_text(campaign), read("c/campaign.toml"));
}

TEST_F(LineTables, MeanTheSameInEveryConvention) {
  const Campaign campaign = campaign_of(plain);
  const auto same = [&](const std::string& text) {
    const Campaign other = campaign_of(text);
    for (std::size_t row : {0u, 1u}) {
      expect_near(tip(other, row), tip(campaign, row));
      expect_near(other.records[row].row->find(0, {})->amplitude, 2.0);
      EXPECT_NEAR(*other.records[row].excitation_frequency_hz, *campaign.records[row].excitation_frequency_hz,
                  1e-12);
    }
  };
  const auto n = [](double value) { return fmt::format("{}", value); };
  const double degrees = 180 / std::numbers::pi, w = 2 * std::numbers::pi;
  same("freq;force;tip [mm];tip_phase [deg]\n10;2;500;" + n(0.25 * degrees) + "\n11;2;750;" + n(-3 * degrees) +
       "\n");
  same("f (rad/s),force,tip,tip.phase (rad)\n" + n(10 * w) + ",2,0.5,0.25\n" + n(11 * w) + ",2,0.75,-3\n");
  same("f,force,tip,phase (rad)\n10,2,0.5," + n(0.25 + w) + "\n11,2,0.75," + n(-3 + 2 * w) + "\n");  // wrapped
  same("f,force,tip.re,tip.im\n10,2," + n(0.5 * std::cos(0.25)) + "," + n(0.5 * std::sin(0.25)) + "\n11,2," +
       n(0.75 * std::cos(-3)) + "," + n(0.75 * std::sin(-3)) + "\n");
  options_.table.phases = "deg";
  options_.table.phase_sign = "lag";
  options_.table.amplitudes = "rms";
  const double rms = 1 / std::numbers::sqrt2;
  same("f,force,tip,tip.phase\n10," + n(2 * rms) + "," + n(0.5 * rms) + "," + n(-0.25 * degrees) + "\n11," +
       n(2 * rms) + "," + n(0.75 * rms) + "," + n(3 * degrees) + "\n");
  options_.table = {};
  options_.table.amplitudes = "peak_to_peak";
  options_.table.phase_offset_deg = 180;
  options_.amplitudes = {4};
  same("f,tip,tip.phase (rad)\n10,1," + n(0.25 - w / 2) + "\n11,1.5," + n(w / 2 - 3) + "\n");
  options_.table = {};
  options_.table.per_excitation = true;
  options_.table.columns = {"f=hz", "tip=x", "tip.phase=ph"};
  options_.table.phases = "rad";
  options_.amplitudes = {2};
  same("x,ph,hz\n0.25,0.25,10\n0.375,-3,11\n");
}

TEST_F(LineTables, RowsInAnotherOrderAreTheSameRows) {
  const Campaign campaign = campaign_of(plain);
  const Campaign turned = campaign_of("f,force,tip,tip.phase (rad)\n11,2,0.75,-3\n10,2,0.5,0.25\n10,2,0.5,0.25\n");
  ASSERT_EQ(turned.records.size(), 3u);
  EXPECT_EQ(tip(turned, 0), tip(campaign, 1));
  EXPECT_EQ(tip(turned, 1), tip(campaign, 0));
  EXPECT_EQ(tip(turned, 2), tip(campaign, 0));  // two rows at one frequency
  EXPECT_FALSE(turned.records[1].row->condition);
}

TEST_F(LineTables, HoldHarmonicsMeansErrorsAndLabels) {
  const Campaign campaign = campaign_of(
      "f,condition,force,force.sd,tip,tip.phase (deg),tip.sd,tip@3,tip@3.phase (deg),tip@1/2.re,tip@1/2.im,tip@0\n"
      "10,1,2,0.01,0.5,90,0.001,0.1,0,0.2,0.3,-0.4\n10,1,2.1,0.01,0.5,90,0.001,,0,0.2,0.3,-0.4\n");
  expect_near(tip(campaign, 0, {3, 1}), 0.1);
  expect_near(tip(campaign, 0, {1, 2}), Complex(0.2, 0.3));
  expect_near(tip(campaign, 0, {0, 1}), -0.4);
  EXPECT_EQ(campaign.records[1].row->find(1, {3, 1}), nullptr);  // an empty cell: not measured there
  EXPECT_EQ(campaign.records[1].row->find(1, {})->sd, 0.001);
  EXPECT_EQ(campaign.records[1].row->find(0, {})->sd, 0.01);
  EXPECT_EQ(campaign.records[1].row->condition, 1);
  EXPECT_EQ(warnings_, "");
  const Campaign of_phases = campaign_of(
      "f,force,tip,tip.phase (deg),tip.sd,tip.phase_sd (deg)\n10,2,0.5,90,0.003,1\n11,2,0.5,90,0.003,1\n");
  EXPECT_NEAR(*of_phases.records[0].row->find(1, {})->sd,
              std::sqrt((9e-6 + std::pow(0.5 * std::numbers::pi / 180, 2)) / 2), 1e-12);
}

TEST_F(LineTables, WhatTheyStateIsHeldAgainstWhatIsAsked) {
  EXPECT_TRUE(contains(complaint("f,force,tip [g],tip.phase (rad)\n10,2,0.5,0.25\n"), "measures acceleration"));
  EXPECT_TRUE(contains(complaint("f,force,tip [dB],tip.phase (rad)\n10,2,40,0.25\n"), "is in dB"));
  EXPECT_TRUE(contains(complaint("f,force,tip,tip.phase (grad)\n10,2,0.5,0.25\n"), "has the unit 'grad'"));
  EXPECT_TRUE(contains(complaint("f,freq,force,tip,tip.phase (rad)\n10,3,2,0.5,0.25\n"), "both have a name"));
  EXPECT_TRUE(contains(complaint("f,condition,force,tip,tip.phase (rad)\n10,1,2,0.5,0.25\n11,1,2,0.5,0.25\n"),
                       "rows with one label are repeats"));
  EXPECT_TRUE(contains(complaint("f,condition,force,tip,tip.phase (rad)\n10,1,2,0.5,0.25\n10,1,3,0.5,0.25\n"),
                       "rows with one label are repeats"));
  options_.table.frequency_unit = "rad/s";
  EXPECT_EQ(campaign_of("f (Hz),force,tip,tip.phase (rad)\n10,2,0.5,0.25\n").records[0].excitation_frequency_hz,
            10);
  options_.table = {};
  options_.amplitudes = {3};
  EXPECT_TRUE(contains(complaint(plain), "has a column of levels and is given another one"));
}

// A force that is called as frequencies are.
TEST_F(LineTables, AChannelsNameIsNoOtherColumns) {
  options_.channels = {"f:excitation:force:N", "tip:response:displacement:m"};
  const Campaign campaign = campaign_of("freq,f,tip,tip.phase (rad)\n10,2,0.5,0.25\n");
  EXPECT_EQ(campaign.records[0].excitation_frequency_hz, 10);
  EXPECT_EQ(campaign.records[0].excitation_amplitude, 2);
}

TEST_F(LineTables, DamagedRowsAreLeftOutAndNamed) {
  const Campaign campaign =
      campaign_of("f,force,tip,tip.phase (rad)\n10,2,0.5,0.25\n11,2,,0\n0,2,1,0\n12,0,1,0\n13,2,1,nan\n14,2,1,1\n");
  ASSERT_EQ(campaign.records.size(), 2u);
  EXPECT_TRUE(contains(warnings_,
                       "4 of 6 rows left out: line 3: tip is no number; line 4: the frequency is 0; line "
                       "5: force is zero; line 6: tip is no number"));
  EXPECT_TRUE(
      contains(complaint("f,force,tip,tip.phase (rad),tip.sd\n10,2,1,0,-0.1\n"), "deviation of tip is -0.1"));
  EXPECT_TRUE(contains(complaint("f,force,tip,tip.phase (rad)\n10,2,abc,0\n"), "line 2"));
  EXPECT_TRUE(contains(complaint("f,force,tip,tip.phase (rad)\n10,2,-20,0\n"), "not dB"));
  EXPECT_TRUE(contains(complaint("f,force,tip,tip.phase (rad)\n0,2,1,0\n"), "has no row that can be used"));
}

TEST_F(LineTables, SayWhatIsMissing) {
  EXPECT_TRUE(contains(complaint("f,force,tip,tip.phase\n10,2,0.5,0.25\n"), "--phases deg"));
  EXPECT_TRUE(contains(complaint("f,force,tip\n10,2,0.5\n"), "--column tip.phase=VARIABLE"));
  EXPECT_TRUE(contains(complaint("hz,force,tip,phase (rad)\n10,2,0.5,1\n"), "--column f=VARIABLE"));
  EXPECT_TRUE(contains(complaint("f,tip,tip.phase (rad)\n10,0.5,0.25\n"), "write --level"));
  EXPECT_TRUE(contains(complaint("f (km),force,tip,phase (rad)\n10,2,0.5,1\n"), "km"));
  EXPECT_TRUE(contains(complaint("f,force,tip.re\n10,2,0.5\n"), "no imaginary part"));
  options_.table.columns = {"f=omega"};
  EXPECT_TRUE(contains(complaint("omega,force,tip,phase (rad)\n10,2,0.5,1\n"), "--frequency-unit"));
  options_.table.columns = {"toe.phase=f"};
  EXPECT_TRUE(contains(complaint(plain), "belongs to no channel"));
  options_.table = {};
  options_.channels = {"tip:response:displacement:m"};
  EXPECT_TRUE(contains(complaint(plain), "0 excitation channels"));
  options_.channels = {"force:excitation:force:N", "tip:response:displacement:m"};
  options_.sample_rate_hz = 10;
  EXPECT_TRUE(contains(complaint(plain), "--sample-rate"));
}

TEST_F(LineTables, StandInCampaignTomlAsTheyAre) {
  write("c/a.csv", "omega,F,x,ph\n62.83185307179586,2,500,90\n");
  const std::string head =
      "schema = 1\n[[channel]]\nname = \"force\"\nrole = \"excitation\"\nquantity = \"force\"\nunit = \"N\"\n"
      "[[channel]]\nname = \"tip\"\nrole = \"response\"\nquantity = \"displacement\"\nunit = \"m\"\n"
      "[[record]]\nfile = \"a.csv\"\nkind = \"lines\"\n";
  const std::string names = "variables = { f = \"omega\", force = \"F\", tip = \"x\", \"tip.phase\" = \"ph\" }\n";
  write("c/campaign.toml", head + names + "phases = \"deg\"\nfrequency_unit = \"rad/s\"\namplitudes = \"peak\"\n");
  const Campaign campaign = read_campaign(folder_ / "c");
  EXPECT_NEAR(*campaign.records[0].excitation_frequency_hz, 10, 1e-12);
  expect_near(tip(campaign, 0) / Complex(0, 1), 500.0);
  const auto complaint_of = [&](const std::string& record) {
    write("c/campaign.toml", head + record);
    return refusal([&] { read_campaign(folder_ / "c"); });
  };
  EXPECT_TRUE(contains(complaint_of(names + "phases = \"grad\"\n"), "rad or deg"));
  EXPECT_TRUE(contains(complaint_of(names), "frequency_unit = "));
  EXPECT_TRUE(contains(complaint_of(names + "ensemble_s = 1.0\n"), "ensemble_s"));
  write("c/a.csv", "f,force,tip,tip.phase\n10,2,,90\n11,2,1,90\n");
  EXPECT_TRUE(contains(complaint_of("phases = \"deg\"\n"), "line 2: tip is no number"));
  EXPECT_TRUE(contains(complaint_of(""), "write phases = "));
}

TEST_F(LineTables, AreReadFromFrequencyResponseFunctions) {
  UffFunction function;
  function.id_lines[0] = "tip";
  function.type = 4;
  function.ordinate = UffOrdinate::complex_double;
  function.even = false;
  function.count = 2;
  function.abscissa = {18, 0, 0, 0, "Frequency", "Hz"};
  function.numerator = {8, 0, 0, 0, "Displacement", "mm"};
  function.denominator = {13, 0, 0, 0, "Force", "N"};
  function.uneven_abscissa = {10, 11};
  function.real = {100, 200};
  function.imaginary = {-300, 400};
  options_.channels = {"force:excitation:force:N", "tip:response"};
  options_.files = {write("frf.uff", uff_text({function}, UffEncoding::ascii)),
                    write("frf2.uff", uff_text({function}, UffEncoding::ascii))};
  EXPECT_TRUE(contains(refusal([&] { imported(); }), "answers to its level"));
  options_.amplitudes = {2, 4};
  const Campaign campaign = imported();
  ASSERT_EQ(campaign.records.size(), 4u);
  expect_near(tip(campaign, 1), Complex(0.4, 0.8));
  expect_near(tip(campaign, 2), Complex(0.4, -1.2));
  EXPECT_EQ(campaign.records[3].excitation_amplitude, 4);
}

// Whatever stands in a table: numbers, or a message.
TEST_F(LineTables, AreReadOrRefusedWhateverTheyHold) {
  const std::string good =
      "f,condition,force,tip,tip.phase "
      "(deg),tip.sd,tip@3.re,tip@3.im\n10,1,2,0.5,25,0.01,1,2\n11,2,2,0.75,-3,0.01,3,4\n";
  std::mt19937 random(7);
  std::size_t read = 0;
  for (int i = 0; i < 400; ++i) {
    std::string text = good;
    for (auto changes = 1 + random() % 3; changes > 0; --changes) {
      const std::size_t at = random() % text.size();
      constexpr std::string_view letters = "0123456789.,-e@/\nnf \"";
      if (random() % 3 == 0)
        text.erase(at, 1 + random() % 5);
      else
        text[at] = letters[random() % letters.size()];
      if (text.empty()) text = "f";
    }
    try {
      for (const RecordEntry& record : campaign_of(text).records) {
        EXPECT_TRUE(std::isfinite(*record.excitation_frequency_hz)) << text;
        for (const TableLine& line : record.row->lines)
          EXPECT_TRUE(std::isfinite(std::abs(line.amplitude)) && line.sd.value_or(1) > 0) << text;
      }
      ++read;
    } catch (const InputError& error) {
      EXPECT_FALSE(error.wrong().empty());
    }
  }
  EXPECT_GT(read, 40u);
}

}  // namespace
}  // namespace secular

// Responses that carry the base's acceleration: frame = "absolute".
#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "measure/data/campaign.hpp"
#include "tests/app/hardening_oscillator.hpp"
#include "tests/app/program_run.hpp"
#include "tests/campaign/temporary_folder.hpp"
#include "tests/campaign/write_campaign.hpp"

namespace secular {
namespace {

const std::string frame_experiment_text = std::string(testing_support::hardening_oscillator) + R"toml([[dwell]]
frequencies_hz = [19.7, 19.9, 20.0, 20.1, 20.3]
amplitudes = [0.1, 0.4]
ensembles = 3
ensemble_s = 1.0
settle_s = 12.0
)toml";

class AbsoluteFrame : public TemporaryFolder {
 protected:
  void SetUp() override {
    TemporaryFolder::SetUp();
    write("experiment.toml", frame_experiment_text);
    ASSERT_EQ(run("simulate experiment.toml -o relative --seed 1"), 0) << errors_;
    campaign_ = read_campaign(folder_ / "relative");
    for (const RecordEntry& entry : campaign_.records) samples_.push_back(read_record(campaign_, entry));
  }

  int run(const std::string& arguments) {
    const testing_support::Outcome outcome = testing_support::run_program(folder_, arguments);
    output_ = outcome.output;
    errors_ = outcome.errors;
    return outcome.status;
  }

  // Estimates of a campaign, by name: value and standard deviation.
  std::vector<double> estimates(const std::string& campaign) {
    EXPECT_EQ(run("identify " + campaign + " --model duffing --case primary --fix a2=0 --json -o out_" + campaign),
              0)
        << errors_;
    std::vector<double> numbers;
    const nlohmann::json json = nlohmann::json::parse(output_);
    for (const nlohmann::json& estimate : json["estimates"])
      for (const char* key : {"value", "sd"})
        if (estimate["name"] != "a2" && estimate[key].is_number()) numbers.push_back(estimate[key].get<double>());
    return numbers;
  }

  // The base's acceleration in a response.
  void carry(std::size_t channel) {
    campaign_.channels[channel].frame = Frame::absolute;
    for (Record& record : samples_)
      for (std::size_t i = 0; i < record.samples(); ++i) record.channels[channel][i] += record.channels[0][i];
  }

  void expect_the_same(const std::string& changed, const std::string& original) {
    const std::vector<double> expected = estimates(original), found = estimates(changed);
    ASSERT_GE(expected.size(), 8U);
    ASSERT_EQ(found.size(), expected.size());
    for (std::size_t i = 0; i < found.size(); ++i) EXPECT_NEAR(found[i], expected[i], 1e-7 * std::abs(expected[i]));
  }

  // campaign_ with `frame` behind the last response's unit.
  void refuses(const std::string& frame, const std::vector<std::string>& parts) {
    write_campaign(campaign_, samples_, folder_ / "changed");
    std::string text = read("changed/campaign.toml");
    text.insert(text.find("\n", text.rfind("\nunit = ") + 1) + 1, "frame = \"" + frame + "\"\n");
    write("changed/campaign.toml", text);
    for (const std::string command : {"identify changed --model duffing -o out", "inspect changed"}) {
      EXPECT_EQ(run(command), 2) << output_;
      for (const std::string& part : parts) EXPECT_NE(errors_.find(part), std::string::npos) << errors_;
    }
  }

  Campaign campaign_;
  std::vector<Record> samples_;
  std::string output_, errors_;
};

TEST_F(AbsoluteFrame, GivesTheNumbersOfTheRelativeOne) {
  carry(1);
  write_campaign(campaign_, samples_, folder_ / "absolute");
  EXPECT_EQ(read_campaign(folder_ / "absolute").channels[1].frame, Frame::absolute);
  expect_the_same("absolute", "relative");
  EXPECT_EQ(run("inspect absolute"), 0);
  EXPECT_NE(output_.find("m/s^2, absolute"), std::string::npos) << output_;
}

// Two accelerometers on one mode, of which one measures against the base and one in space.
TEST_F(AbsoluteFrame, OfOneResponseOfTwo) {
  const std::vector<std::vector<double>> shapes = {{1.0}, {0.6}};
  campaign_.channels.push_back({"middle", ChannelRole::response, Quantity::acceleration, "m/s^2"});
  campaign_.modal_basis = {{"tip", "middle"}, {"x"}, shapes};
  for (Record& record : samples_) {
    record.channels.push_back(record.channels[1]);
    for (double& a : record.channels[2]) a *= shapes[1][0];
  }
  write_campaign(campaign_, samples_, folder_ / "two");
  carry(2);
  write_campaign(campaign_, samples_, folder_ / "one_absolute");
  expect_the_same("one_absolute", "two");
}

TEST_F(AbsoluteFrame, OfADisplacementIsRefused) {
  campaign_.channels[1].quantity = Quantity::displacement;
  campaign_.channels[1].unit = "m";
  refuses("absolute", {"campaign.toml", "frame", "is absolute for a response that measures displacement",
                       "take the base's displacement out"});
}

TEST_F(AbsoluteFrame, NeedsTheBasesAcceleration) {
  campaign_.channels[0].quantity = Quantity::force;
  campaign_.channels[0].unit = "N";
  refuses("absolute", {"frame", "no one excitation is known to be the base's acceleration",
                       "role = \"excitation\", quantity = \"acceleration\""});
}

TEST_F(AbsoluteFrame, OtherWordsAreRefused) {
  refuses("inertial", {"frame", "is 'inertial'", "relative or absolute"});
}

}  // namespace
}  // namespace secular

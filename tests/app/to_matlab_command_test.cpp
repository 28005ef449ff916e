// `secular to-matlab`: what MATLAB gets of results.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "input/input_error.hpp"
#include "jobs/matlab/mat_text.hpp"
#include "measure/formats/data_file.hpp"
#include "tests/app/program_run.hpp"
#include "tests/process_folder.hpp"

namespace secular::app {
namespace {

namespace fs = std::filesystem;

// Read back by the reader of measured files.
DataFile read_back(const std::string& json, const std::string& name) {
  const fs::path file = testing_support::process_folder() / "converted.mat";
  std::ofstream(file, std::ios::binary) << mat_of_json(json, name, "x.json");
  return read_data_file(file, {}, MissingNumbers::keep_as_nan);
}

std::vector<double> values_of(const DataFile& data, const std::string& name) {
  return data.vector(name).values;
}

TEST(ToMatlab, NumbersComeBackBitByBitUnderTheirNames) {
  const DataFile data = read_back(
      R"({"schema": 1, "value": 0.1, "ci95": [-1e-300, 3.7], "gap": [1, null, 3], "matrix": [[1, 2, 3], [4, 5, 6]],
          "case": "x", "fitted": true, "estimates": [{"name": "a", "value": 2}, {"value": 5, "2nd-sd": 0.3}]})",
      "estimate");
  EXPECT_EQ(values_of(data, "estimate.value"), std::vector{0.1});
  EXPECT_EQ(values_of(data, "estimate.ci95"), (std::vector{-1e-300, 3.7}));
  const std::vector<double> gap = values_of(data, "estimate.gap");
  ASSERT_EQ(gap.size(), 3U);
  EXPECT_NE(gap[1], gap[1]);
  EXPECT_EQ(gap[2], 3);
  EXPECT_EQ(values_of(data, "estimate.estimates(1).value"), std::vector{2.0});
  EXPECT_EQ(values_of(data, "estimate.estimates(2).value"), std::vector{5.0});
  EXPECT_EQ(values_of(data, "estimate.estimates(2).x2nd_sd"), std::vector{0.3});
  const auto row = [&](const char* name) {
    const auto found = std::find_if(data.variables.begin(), data.variables.end(),
                                    [&](const DataVariable& variable) { return variable.name.starts_with(name); });
    return found == data.variables.end() ? std::vector<double>{} : found->values;
  };
  EXPECT_EQ(row("estimate.matrix"), (std::vector{1.0, 2.0, 3.0}));  // the first of its lines
}

TEST(ToMatlab, TheSameTextGivesTheSameBytesAndWhatIsNoJsonIsRefused) {
  const std::string json =
      R"({"name": "Größe 𝛼", "list": [], "mixed": [1, "a", {"b": null}], "flags": [true, false]})";
  const std::string bytes = mat_of_json(json, "my result", "x.json");
  EXPECT_EQ(bytes, mat_of_json(json, "my result", "x.json"));
  EXPECT_TRUE(bytes.starts_with(mat_heading));
  EXPECT_NE(bytes.find("my_result"), std::string::npos);
  EXPECT_THROW(mat_of_json("{\"a\": ", "a", "x.json"), InputError);
}

TEST(ToMatlab, FilesStandBesideTheirResultsAndGoWithThem) {
  const fs::path folder = testing_support::process_folder() / "to_matlab";
  fs::remove_all(folder);
  fs::create_directories(folder);
  const auto run = [&](const std::string& arguments) { return testing_support::run_program(folder, arguments); };
  const std::string predict = "predict duffing --case free --parameters numbers.json -o out";
  std::ofstream(folder / "numbers.json") << R"({"omega0": 10, "mu": 0.02, "a2": 0, "a3": 3, "e": 1})";
  ASSERT_EQ(run(predict).status, 0);
  const auto made = run("to-matlab out");
  EXPECT_EQ(made.status, 0) << made.errors;
  EXPECT_EQ(made.output, "written: out/prediction.mat\n");
  const DataFile data = read_data_file(folder / "out/prediction.mat");
  const auto prediction = nlohmann::json::parse(testing_support::text_of(folder / "out/prediction.json"));
  EXPECT_EQ(values_of(data, "prediction.backbones.points(2).frequency").front(),
            prediction["backbones"][0]["points"][1]["frequency"].get<double>());
  const auto again = run("to-matlab out");
  EXPECT_EQ(again.status, 2);
  EXPECT_NE(again.errors.find("prediction.mat: exists; add --force"), std::string::npos) << again.errors;
  EXPECT_EQ(run("to-matlab out --force --json").output,
            "{\n  \"written\": [\n    \"out/prediction.mat\"\n  ]\n}\n");
  EXPECT_EQ(run(predict + " --force").status, 0);  // a result of the same command, with what was made of it
  EXPECT_FALSE(fs::exists(folder / "out/prediction.mat"));
  std::ofstream(folder / "out/prediction.mat") << "notes of somebody";
  EXPECT_EQ(run(predict + " --force").status, 2);
  EXPECT_EQ(run("to-matlab .").status, 0);  // numbers.json is one, too
  EXPECT_EQ(run("to-matlab nothing").status, 2);
}

}  // namespace
}  // namespace secular::app

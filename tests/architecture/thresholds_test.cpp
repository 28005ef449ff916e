// Thresholds stand in one struct a folder, each with its kind and source, and one page says so.
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <set>
#include <sstream>
#include <string>

#include "diagnose/thresholds_list.hpp"
#include "estimator/thresholds_list.hpp"
#include "folder_rules.hpp"
#include "measure/thresholds_list.hpp"
#include "motion/thresholds_list.hpp"
#include "tests/places.hpp"
#include "thresholds_page.hpp"

namespace secular::architecture {
namespace {

namespace fs = std::filesystem;

std::string text_of(const std::string& file) {
  std::ifstream stream(testing_support::source_folder() / file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// docs/thresholds.md says how to make it again.
TEST(Thresholds, ThePageIsThatOfTheStructs) {
  EXPECT_TRUE(text_of("docs/thresholds.md") == thresholds_page()) << "make it again as docs/thresholds.md says";
}

template <typename List>
void expect_complete(const List& list, const std::string& folder) {
  std::set<std::string_view> names;
  for (const auto& t : list) {
    EXPECT_TRUE(names.insert(t.name).second) << t.name << " is there twice";
    for (const std::string_view text : {t.unit, t.what, t.source, t.where}) EXPECT_FALSE(text.empty()) << t.name;
    std::istringstream files{std::string(t.where)};
    for (std::string file; std::getline(files >> std::ws, file, ',');) {
      std::string text = text_of(folder + "/" + file);
      if (text.empty()) text = text_of(file);
      EXPECT_NE(text.find(folder + "_thresholds()." + std::string(t.name)), std::string::npos)
          << file << " does not use " << t.name;
    }
  }
}

TEST(Thresholds, EachHasItsUnitSourceAndPlace) {
  expect_complete(measure_threshold_list, "measure");
  expect_complete(estimator_threshold_list, "estimator");
  expect_complete(motion_threshold_list, "motion");
  expect_complete(diagnose_threshold_list, "diagnose");
}

/// Nothing but a test may write to them.
TEST(Thresholds, AreChangedByTestsAlone) {
  for (const auto& [folder, allowed] : folder_table())
    for (const fs::directory_entry& entry : fs::directory_iterator(testing_support::source_folder() / folder)) {
      const std::string file = folder + "/" + entry.path().filename().string();
      if (!entry.is_regular_file() || file.ends_with("/thresholds.hpp") || file == "numerics/threshold.hpp")
        continue;
      EXPECT_EQ(text_of(file).find("thresholds_in_use"), std::string::npos) << file;
    }
}

}  // namespace
}  // namespace secular::architecture

// What `cmake --install --component development` (the package `libsecular-dev`) puts somewhere builds other
// programs.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <string>

#include "tests/app/program_run.hpp"
#include "tests/places.hpp"
#include "tests/process_folder.hpp"

namespace secular {
namespace {

namespace fs = std::filesystem;
using testing_support::text_of;

class InstalledLibraries : public testing::Test {
 protected:
  static fs::path folder() { return testing_support::process_folder() / "installed_libraries"; }
  static fs::path headers() { return folder() / "usr/include/secular"; }

  static void SetUpTestSuite() {
    fs::create_directories(folder());
    const fs::path build = fs::path(testing_support::program()).parent_path().parent_path();
    for (const char* const component : {"program", "development"}) {
      const std::string install = "cmake --install '" + build.string() + "' --component " + component +
                                  " --prefix '" + (folder() / "usr").string() + "' > /dev/null";
      ASSERT_EQ(std::system(install.c_str()), 0) << install;
    }
  }
  static void TearDownTestSuite() { fs::remove_all(folder()); }
};

TEST_F(InstalledLibraries, EveryHeaderHasThoseThatItIncludes) {
  static const std::regex include(R"((^|\n)#include "([^"]+)\")");
  std::size_t headers_seen = 0;
  for (const auto& entry : fs::recursive_directory_iterator(headers())) {
    if (entry.path().extension() != ".hpp") continue;
    ++headers_seen;
    const std::string text = text_of(entry.path());
    for (std::sregex_iterator at(text.begin(), text.end(), include); at != std::sregex_iterator(); ++at)
      EXPECT_TRUE(fs::exists(entry.path().parent_path() / (*at)[2].str()) || fs::exists(headers() / (*at)[2].str()))
          << entry.path() << " includes " << (*at)[2];
  }
  EXPECT_GT(headers_seen, 400U);
}

// The pages that are installed lead to one another, to their figures and to the example.
TEST_F(InstalledLibraries, PagesAndTheExampleComeWithTheProgram) {
  const fs::path pages = folder() / "usr/share/doc/secular/docs";
  for (const auto& entry : fs::recursive_directory_iterator(testing_support::source_folder() / "docs"))
    if (entry.is_regular_file()) {
      EXPECT_TRUE(fs::exists(pages / fs::relative(entry.path(), testing_support::source_folder() / "docs")))
          << entry.path();
    }
}

TEST_F(InstalledLibraries, TheExampleOfThePagesIsBuiltAndRuns) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  GTEST_SKIP() << "what is installed of this build needs the sanitizer's flags";
#endif
  const fs::path build = folder() / "build";
  const std::string quoted = " '" + build.string() + "'";
  const std::string configure = "cmake -S '" + (testing_support::source_folder() / "docs/own_program").string() +
                                "' -B" + quoted + " -DCMAKE_PREFIX_PATH='" + (folder() / "usr").string() + "' > '" +
                                (folder() / "log").string() + "' 2>&1";
  ASSERT_EQ(std::system(configure.c_str()), 0) << text_of(folder() / "log");
  const std::string make = "cmake --build" + quoted + " >> '" + (folder() / "log").string() + "' 2>&1";
  ASSERT_EQ(std::system(make.c_str()), 0) << text_of(folder() / "log");
  const std::string run = "'" + (build / "backbone").string() + "' > '" + (folder() / "printed").string() + "'";
  ASSERT_EQ(std::system(run.c_str()), 0);
  // omega0 + 3 a3 a^2/(8 omega0)
  EXPECT_EQ(text_of(folder() / "printed"),
            "peak amplitude 0.005 m: 100.0375 rad/s, decays by 0.5000 1/s\n"
            "peak amplitude 0.010 m: 100.1500 rad/s, decays by 0.5000 1/s\n"
            "peak amplitude 0.015 m: 100.3375 rad/s, decays by 0.5000 1/s\n"
            "peak amplitude 0.020 m: 100.6000 rad/s, decays by 0.5000 1/s\n");
}

}  // namespace
}  // namespace secular

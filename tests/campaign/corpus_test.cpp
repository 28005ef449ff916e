// The kept corpus: small files of every format that the readers accept (valid/) or refuse (damaged/), one folder a
// format. Every file, and seeded mutations of it, ends in success or an InputError.

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <iterator>

#include "tests/campaign/mutation.hpp"
#include "tests/campaign/read_anything.hpp"
#include "tests/places.hpp"

namespace secular {
namespace {

namespace fs = std::filesystem;

const fs::path corpus = testing_support::source_folder() / "tests/campaign/corpus";

std::vector<fs::path> files_of(const fs::path& folder) {
  std::vector<fs::path> files;
  if (!fs::exists(folder)) return files;
  for (const auto& entry : fs::directory_iterator(folder)) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

std::string bytes_of(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

class Corpus : public Mutation, public testing::WithParamInterface<const char*> {};

TEST_P(Corpus, ValidFilesAreReadAndSurviveMutation) {
  const std::vector<fs::path> files = files_of(corpus / GetParam() / "valid");
  ASSERT_FALSE(files.empty());
  for (const fs::path& file : files) {
    SCOPED_TRACE(file.string());
    const std::string name = file.filename().string();
    run(name, bytes_of(file), 60, [&] { read_anything(folder_ / name, GetParam()); });
  }
}

TEST_P(Corpus, DamagedFilesAreRefusedAndSurviveMutation) {
  const std::vector<fs::path> files = files_of(corpus / GetParam() / "damaged");
  ASSERT_FALSE(files.empty());
  for (const fs::path& file : files) {
    SCOPED_TRACE(file.string());
    const std::string name = file.filename().string(), text = bytes_of(file);
    write(name, text);
    EXPECT_THROW(read_anything(folder_ / name, GetParam()), InputError);
    for (int round = 0; round < 20; ++round) {
      write(name, damaged(text));
      try {
        read_anything(folder_ / name, GetParam());
      } catch (const InputError&) {
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Formats, Corpus, testing::Values("csv", "mat", "hdf5", "uff", "lvm", "wav", "campaign"),
                         [](const auto& format) { return std::string(format.param); });

}  // namespace
}  // namespace secular

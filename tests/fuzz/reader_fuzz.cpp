// A libFuzzer target for every reader: the data file (its format is told by content), or campaign.toml where the
// first byte says so. Build with clang:
//   cmake -S . -B build/fuzz -G Ninja -DCMAKE_CXX_COMPILER=clang++ -DSECULAR_FUZZ=ON -DSECULAR_BUILD_TESTS=OFF
//   ninja -C build/fuzz reader_fuzz
//   build/fuzz/tests/fuzz/reader_fuzz -max_len=16384 -max_total_time=600 NEW_FOLDER tests/campaign/corpus/*/valid
//   tests/campaign/corpus/*/damaged

#include <unistd.h>

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "input/input_error.hpp"
#include "tests/campaign/read_anything.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const std::filesystem::path folder =
      std::filesystem::temp_directory_path() / ("secular_reader_fuzz." + std::to_string(::getpid()));
  std::filesystem::create_directories(folder);
  const std::filesystem::path file = folder / "data";
  std::ofstream(file, std::ios::binary)
      .write(reinterpret_cast<const char*>(data), static_cast<std::streamsize>(size));
  for (const char* const format : {"data", "campaign"}) {
    try {
      secular::read_anything(file, format);
    } catch (const secular::InputError&) {  // the only exception that may come out
    }
  }
  return 0;
}

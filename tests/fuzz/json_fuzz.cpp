// A libFuzzer target for files of numbers: an estimate.json or an object of symbol to number. Build as in
// reader_fuzz.cpp, then
//   build/fuzz/tests/fuzz/json_fuzz -max_len=4096 -max_total_time=600 NEW_FOLDER models/predictions
//   tests/fuzz/corpus/json

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>

#include "input/input_error.hpp"
#include "jobs/shared/parameter_file.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    const secular::GivenParameters given =
        secular::parameters_of(std::string(reinterpret_cast<const char*>(data), size), "numbers.json");
    for (const auto* numbers : {&given.values, &given.sd, &given.representative})
      for (const auto& [name, value] : *numbers)
        if (!std::isfinite(value)) std::abort();
  } catch (const secular::InputError&) {  // the only exception that may come out
  }
  return 0;
}

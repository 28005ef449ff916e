// A libFuzzer target for model files: formulas, relations, orders. Build as in reader_fuzz.cpp, then
//   build/fuzz/tests/fuzz/model_fuzz -max_len=4096 -max_total_time=600 -dict=tests/fuzz/model.dict NEW_FOLDER
//   models tests/fuzz/corpus/model

#include <cstddef>
#include <cstdint>
#include <string>

#include "input/input_error.hpp"
#include "perturb/model.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    secular::read_model_text(std::string(reinterpret_cast<const char*>(data), size), "model.toml");
  } catch (const secular::InputError&) {  // the only exception that may come out
  }
  return 0;
}

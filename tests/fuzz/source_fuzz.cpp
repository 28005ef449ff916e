// A libFuzzer target for printed sources: their tables, and their formulas against one derivation. Build as in
// reader_fuzz.cpp, then, from the root of the clone,
//   build/fuzz/tests/fuzz/source_fuzz -max_len=8192 -max_total_time=600 -dict=tests/fuzz/source.dict NEW_FOLDER
//   tests/fuzz/corpus/source

#include <cstddef>
#include <cstdint>
#include <string_view>

#include "input/input_error.hpp"
#include "perturb/model.hpp"
#include "tests/verify/verify_anything.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const secular::Model model = secular::read_model("models/two_mass_mode1.toml");
  static const secular::Derivation derivation = secular::derive(model, model.find_case("principal_parametric"));
  try {
    secular::verify::verify_anything({reinterpret_cast<const char*>(data), size}, derivation);
  } catch (const secular::InputError&) {  // the only exception that may come out
  }
  return 0;
}

// A libFuzzer target for derivations: its bytes choose a model of a small grammar. What is derived is certified,
// and its residual is small by numbers; with one coefficient of it changed, neither is so. Build as in
// reader_fuzz.cpp, then
//   build/fuzz/tests/fuzz/derivation_fuzz -max_len=64 -max_total_time=600 NEW_FOLDER

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <vector>

#include "input/input_error.hpp"
#include "perturb/certificate.hpp"
#include "tests/fuzz/numeric_residual.hpp"

namespace secular::fuzz {
namespace {

[[noreturn]] void fail(const RandomModel& random, const char* what, const NumericResidual& by_numbers) {
  std::fprintf(stderr, "%s; residual %g, terms %g\n%s\n", what, by_numbers.left, by_numbers.terms,
               random.text().c_str());
  std::abort();
}

void expect_both(const RandomModel& random, const Derivation& derivation, bool right) {
  const NumericResidual by_numbers = numeric_residual(random, derivation);
  if (certify(derivation).holds != right)
    fail(random, right ? "not certified" : "certified with a wrong coefficient", by_numbers);
  if (by_numbers.small() != right)
    fail(random, right ? "does not hold by numbers" : "holds by numbers with a wrong coefficient", by_numbers);
}

// Adds a large number to one coefficient beyond eps^0 (which is what the amplitude stands for). Whether there is
// one.
bool spoil_one(Derivation& derivation, Choices& choices) {
  for (std::size_t n = derivation.response[0].size() - 1; n > 0; --n)
    for (std::vector<FieldSeries>* series : {&derivation.response, &derivation.slow_derivative})
      for (FieldSeries& of_mode : *series) {
        Field& field = of_mode[n];
        if (field.empty()) continue;
        auto at = field.terms().begin();
        for (int i = choices.below(static_cast<int>(field.terms().size())); i > 0; --i) ++at;
        const FieldKey key = at->first;
        field.add(key, 1'000'000);
        return true;
      }
  return false;
}

}  // namespace
}  // namespace secular::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace secular;
  const fuzz::RandomModel random = fuzz::random_model({data, size});
  try {
    const Model model = read_model_text(random.text(), "random.toml");
    Derivation derivation = derive(model, model.cases.front());
    fuzz::expect_both(random, derivation, true);
    fuzz::Choices choices(data, size);
    if (fuzz::spoil_one(derivation, choices)) fuzz::expect_both(random, derivation, false);
  } catch (const InputError& error) {
    // Random orders may act nowhere, and random relations may contradict one another.
    if (std::getenv("SECULAR_FUZZ_SHOW") != nullptr) std::fprintf(stderr, "%s\n", error.what());
  }
  return 0;
}

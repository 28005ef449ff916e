#include "app/shared/band_option.hpp"

#include <cmath>
#include <cstdlib>

#include "input/input_error.hpp"

namespace secular::app {

Band parse_band(const std::string& text) {
  const auto refuse = [&](const char* wrong, const char* right) -> InputError {
    return InputError("--band " + text, "", wrong, right);
  };
  const auto number = [&](const std::string& part) {
    char* end = nullptr;
    const double value = std::strtod(part.c_str(), &end);
    if (part.empty() || *end != '\0' || !std::isfinite(value) || value < 0)
      throw refuse("is not LOW:HIGH", "for example --band 20:300");
    return value;
  };
  const std::size_t colon = text.find(':');
  if (colon == std::string::npos) throw refuse("is not LOW:HIGH", "for example --band 20:300");
  const Band band{number(text.substr(0, colon)), number(text.substr(colon + 1))};
  if (!(band.low_hz < band.high_hz)) throw refuse("the band is empty", "LOW must be below HIGH, both in Hz");
  return band;
}

}  // namespace secular::app

#include "app/shared/selection_options.hpp"

#include <cmath>
#include <cstdlib>
#include <vector>

#include "input/input_error.hpp"

namespace secular::app {
namespace {

// LOW:HIGH
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

}  // namespace

void SelectionOptions::add_to(CLI::App& command, SelectionParts parts, CLI::Option* of) {
  std::vector<CLI::Option*> added;
  if (parts.band)
    added.push_back(
        command.add_option("--band", band_, "LOW:HIGH in Hz: nothing of a record counts that lies outside of it"));
  if (parts.span) {
    added.push_back(command.add_option("--from", from_s_, "use every record from this time of its own on, s"));
    added.push_back(command.add_option("--to", to_s_, "use every record up to this time of its own, s"));
  }
  added.push_back(command.add_option("--records", records_,
                                     "use the records whose file matches this shell pattern, with * and ?"));
  for (CLI::Option* option : added)
    if (of) option->needs(of);
}

Window SelectionOptions::window() const {
  Window window;
  if (band_) window.band = parse_band(*band_);
  window.records = records_.value_or(window.records);
  window.from_s = from_s_.value_or(window.from_s);
  window.to_s = to_s_.value_or(window.to_s);
  if (!(window.from_s < window.to_s))
    throw InputError("--from, --to", "", "the window is empty", "--from must be before --to");
  return window;
}

}  // namespace secular::app

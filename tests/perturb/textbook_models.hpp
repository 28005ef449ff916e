#pragma once

#include <string>

namespace secular::textbook {

/// Model text with one mode; `equation` in x, natural frequency w.
inline std::string one_mode(const std::string& equation, const std::string& resonance) {
  return "schema = 1\nname = \"textbook\"\n[[mode]]\ncoordinate = \"x\"\nfrequency = \"w\"\nequation = \"" +
         equation + "\"\n[[case]]\nname = \"c\"\n" + resonance + "\n";
}

}  // namespace secular::textbook

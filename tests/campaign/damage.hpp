#pragma once

#include <algorithm>
#include <cstddef>
#include <random>
#include <string>

namespace secular {

// One to three changes: a byte replaced, removed or repeated, the end cut off, a stretch overwritten.
inline std::string damaged(std::string text, std::mt19937_64& random) {
  const auto below = [&](std::size_t n) { return static_cast<std::size_t>(random() % n); };
  static const std::string telling = "0123456789.,;:-+eE=[]{}\"'\n\r\t #_naif\\";
  for (std::size_t change = below(3) + 1; change > 0 && !text.empty(); --change) {
    const std::size_t at = below(text.size());
    switch (below(6)) {
      case 0:
        text[at] = static_cast<char>(below(256));
        break;
      case 1:
        text[at] = telling[below(telling.size())];
        break;
      case 2:
        text.erase(at, below(8) + 1);
        break;
      case 3:
        text.insert(at, text.substr(at, below(40) + 1));
        break;
      case 4:
        text.resize(at);
        break;
      default:
        for (std::size_t i = at; i < std::min(at + 4, text.size()); ++i)
          text[i] = static_cast<char>(below(2) * 255);
    }
  }
  return text;
}

}  // namespace secular

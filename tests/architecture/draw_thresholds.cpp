// draw_thresholds FILE.md: docs/thresholds.md, from the structs.
#include <cstdio>
#include <fstream>

#include "thresholds_page.hpp"

int main(int count, char** arguments) {
  if (count != 2) {
    std::fputs("usage: draw_thresholds FILE.md\n", stderr);
    return 2;
  }
  std::ofstream file(arguments[1], std::ios::binary);
  file << secular::architecture::thresholds_page();
  return file.flush() ? 0 : 1;
}

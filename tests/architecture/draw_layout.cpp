// draw_layout FILE.svg: the figure of docs/architecture.md, from the includes of the tree.
#include <cstdio>
#include <fstream>

#include "layout_figure.hpp"
#include "tests/places.hpp"

int main(int count, char** arguments) {
  if (count != 2) {
    std::fputs("usage: draw_layout FILE.svg\n", stderr);
    return 2;
  }
  std::ofstream file(arguments[1], std::ios::binary);
  file << secular::architecture::layout_figure(
      secular::architecture::included_folders(secular::testing_support::source_folder()));
  return file.flush() ? 0 : 1;
}

#include "app/program.hpp"

int main(int argc, char** argv) {
  return secular::app::run_program(argc, argv);
}

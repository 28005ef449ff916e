#pragma once

namespace secular::app {

/// Reads the command line and does what it says. Returns the exit status: 0, 1, 2 or 3; whatever goes
/// wrong is said on standard error.
int run_program(int argc, char** argv);

}  // namespace secular::app

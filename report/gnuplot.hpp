#pragma once

#include <string>
#include <string_view>

namespace secular::report {

struct GnuplotOutput {
  std::string svg;      ///< what gnuplot wrote to its standard output
  std::string problem;  ///< empty: it ran, exited with 0 and wrote something
};

/// Runs `gnuplot -d` (no start-up files) on a script, without a shell and in the C locale. The program is
/// $SECULAR_GNUPLOT or else `gnuplot` on the PATH. Never throws for a missing or failing program: says it in
/// `problem`.
GnuplotOutput run_gnuplot(std::string_view script);

}  // namespace secular::report

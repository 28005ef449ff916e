#include "app/shared/progress_line.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>

#include "app/shared/notices.hpp"

namespace secular::app {

void ProgressLine::operator()(std::size_t done, std::size_t total) {
  const std::lock_guard lock(guard_);
  const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - begun_;
  if (is_quiet() || done == 0 || !isatty(STDERR_FILENO) || spent.count() < 2) return;
  const double left = spent.count() * static_cast<double>(total - done) / static_cast<double>(done);
  fmt::print(stderr, "\r{} of {} {}, {:.0f} s left  {}", done, total, things_, left, done == total ? "\n" : "");
}

}  // namespace secular::app

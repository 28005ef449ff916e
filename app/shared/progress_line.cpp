#include "app/shared/progress_line.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>

#include "app/shared/notices.hpp"

namespace secular::app {

void ProgressLine::operator()(std::size_t done, std::size_t total) {
  const std::lock_guard lock(guard_);
  const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - begun_;
  if (is_quiet() || !isatty(STDERR_FILENO) || spent.count() < 2) return;
  // A count that stands still is shown anew twice a second: what has been spent grows.
  if (done == shown_ && done < total && spent.count() < shown_at_ + 0.5) return;
  shown_ = done;
  shown_at_ = spent.count();
  const std::string time = done == 0
                               ? fmt::format("{:.0f} s so far", spent.count())
                               : fmt::format("{:.0f} s left", spent.count() * static_cast<double>(total - done) /
                                                                  static_cast<double>(done));
  fmt::print(stderr, "\r{} of {} {}, {}  {}", done, total, things_, time, done == total ? "\n" : "");
}

}  // namespace secular::app

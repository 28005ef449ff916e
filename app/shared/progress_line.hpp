#pragma once

#include <chrono>
#include <cstddef>
#include <mutex>
#include <string>

namespace secular::app {

/// What is done and the time left, on one line of standard error: on a terminal only, and only after two seconds.
/// Safe to call from several threads.
class ProgressLine {
 public:
  /// `things`: what is counted, in the plural ("records").
  explicit ProgressLine(std::string things) : things_(std::move(things)) {}
  void operator()(std::size_t done, std::size_t total);

 private:
  std::string things_;
  std::mutex guard_;
  std::size_t shown_ = 0;
  double shown_at_ = 0;
  std::chrono::steady_clock::time_point begun_ = std::chrono::steady_clock::now();
};

}  // namespace secular::app

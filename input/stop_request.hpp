#pragma once

#include <atomic>

namespace secular {

/// Leaves a computation that was asked to stop. No std::exception: nobody takes it for a failure and goes on.
struct Stopped {};

/// While it lives, what this thread computes ends with Stopped soon after `stop` has become true (none: it runs to
/// its end). Work that goes on in other threads takes it with it (current()).
class StopScope {
 public:
  explicit StopScope(const std::atomic<bool>* stop) : before_(stop_) { stop_ = stop; }
  ~StopScope() { stop_ = before_; }
  StopScope(const StopScope&) = delete;
  StopScope& operator=(const StopScope&) = delete;

  static const std::atomic<bool>* current() { return stop_; }

 private:
  static inline thread_local const std::atomic<bool>* stop_ = nullptr;
  const std::atomic<bool>* before_;
};

/// Stands in loops whose turns are far shorter than a second. Throws Stopped.
inline void end_if_stopped() {
  const std::atomic<bool>* const stop = StopScope::current();
  if (stop && stop->load(std::memory_order_relaxed)) throw Stopped{};
}

}  // namespace secular

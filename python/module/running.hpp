#pragma once

#include <functional>
#include <optional>
#include <utility>

namespace secular::python {

/// Runs `work` in a thread of its own, without the interpreter's lock, and hands on what it throws. In Python's
/// main thread signals are looked for ten times a second: where their handler raises (Ctrl-C: KeyboardInterrupt),
/// the work is stopped and the exception goes on. One piece of work runs at a time (GiNaC has no locks); each uses
/// the threads that it is asked to.
void run_without_lock(const std::function<void()>& work);

/// What `work` returns.
template <class Work>
auto computed(const Work& work) {
  std::optional<decltype(work())> result;
  run_without_lock([&] { result.emplace(work()); });
  return std::move(*result);
}

}  // namespace secular::python

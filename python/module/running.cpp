#include "python/module/running.hpp"

#include <pybind11/pybind11.h>

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <thread>

#include "input/stop_request.hpp"

namespace py = pybind11;

namespace secular::python {
namespace {

constexpr auto between_looks = std::chrono::milliseconds(100);

// Held by the piece of work that runs.
std::timed_mutex turn;

class RunningWork {
 public:
  explicit RunningWork(const std::function<void()>& work)
      : thread_([this, &work] {
          try {
            const StopScope scope(&stop_);
            std::unique_lock lock(turn, std::defer_lock);
            while (!lock.try_lock_for(between_looks)) end_if_stopped();
            work();
          } catch (...) {
            failure_ = std::current_exception();
          }
          const std::lock_guard lock(guard_);
          done_ = true;
          ended_.notify_one();
        }) {}
  ~RunningWork() {
    stop_ = true;
    const py::gil_scoped_release release;
    thread_.join();
  }
  RunningWork(const RunningWork&) = delete;
  RunningWork& operator=(const RunningWork&) = delete;

  /// Waits for a moment; whether it has ended.
  bool has_ended() {
    const py::gil_scoped_release release;
    std::unique_lock lock(guard_);
    return ended_.wait_for(lock, between_looks, [this] { return done_; });
  }
  void rethrow() const {
    if (failure_) std::rethrow_exception(failure_);
  }

 private:
  std::atomic<bool> stop_ = false;
  std::mutex guard_;
  std::condition_variable ended_;
  bool done_ = false;
  std::exception_ptr failure_;
  std::thread thread_;  // the last: it uses the others
};

}  // namespace

void run_without_lock(const std::function<void()>& work) {
  RunningWork running(work);
  while (!running.has_ended())
    if (PyErr_CheckSignals() != 0) throw py::error_already_set();
  running.rethrow();
}

}  // namespace secular::python

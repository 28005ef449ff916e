#include "numerics/in_parallel.hpp"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

#include "input/stop_request.hpp"

namespace secular {

void in_parallel(std::size_t count, unsigned threads, const std::function<void(std::size_t)>& work) {
  std::atomic<std::size_t> next = 0;
  std::mutex guard;
  std::exception_ptr failure;
  std::size_t failed = count;
  const std::atomic<bool>* const stop = StopScope::current();
  const auto run = [&] {
    for (std::size_t i = next++; i < count; i = next++) try {
        end_if_stopped();
        work(i);
      } catch (...) {
        const std::lock_guard lock(guard);
        if (i < failed) {
          failed = i;
          failure = std::current_exception();
        }
        next = count;
      }
  };
  {
    std::vector<std::jthread> workers;
    for (unsigned i = 1; i < std::min<std::size_t>(threads, count); ++i)
      workers.emplace_back([&] {
        const StopScope scope(stop);
        run();
      });
    run();
  }
  if (failure) std::rethrow_exception(failure);
}

}  // namespace secular

#pragma once

#include <cstddef>
#include <functional>

namespace secular {

/// Calls work(0), ..., work(count - 1), each once, on up to `threads` threads; returns when all are done. `work`
/// must not throw.
void in_parallel(std::size_t count, unsigned threads, const std::function<void(std::size_t)>& work);

}  // namespace secular

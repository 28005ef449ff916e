#pragma once

#include <cstddef>
#include <functional>

namespace secular {

/// Calls work(0), ..., work(count - 1), each once and begun in this order, on up to `threads` threads; returns when
/// all are done. Where one throws, no further one is begun, and the exception of the first that threw (by number, so
/// that it does not depend on the threads) is thrown again.
void in_parallel(std::size_t count, unsigned threads, const std::function<void(std::size_t)>& work);

}  // namespace secular

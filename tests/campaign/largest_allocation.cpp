#include "tests/campaign/largest_allocation.hpp"

#include <malloc.h>

#include <algorithm>
#include <cstdlib>
#include <new>
#include <utility>

namespace {

std::size_t largest = 0;
std::size_t held = 0, peak = 0, base = 0;  // bytes by malloc's count

void* counted(void* memory) {
  held += ::malloc_usable_size(memory);
  peak = std::max(peak, held);
  return memory;
}

void release(void* memory) {
  held -= ::malloc_usable_size(memory);
  std::free(memory);
}

}  // namespace

// The whole test program allocates through these.
void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  largest = std::max(largest, size);
  void* const memory = std::malloc(std::max<std::size_t>(size, 1));
  return memory ? counted(memory) : nullptr;
}

void* operator new(std::size_t size) {
  if (void* const memory = operator new(size, std::nothrow)) return memory;
  throw std::bad_alloc();
}

void operator delete(void* memory) noexcept {
  release(memory);
}

void operator delete(void* memory, std::size_t) noexcept {
  release(memory);
}

namespace secular {

std::size_t take_largest_allocation() {
  return std::exchange(largest, 0);
}

std::size_t take_allocated_peak() {
  const std::size_t above = peak - base;
  base = peak = held;
  return above;
}

}  // namespace secular

// Linked into every program. Matrices of some hundred kB come and go thousands of times a second; by default glibc
// gives the memory of each back to the system, which clears the pages of the next: a fifth of the time of observing
// decays. Here what is freed stays with the program, up to half a GB; larger matrices still come and go.
#include <cstdlib>

#ifdef __GLIBC__
#include <malloc.h>

namespace {

constexpr int largest_kept = 32 << 20, most_kept = 512 << 20;  // bytes; the first is the most that glibc takes

[[maybe_unused]] const bool is_kept =
    mallopt(M_MMAP_THRESHOLD, largest_kept) == 1 && mallopt(M_TRIM_THRESHOLD, most_kept) == 1;

}  // namespace
#endif

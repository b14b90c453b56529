// Allocates large blocks with pages of 2 MB (Linux: madvise, MADV_HUGEPAGE; advice that may be ignored).
// Volumes are allocated, filled and freed by the hundred; zeroing and mapping fresh blocks by pages of 4 KB
// takes a tenth of the time of `prepare`.

#include <malloc.h>
#include <sys/mman.h>

#include <cstdlib>
#include <new>

// The sanitizers bring an operator new of their own.
#if defined(MADV_HUGEPAGE) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)

namespace {

constexpr std::size_t kHugePage = std::size_t(2) << 20;
constexpr std::size_t kLarge = 2 * kHugePage;  // the rounding would dominate smaller blocks

void* allocated(std::size_t size) {
  if (size < kLarge) return std::malloc(size ? size : 1);
  void* block = nullptr;
  if (::posix_memalign(&block, kHugePage, size) != 0) return nullptr;
  ::madvise(block, size / kHugePage * kHugePage, MADV_HUGEPAGE);
  return block;
}

// Large blocks go back to the system when they are freed. By default glibc keeps freed blocks of up to 32 MB,
// which made a quarter of the peak memory of `prepare`.
[[maybe_unused]] const int kIsReturned = ::mallopt(M_MMAP_THRESHOLD, int(kLarge));

}  // namespace

void* operator new(std::size_t size) {
  for (;;) {
    if (void* block = allocated(size)) return block;
    const std::new_handler handler = std::get_new_handler();
    if (!handler) throw std::bad_alloc();
    handler();
  }
}

void operator delete(void* block) noexcept { std::free(block); }
void operator delete(void* block, std::size_t) noexcept { std::free(block); }

#endif

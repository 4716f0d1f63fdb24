/// Large arrays that are filled right after they are made: left as the system gives them, in its huge pages where it has such.
#pragma once

#include <sys/mman.h>

#include <cstddef>
#include <cstdint>
#include <new>
#include <type_traits>
#include <utility>
#include <vector>

namespace gibench::antiradiance {

inline constexpr std::size_t huge_page = std::size_t{2} << 20;  // bytes

/// From a huge page's size on straight from the system, on the border of a huge page, and straight back to it, so that what is
/// free is not kept.
inline void* large_memory(std::size_t bytes, std::size_t alignment) {
  if (bytes < huge_page) return ::operator new (bytes, std::align_val_t{alignment});
  void* const mapped = mmap(nullptr, bytes + huge_page, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  if (mapped == MAP_FAILED) throw std::bad_alloc();
  const auto start = reinterpret_cast<std::uintptr_t>(mapped), aligned = (start + huge_page - 1) / huge_page * huge_page;
  if (aligned > start) munmap(mapped, aligned - start);
  void* const memory = static_cast<std::byte*>(mapped) + (aligned - start);
  madvise(memory, bytes, MADV_HUGEPAGE);  // advice: without it all works, slower
  return memory;
}
inline void release_large_memory(void* memory, std::size_t bytes, std::size_t alignment) {
  if (bytes < huge_page) ::operator delete (memory, std::align_val_t{alignment});
  else munmap(memory, bytes);
}

/// Elements that no value is given for are not written: threads that fill the array are the first to touch its pages.
template <class T>
struct UnwrittenAllocator {
  static_assert(std::is_trivially_copyable_v<T> && alignof(T) <= huge_page);
  using value_type = T;

  UnwrittenAllocator() = default;
  template <class U>
  UnwrittenAllocator(const UnwrittenAllocator<U>& /*other*/) {}

  T* allocate(std::size_t count) { return static_cast<T*>(large_memory(count * sizeof(T), alignof(T))); }
  void deallocate(T* memory, std::size_t count) { release_large_memory(memory, count * sizeof(T), alignof(T)); }

  template <class U>
  void construct(U* /*place*/) {}
  template <class U, class... Arguments>
  void construct(U* place, Arguments&&... arguments) {
    ::new (static_cast<void*>(place)) U(std::forward<Arguments>(arguments)...);
  }

  friend bool operator==(const UnwrittenAllocator& /*a*/, const UnwrittenAllocator& /*b*/) { return true; }
};

template <class T>
using LargeArray = std::vector<T, UnwrittenAllocator<T>>;

}  // namespace gibench::antiradiance

/// Large arrays that are filled right after they are made: left as the system gives them, in its huge pages where it has such.
#pragma once

#include <sys/mman.h>

#include <cstddef>
#include <new>
#include <type_traits>
#include <utility>
#include <vector>

namespace gibench::antiradiance {

inline constexpr std::size_t huge_page = std::size_t{2} << 20;  // bytes

/// Elements that no value is given for are not written: threads that fill the array are the first to touch its pages.
template <class T>
struct UnwrittenAllocator {
  static_assert(std::is_trivially_copyable_v<T> && alignof(T) <= huge_page);
  using value_type = T;

  UnwrittenAllocator() = default;
  template <class U>
  UnwrittenAllocator(const UnwrittenAllocator<U>& /*other*/) {}

  T* allocate(std::size_t count) {
    const std::size_t bytes = count * sizeof(T);
    void* const memory = ::operator new(bytes, alignment(bytes));
    if (bytes >= huge_page) madvise(memory, bytes, MADV_HUGEPAGE);  // advice: without it all works, slower
    return static_cast<T*>(memory);
  }
  void deallocate(T* memory, std::size_t count) { ::operator delete(memory, alignment(count * sizeof(T))); }

  template <class U>
  void construct(U* /*place*/) {}
  template <class U, class... Arguments>
  void construct(U* place, Arguments&&... arguments) {
    ::new (static_cast<void*>(place)) U(std::forward<Arguments>(arguments)...);
  }

  friend bool operator==(const UnwrittenAllocator& /*a*/, const UnwrittenAllocator& /*b*/) { return true; }

 private:
  static std::align_val_t alignment(std::size_t bytes) { return std::align_val_t{bytes >= huge_page ? huge_page : alignof(T)}; }
};

template <class T>
using LargeArray = std::vector<T, UnwrittenAllocator<T>>;

}  // namespace gibench::antiradiance

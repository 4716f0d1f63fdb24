# What the compiler must be able to do, and what it is wrong about.
include(CheckCXXSourceCompiles)

set(CMAKE_REQUIRED_FLAGS -std=c++20)
check_cxx_source_compiles("
  #include <bit>
  #include <concepts>
  #include <numbers>
  #include <span>
  template <std::floating_point T> T twice(T x) { return 2 * x; }
  struct Pair { int a = 0, b = 0; auto operator<=>(const Pair&) const = default; };
  int main() {
    const float numbers[] = {twice(std::numbers::pi_v<float>)};
    const Pair pair{.a = 1, .b = 2};
    return pair == Pair{} ? std::bit_cast<int>(std::span(numbers)[0]) : 0;
  }" GIBENCH_COMPILER_HAS_CXX20)
unset(CMAKE_REQUIRED_FLAGS)
if(NOT GIBENCH_COMPILER_HAS_CXX20)
  gibench_stop("${CMAKE_CXX_COMPILER} ${CMAKE_CXX_COMPILER_VERSION} does not compile C++20: install g++ 12 or clang++ 14 "
          "or later and name it with CXX=g++ or -DCMAKE_CXX_COMPILER=g++ (in a new build folder)")
endif()

# The name of a check becomes a macro of the compiled test: x86-64-v3 is not an identifier.
string(MAKE_C_IDENTIFIER "${GIBENCH_ARCHITECTURE}" architecture)
if(GIBENCH_ARCHITECTURE)
  set(CMAKE_REQUIRED_FLAGS -march=${GIBENCH_ARCHITECTURE})
  check_cxx_source_compiles("int main() {}" GIBENCH_ARCHITECTURE_${architecture}_IS_KNOWN)
  if(NOT GIBENCH_ARCHITECTURE_${architecture}_IS_KNOWN)
    gibench_stop("${CMAKE_CXX_COMPILER} does not know -march=${GIBENCH_ARCHITECTURE}: set GIBENCH_ARCHITECTURE to one that "
            "it knows, or to nothing (-DGIBENCH_ARCHITECTURE=)")
  endif()
  check_cxx_source_compiles("
    #ifndef __AVX512F__
    #error none
    #endif
    int main() {}" GIBENCH_AVX512_${architecture})
  unset(CMAKE_REQUIRED_FLAGS)
endif()

# The intrinsics of AVX-512 start from registers that they leave undefined on purpose, and g++ before 13 warns of that
# wherever Eigen or xxHash inline them (GCC bug 105593).
set(GIBENCH_FALSE_WARNINGS "")
if(GIBENCH_AVX512_${architecture} AND CMAKE_CXX_COMPILER_ID STREQUAL GNU AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
  set(GIBENCH_FALSE_WARNINGS -Wno-maybe-uninitialized -Wno-uninitialized)
endif()

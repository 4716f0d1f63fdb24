/// The library that writes pictures, loaded before the work whose results it writes: where it is missing, no work is lost.
#pragma once

#include <cstdint>

namespace gibench {

/// Its memory is no method's, so it does not count as the run's.
class PictureLibrary {
 public:
  /// InputError where it is missing or cannot be loaded.
  PictureLibrary();

  /// The largest resident memory of this process so far without the library, bytes; 0 where the system does not report it.
  std::uint64_t peak_bytes_without() const;

 private:
  std::uint64_t peak_before_ = 0, taken_ = 0;
};

}  // namespace gibench

/// The rise of resident memory above its present value (Linux).
#pragma once

#include <malloc.h>

#include <fstream>
#include <limits>
#include <string>

namespace gibench::micro {

class PeakMemory {
 public:
  /// Gives back what is free, so that its reuse hides nothing, and forgets the peak so far.
  PeakMemory() {
    malloc_trim(0);
    std::ofstream("/proc/self/clear_refs") << "5";
    before_ = status_bytes("VmRSS:");
  }
  /// Bytes at the highest since then.
  double growth() const { return status_bytes("VmHWM:") - before_; }

 private:
  static double status_bytes(const std::string& name) {
    std::ifstream status("/proc/self/status");
    std::string word;
    double kibibytes = 0.0;
    while (status >> word)
      if (word == name && status >> kibibytes) return 1024.0 * kibibytes;
    return std::numeric_limits<double>::quiet_NaN();
  }

  double before_ = 0.0;
};

}  // namespace gibench::micro

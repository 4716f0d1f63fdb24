#include "common/core/write_failure.h"

#include <cerrno>
#include <cstring>

#include "common/core/error.h"

namespace gibench {

void throw_write_failure(const std::filesystem::path& place, const std::string& problem, int reason, const std::string& remedy) {
  const std::string what = problem + " (" + std::strerror(reason) + ")";
  if (reason == ENOSPC || reason == EDQUOT) throw WorkError(place.string() + ": " + what + "; make room and try again");
  if (reason == EIO) throw WorkError(place.string() + ": " + what + "; look after the device, or choose another");
  throw InputError(place.string(), what, remedy);
}

}  // namespace gibench

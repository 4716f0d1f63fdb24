/// Jobs on several threads.
#pragma once

#include <cstddef>
#include <functional>

namespace gibench {

/// Calls work(0), …, work(count − 1) on `jobs` threads; the first exception is thrown here once all threads ended. No job is
/// begun after the user asked to stop.
void for_each_job(int jobs, std::size_t count, const std::function<void(std::size_t)>& work);

}  // namespace gibench

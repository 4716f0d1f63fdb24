#include "bench/study/for_each_job.h"

#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

#include "bench/measure/cancellation.h"

namespace gibench {

void for_each_job(int jobs, std::size_t count, const std::function<void(std::size_t)>& work) {
  std::atomic<std::size_t> next{0};
  std::exception_ptr first_error;
  std::mutex error_mutex;
  const auto take_jobs = [&] {
    for (std::size_t i = next++; i < count && !cancellation()->load(); i = next++) try {
        work(i);
      } catch (...) {
        const std::lock_guard lock(error_mutex);
        if (!first_error) first_error = std::current_exception();
        next = count;
      }
  };
  std::vector<std::thread> threads;
  for (int i = 1; i < jobs; ++i) threads.emplace_back(take_jobs);
  take_jobs();
  for (std::thread& thread : threads) thread.join();
  if (first_error) std::rethrow_exception(first_error);
}

}  // namespace gibench

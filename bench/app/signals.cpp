#include "bench/app/signals.h"

#include <atomic>
#include <csignal>

#include "bench/measure/cancellation.h"

namespace gibench {

namespace {

std::atomic<bool>* asked_to_stop = nullptr;  // what the signal handler may touch
static_assert(std::atomic<bool>::is_always_lock_free);

void on_signal(int) {
  if (asked_to_stop) asked_to_stop->store(true);
}

}  // namespace

void listen_for_cancellation() {
  asked_to_stop = cancellation().get();
  struct sigaction action = {};
  action.sa_handler = on_signal;
  action.sa_flags = static_cast<int>(SA_RESETHAND);
  sigemptyset(&action.sa_mask);
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
}

}  // namespace gibench

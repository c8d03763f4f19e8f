#include "apps/process/interrupt.h"

#include <atomic>
#include <cerrno>
#include <csignal>

namespace shellmatch {

namespace {

constexpr int stop_signals[] = {SIGINT, SIGTERM, SIGHUP};

// Number of the signal received; 0: none. Atomic, since all threads ask; without locks, as a signal handler has to be.
std::atomic<int> requested = 0;
static_assert(std::atomic<int>::is_always_lock_free);

void set_handlers(void (*handler)(int)) {
  struct sigaction action {};
  action.sa_handler = handler;
  action.sa_flags = SA_RESTART;  // interrupted system calls are restarted
  sigemptyset(&action.sa_mask);
  for (const int signal : stop_signals) sigaddset(&action.sa_mask, signal);
  for (const int signal : stop_signals) {
    struct sigaction before {};
    if (sigaction(signal, nullptr, &before) == 0 && before.sa_handler != SIG_IGN) sigaction(signal, &action, nullptr);
  }
}

extern "C" void note_interrupt(int signal) {
  const int interrupted_errno = errno;
  requested = signal;
  set_handlers(SIG_DFL);  // the next one ends the program
  errno = interrupted_errno;
}

}  // namespace

void catch_interrupts() { set_handlers(note_interrupt); }

bool interrupt_requested() { return requested != 0; }

int interrupt_exit_code() {
  const int signal = requested;
  return 128 + (signal != 0 ? signal : SIGINT);
}

}  // namespace shellmatch

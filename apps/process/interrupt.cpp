#include "apps/process/interrupt.h"

#include <atomic>
#include <cerrno>
#include <csignal>

#include <sys/time.h>
#include <unistd.h>

namespace shellmatch {

namespace {

constexpr int stop_signals[] = {SIGINT, SIGTERM, SIGHUP};

// Number of the signal received; 0: none. Atomic, since all threads ask; without locks, as a signal handler has to be.
std::atomic<int> requested = 0;
// Whether somebody has been told of it, who will end the program in good order.
std::atomic<bool> heard = false;
static_assert(std::atomic<int>::is_always_lock_free && std::atomic<bool>::is_always_lock_free);

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

extern "C" void end_unheard(int) {
  if (heard) return;
  constexpr char text[] = "shellmatch: stopped at once, within a step that cannot be interrupted\n";
  if (write(STDERR_FILENO, text, sizeof text - 1) < 0) {
  }  // nothing is left to be done where nobody listens
  _exit(128 + requested);
}

extern "C" void note_interrupt(int signal) {
  const int interrupted_errno = errno;
  requested = signal;
  set_handlers(SIG_DFL);  // the next one ends the program
  const itimerval patience{{0, 0}, {1, 800'000}};
  setitimer(ITIMER_REAL, &patience, nullptr);  // a system call alone, as a signal handler may do
  errno = interrupted_errno;
}

}  // namespace

void catch_interrupts() {
  struct sigaction alarm {};
  alarm.sa_handler = end_unheard;
  alarm.sa_flags = SA_RESTART;
  sigaction(SIGALRM, &alarm, nullptr);
  set_handlers(note_interrupt);
}

bool interrupt_requested() {
  if (requested == 0) return false;
  heard = true;
  return true;
}

int interrupt_exit_code() {
  const int signal = requested;
  return 128 + (signal != 0 ? signal : SIGINT);
}

}  // namespace shellmatch

#include "apps/process/interrupt.h"

#include <csignal>

namespace shellmatch {

namespace {

constexpr int stop_signals[] = {SIGINT, SIGTERM, SIGHUP};

volatile std::sig_atomic_t requested = 0;  // number of the signal received; 0: none

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
  requested = signal;
  set_handlers(SIG_DFL);  // the next one ends the program
}

}  // namespace

void catch_interrupts() { set_handlers(note_interrupt); }

bool interrupt_requested() { return requested != 0; }

int interrupt_exit_code() { return 128 + (interrupt_requested() ? requested : SIGINT); }

}  // namespace shellmatch

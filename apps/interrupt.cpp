#include "apps/interrupt.h"

#include "base/stop.h"

#include <csignal>

namespace shellmatch {

namespace {

volatile std::sig_atomic_t requested = 0;  // number of the signal received; 0: none

extern "C" void note_interrupt(int signal) { requested = signal; }

}  // namespace

void catch_interrupts() {
  struct sigaction action {};
  action.sa_handler = note_interrupt;
  // The first signal resets the handler, so that a second one ends the program; interrupted system calls are restarted.
  action.sa_flags = static_cast<int>(SA_RESETHAND) | SA_RESTART;
  sigemptyset(&action.sa_mask);
  for (const int signal : {SIGINT, SIGTERM}) sigaction(signal, &action, nullptr);
}

void stop_loops_on_interrupts() {
  catch_interrupts();
  stop_loops_when(interrupt_requested);
}

bool interrupt_requested() { return requested != 0; }

int interrupt_exit_code() { return 128 + (interrupt_requested() ? requested : SIGINT); }

}  // namespace shellmatch

#include "apps/interrupt.h"

#include <csignal>

namespace shellmatch {

namespace {

volatile std::sig_atomic_t requested = 0;

extern "C" void note_interrupt(int) { requested = 1; }

}  // namespace

void catch_interrupts() {
  struct sigaction action {};
  action.sa_handler = note_interrupt;
  // The handler serves once, and interrupted system calls go on.
  action.sa_flags = static_cast<int>(SA_RESETHAND) | SA_RESTART;
  sigemptyset(&action.sa_mask);
  for (const int signal : {SIGINT, SIGTERM}) sigaction(signal, &action, nullptr);
}

bool interrupt_requested() { return requested != 0; }

}  // namespace shellmatch

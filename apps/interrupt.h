#pragma once
/// \file
/// Ctrl-C and SIGTERM as a polite request. A second one ends the program at once.

namespace shellmatch {

/// From now on SIGINT and SIGTERM are noted instead of ending the program.
void catch_interrupts();

/// Besides, parallel loops end with Stopped (base/stop.h) once one has come.
void stop_loops_on_interrupts();

/// Has one come?
bool interrupt_requested();

/// The exit code of a program that stopped for it, as the shell counts it: 128 + the signal's number, 130 for Ctrl-C.
int interrupt_exit_code();

}  // namespace shellmatch

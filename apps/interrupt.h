#pragma once
/// \file
/// Handles Ctrl-C and SIGTERM as a request to stop. A second signal ends the program at once.

namespace shellmatch {

/// Installs handlers that record SIGINT and SIGTERM instead of ending the program.
void catch_interrupts();

/// Makes parallel loops end with Stopped (base/stop.h) once a signal has been received.
void stop_loops_on_interrupts();

/// Whether a signal has been received.
bool interrupt_requested();

/// The exit code of a program stopped by the signal, in the shell's convention: 128 + its number, 130 for Ctrl-C.
int interrupt_exit_code();

}  // namespace shellmatch

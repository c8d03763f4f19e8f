#pragma once
/// \file
/// Handles Ctrl-C, SIGTERM and the end of the terminal (SIGHUP) as a request to stop. A second signal, of whatever kind,
/// ends the program at once.

namespace shellmatch {

/// Installs handlers that record these signals instead of ending the program. One that is ignored when the program
/// starts, as by nohup or for a shell's background jobs, stays ignored.
void catch_interrupts();

/// Whether a signal has been received.
bool interrupt_requested();

/// The exit code of a program stopped by the signal, in the shell's convention: 128 + its number, 130 for Ctrl-C.
int interrupt_exit_code();

}  // namespace shellmatch

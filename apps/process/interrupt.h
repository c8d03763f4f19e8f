#pragma once
/// \file
/// Handles Ctrl-C, SIGTERM and the end of the terminal (SIGHUP) as a request to stop. A second signal, of whatever
/// kind, ends the program at once.

namespace shellmatch {

/// Installs handlers that record these signals instead of ending the program. One that is ignored when the program
/// starts, as by nohup or for a shell's background jobs, stays ignored. Where nothing asks for the signal in nearly two
/// seconds, as in a library's function that takes long, the program ends as by a second signal: what it had begun to
/// write has no name yet.
void catch_interrupts();

/// Whether a signal has been received.
bool interrupt_requested();

/// The exit code of a program stopped by the signal, in the shell's convention: 128 + its number, 130 for Ctrl-C.
int interrupt_exit_code();

}  // namespace shellmatch

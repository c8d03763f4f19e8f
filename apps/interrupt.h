#pragma once
/// \file
/// Ctrl-C and SIGTERM as a polite request: the work stops at its next iteration. A second one ends the
/// program at once.

#include <stdexcept>

namespace shellmatch {

/// The user stopped the work: exit code 130.
class Interrupted : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// From now on SIGINT and SIGTERM are noted instead of ending the program.
void catch_interrupts();

/// Has one come?
bool interrupt_requested();

}  // namespace shellmatch

#pragma once
/// \file
/// What VTK has to say, kept from the terminal.

#include <memory>

namespace shellmatch {

/// While it lives, VTK's messages are noted instead of printed.
class VtkMessages {
 public:
  VtkMessages();
  ~VtkMessages();
  VtkMessages(const VtkMessages&) = delete;
  VtkMessages& operator=(const VtkMessages&) = delete;

  /// Has there been one?
  bool any() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace shellmatch

#pragma once
/// \file
/// Keeps VTK's messages off the terminal.

#include <memory>

namespace shellmatch {

/// During the lifetime of an object, VTK's messages are recorded instead of printed.
class VtkMessages {
 public:
  VtkMessages();
  ~VtkMessages();
  VtkMessages(const VtkMessages&) = delete;
  VtkMessages& operator=(const VtkMessages&) = delete;

  /// Whether there has been a message.
  bool any() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace shellmatch

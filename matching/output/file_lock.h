#pragma once
/// \file
/// A file that a process holds for itself, or together with others, for as long as it lives.

#include <string>

namespace shellmatch {

/// Locks of the whole file (flock). The system gives them back when the process ends, however it ends.
class FileLock {
 public:
  enum class Kind { exclusive, shared };
  enum class State {
    held,        ///< by this object
    taken,       ///< by another
    unsupported  ///< some network file systems know no locks: there the user has to see to it
  };

  /// Creates the file where it is missing. \throws EnvironmentError if it cannot be opened
  FileLock(const std::string& path, Kind kind);
  /// A lock that is held exclusively goes with its file; others leave the file where it is.
  ~FileLock();
  FileLock(const FileLock&) = delete;
  FileLock& operator=(const FileLock&) = delete;

  State state() const { return state_; }

 private:
  std::string path_;
  Kind kind_;
  int file_ = -1;
  State state_ = State::unsupported;
};

}  // namespace shellmatch

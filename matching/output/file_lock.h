#pragma once
/// \file
/// Exclusive and shared locks between processes, by means of a file.

#include <string>

namespace shellmatch {

/// A lock of a whole file (flock). The system releases it when the process ends, in whatever way.
class FileLock {
 public:
  enum class Kind { exclusive, shared };
  enum class State {
    held,        ///< by this object
    taken,       ///< by another process
    unsupported  ///< by some network file systems; the user has to exclude other runs
  };

  /// Creates the file where it is missing and tries to lock it, without waiting. \throws EnvironmentError if it cannot
  /// be opened
  FileLock(const std::string& path, Kind kind);
  /// Releases the lock; an exclusive one also removes its file, and so does one that is unsupported if it created it.
  ~FileLock();
  FileLock(const FileLock&) = delete;
  FileLock& operator=(const FileLock&) = delete;

  State state() const { return state_; }

 private:
  std::string path_;
  Kind kind_;
  int file_ = -1;
  bool is_own_ = false;  // created by this object
  State state_ = State::unsupported;
};

}  // namespace shellmatch

#pragma once
/// \file
/// Several mistakes of one input.

#include "base/error.h"

#include <string>
#include <vector>

namespace shellmatch {

/// Each mistake has its own text, which begins with file and line.
class SeveralInputErrors : public InputError {
 public:
  /// \param texts at least one; what() joins them by "; "
  explicit SeveralInputErrors(std::vector<std::string> texts);
  const std::vector<std::string>& texts() const { return texts_; }

 private:
  std::vector<std::string> texts_;
};

}  // namespace shellmatch

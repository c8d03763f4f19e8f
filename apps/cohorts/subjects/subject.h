#pragma once
/// \file
/// One shape of a cohort.

#include <string>
#include <utility>
#include <vector>

namespace shellmatch {

struct Subject {
  std::string id;         ///< unique, valid as a file name
  std::string source;     ///< of its shape (matching/input/shape_source.h), absolute
  std::string landmarks;  ///< file of its points, absolute; may be empty
  std::string group;      ///< may be empty
  bool reflect = false;   ///< x becomes -x before all else: left shapes among right ones
  std::vector<std::pair<std::string, std::string>> further;  ///< further columns of the table, which are kept
};

}  // namespace shellmatch

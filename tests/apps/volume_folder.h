#pragma once

#include "tests/geometry/io/files.h"

#include <fstream>
#include <string>

namespace shellmatch::testing {

/// A temporary folder whose files are written as `folder / name`.
struct VolumeFolder : TempFolder {
  std::string operator/(const std::string& name) const { return path(name); }
};

inline void write(const std::string& path, const std::string& bytes) {
  std::ofstream(path, std::ios::binary).write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
}

}  // namespace shellmatch::testing

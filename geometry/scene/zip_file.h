#pragma once
/// \file
/// The parts of a ZIP archive in memory (PKWARE's APPNOTE 6.3 with ZIP64, without encryption and parts of more than
/// 4 GB).

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace shellmatch {

class ZipFile {
 public:
  /// Keeps both views. \throws InputError where the bytes are no archive
  ZipFile(const std::string& path, std::string_view bytes);

  /// The names of its parts, in the order of its directory; parts that differ in upper and lower case alone are one,
  /// the first.
  const std::vector<std::string>& names() const { return names_; }

  /// The part of that name, upper and lower case being the same; nothing where there is none. \throws InputError where
  /// it is damaged
  std::optional<std::string> part(std::string_view name) const;

 private:
  struct Entry {
    std::size_t offset, packed, size, method;
    bool is_encrypted;
  };

  const std::string& path_;
  std::string_view bytes_;
  std::map<std::string, Entry> entries_;
  std::vector<std::string> names_;
};

}  // namespace shellmatch

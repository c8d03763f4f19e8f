#pragma once
/// \file
/// Reads the one form of VTK's XML files that this program writes: an unstructured grid of one piece, whose arrays are
/// appended as raw blocks compressed by zlib (https://docs.vtk.org/en/latest/design_documents/VTKFileFormats.html).
/// VTK's own reader trusts types, counts and offsets of a file; this one checks each against the others and against the
/// bytes that are there.

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace shellmatch {

/// An array as the head of the file declares it.
struct VtuArray {
  std::string section;  ///< "FieldData", "PointData", "CellData", "Points" or "Cells"
  std::string name, type;
  std::int64_t n_components = 1;
  std::size_t offset = 0;  ///< in the appended data
};

class VtuFile {
 public:
  /// Parses the head. \throws InputError where the file is no such file
  VtuFile(std::string path, std::string bytes);
  VtuFile(const VtuFile&) = delete;
  VtuFile& operator=(const VtuFile&) = delete;

  std::int64_t n_points() const { return n_points_; }
  std::int64_t n_cells() const { return n_cells_; }
  bool has(std::string_view section, std::string_view name) const { return find(section, name) != nullptr; }

  /// The values of an array, component by component of one tuple after the other. T is the type in the file: double,
  /// std::int32_t, std::int64_t or std::uint8_t. \throws InputError where the array is missing, is of another type or
  /// number of components, has not `n_tuples` tuples, is damaged, or has a number that is not finite
  template <class T>
  std::vector<T> values(std::string_view section, std::string_view name, std::int64_t n_components,
                        std::int64_t n_tuples) const;

  /// \throws InputError that says what is wrong with the file
  [[noreturn]] void damaged(std::string_view why) const;

 private:
  const VtuArray* find(std::string_view section, std::string_view name) const;
  void expand(const VtuArray& array, char* out, std::size_t n_bytes) const;
  std::size_t packed_size(const VtuArray& array, std::size_t n_bytes) const;

  std::string path_, bytes_;
  std::string_view data_;  // of bytes_, what is appended
  std::int64_t n_points_ = 0, n_cells_ = 0;
  std::vector<VtuArray> arrays_;
};

}  // namespace shellmatch

#pragma once
/// \file
/// What is asked of a volume's file before a library reads it.

#include <cstdint>
#include <string>

namespace shellmatch {

/// Where the values of a volume are.
struct VolumeData {
  std::string file;
  std::uintmax_t offset = 0;  ///< of the first value: in the file, or in what a file that is compressed as a whole inflates to
  enum { none, of_values, of_file } compression = none;
  std::uintmax_t file_bytes = 0;
  std::size_t voxel_bytes = 0;  ///< on the disk, before compression; 0 where it is what the library says
};

/// Checks what the library takes for granted or replaces silently: that a header has its length, that a NIfTI's spacing is
/// positive and its frame finite, and that values elsewhere are in one file that ends. \throws InputError
VolumeData check_volume_header(const std::string& path);

/// Whether there are so many bytes of values; as NIfTI's and MetaImage's readers do not ask. Nothing is kept of what is inflated.
/// \pre `data` is that of a NIfTI or a MetaImage
bool has_values(const VolumeData& data, std::uintmax_t n_bytes);

/// The most bytes of values that the file can hold, if everything is compressed as well as can be.
std::uintmax_t most_value_bytes(const VolumeData& data);

/// How many bytes, at most `enough`, the file inflates to from this offset in it on, as zlib's or gzip's data; a file that is not compressed as it is.
std::uintmax_t inflated_bytes(const std::string& path, std::uintmax_t offset, std::uintmax_t enough);

/// The beginning of a file, decompressed where it is compressed, of at most this many bytes; fewer where the file ends or is damaged.
std::string inflated_beginning(const std::string& path, std::size_t n_bytes);

}  // namespace shellmatch

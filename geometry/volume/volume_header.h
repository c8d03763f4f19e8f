#pragma once
/// \file
/// What is asked of a volume's file before a library reads it.

#include <cstdint>
#include <string>

namespace shellmatch {

enum class VolumeFormat { nifti, nrrd, meta_image };

/// By the ending. \throws InputError where it is no volume's
VolumeFormat volume_format(const std::string& path);

/// The most bytes of values that the file, or the one that its header names, may hold: compressed ones count as often as the
/// best compression would have it.
struct VolumeSpace {
  std::uintmax_t most_bytes;
  std::uintmax_t file_bytes;
};

/// Checks what the libraries take for granted or replace silently: that a header has its length, that a NIfTI's spacing is
/// positive and its frame finite, and that values elsewhere are in one file that ends. \throws InputError
VolumeSpace check_volume_header(const std::string& path);

/// The beginning of a file, decompressed where it is compressed, of at most this many bytes; fewer where the file ends or is damaged.
std::string inflated_beginning(const std::string& path, std::size_t n_bytes);

}  // namespace shellmatch

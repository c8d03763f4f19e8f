#pragma once
/// \file
/// Pictures: what a file holds, and what of it counts for a shape.

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace shellmatch {

/// Brightness from 0 (black) to 1 (white), row by row from the top.
struct GreyImage {
  int width = 0, height = 0;
  std::vector<float> values;  // width * height

  float at(int column, int row) const { return values[static_cast<std::size_t>(row) * width + column]; }
};

/// What the values of a picture are: those of the file, the numbers of its palette's colours, or luminances where the
/// file has colours.
enum class PictureKind { grey, palette, colour };

/// A picture as its file has it.
struct Picture {
  GreyImage brightness;       ///< of a transparent pixel 0; of a colour its luminance
  std::vector<float> values;  ///< as `kind` says; of colours whole numbers from 0 to 255
  PictureKind kind = PictureKind::grey;
  bool is_lossy = false;                ///< compressed so that values change a little: no labels
  std::vector<std::string> notes = {};  ///< what of the file was left out
};

/// Largest number of pixels that is read: 4096 x 4096, for which the reader takes 0.6 GB. A small file may declare any
/// size.
inline constexpr std::int64_t max_pixels = std::int64_t{1} << 24;

/// \throws InputError where a picture has no pixels or more than are read
void check_picture_size(std::int64_t width, std::int64_t height, const std::string& path);

/// Luminance of a colour, encoded as grey values are (IEC 61966-2-1): full red is 0.5, green 0.86 and blue 0.3.
/// Components from 0 to 255.
float luminance(unsigned char red, unsigned char green, unsigned char blue);

/// TIFF: grey and labels of 8, 16 and 32 bits, whole or floating, palettes, and what libtiff turns into colours. The
/// first page. \throws InputError where the file is cut off or damaged.
Picture read_tiff(const std::string& path, std::string_view bytes);
/// JPEG. \throws as above.
Picture read_jpeg(const std::string& path, std::string_view bytes);
/// BMP with 1, 4 or 8 bits and a palette, or 24 or 32 bits, not compressed. \throws as above.
Picture read_bmp(const std::string& path, std::string_view bytes);

struct Picture;

/// EXIF's orientation (CIPA DC-008, tag 0x0112) of a JPEG or PNG: from 1, as it is stored, to 8. 1 where it says
/// nothing that can be read.
int exif_orientation(std::string_view bytes);

/// Adds a note where the orientation is not 1.
void note_orientation(int orientation, Picture& picture);

}  // namespace shellmatch

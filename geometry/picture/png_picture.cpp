// PNG: its brightness through libpng's simplified interface, which handles damaged files safely (VTK 9.1's reader calls
// longjmp() into a function that has returned), and the values of grey pictures and palettes as they are.
#include "base/error.h"
#include "geometry/picture/picture.h"
#include "geometry/picture/read_mask.h"

#include <png.h>

#include <algorithm>
#include <cmath>
#include <csetjmp>
#include <cstring>

namespace shellmatch {
namespace {

// Frees the memory of libpng on every path, also after an exception.
struct Image {
  png_image control{};
  Image() { control.version = PNG_IMAGE_VERSION; }
  ~Image() { png_image_free(&control); }
  Image(const Image&) = delete;
  Image& operator=(const Image&) = delete;
};

struct Source {
  std::string_view rest;
};

void read_bytes(png_structp png, png_bytep data, std::size_t size) {
  Source& source = *static_cast<Source*>(png_get_io_ptr(png));
  if (size > source.rest.size()) png_error(png, "the file ends too early");
  std::memcpy(data, source.rest.data(), size);
  source.rest.remove_prefix(size);
}

void jump_back(png_structp png, png_const_charp) { png_longjmp(png, 1); }
void ignore_warning(png_structp, png_const_charp) {}

// Values of a picture without colours, one byte or two for each pixel; the kind and the size of a value.
struct Values {
  std::vector<png_byte> bytes;
  std::vector<png_bytep> rows;
  int kind = PNG_COLOR_TYPE_RGB, n_bytes = 1;
};

// False where there are colours or transparent pixels, or where the file is damaged. What outlives a jump back is the
// caller's.
bool read_values(png_structp png, png_infop info, Source& source, Values& values) {
  if (setjmp(png_jmpbuf(png))) return false;
  png_set_read_fn(png, &source, read_bytes);
  png_read_info(png, info);
  values.kind = png_get_color_type(png, info);
  if ((values.kind != PNG_COLOR_TYPE_GRAY && values.kind != PNG_COLOR_TYPE_PALETTE) ||
      png_get_valid(png, info, PNG_INFO_tRNS))
    return false;
  values.n_bytes = png_get_bit_depth(png, info) == 16 ? 2 : 1;
  png_set_packing(png);
  png_set_interlace_handling(png);
  png_read_update_info(png, info);
  const std::size_t line = png_get_rowbytes(png, info), height = png_get_image_height(png, info);
  values.bytes.resize(line * height);
  for (std::size_t row = 0; row < height; ++row) values.rows.push_back(values.bytes.data() + row * line);
  png_read_image(png, values.rows.data());
  return true;
}

// The values of the file, where it has no colours.
void keep_values(std::string_view bytes, Picture& picture) {
  png_structp png = png_create_read_struct(PNG_LIBPNG_VER_STRING, nullptr, jump_back, ignore_warning);
  png_infop info = png ? png_create_info_struct(png) : nullptr;
  Source source{bytes};
  Values values;
  const bool are_read = info && read_values(png, info, source, values);
  png_destroy_read_struct(&png, &info, nullptr);
  if (!are_read) return;
  picture.kind = values.kind == PNG_COLOR_TYPE_PALETTE ? PictureKind::palette : PictureKind::grey;
  for (std::size_t i = 0; i < picture.values.size(); ++i)
    picture.values[i] = values.n_bytes == 1 ? static_cast<float>(values.bytes[i])
                                            : static_cast<float>(values.bytes[2 * i] << 8 | values.bytes[2 * i + 1]);
}

// libpng takes memory for as many bytes as a chunk eXIf says it has, whether they are there or not.
void check_exif(const std::string& path, std::string_view bytes) {
  for (std::size_t at = 8; at + 12 <= bytes.size();) {
    const std::size_t size = png_get_uint_32(reinterpret_cast<png_const_bytep>(bytes.data() + at)),
                      left = bytes.size() - at - 12;
    if (size > left && bytes.substr(at + 4, 4) == "eXIf")
      throw_input_error(
          "{}: the PNG image is cut off or damaged (its EXIF has {} bytes, of which {} are there); save it again", path,
          size, left);
    at += 12 + size;
  }
}

}  // namespace

Picture read_png(const std::string& path, std::string_view bytes) {
  Image image;
  const auto check = [&](int success) {
    if (!success || PNG_IMAGE_FAILED(image.control))
      throw_input_error("{}: the PNG image is cut off or damaged ({}); save it again", path, image.control.message);
  };
  check_exif(path, bytes);
  check(png_image_begin_read_from_memory(&image.control, bytes.data(), bytes.size()));
  const std::int64_t width = image.control.width, height = image.control.height;
  check_picture_size(width, height, path);
  // Brightness and opacity with 8 bits each for all files. Without this flag libpng interprets 16 bit values
  // as linear light, and they would be converted to other greys than 8 bit values.
  image.control.flags |= PNG_IMAGE_FLAG_16BIT_sRGB;
  image.control.format = PNG_FORMAT_GA;
  std::vector<png_byte> pixels(PNG_IMAGE_SIZE(image.control));
  check(png_image_finish_read(&image.control, nullptr, pixels.data(), 0, nullptr));
  Picture result{{static_cast<int>(width), static_cast<int>(height), {}}, {}, PictureKind::colour};
  std::vector<float>& brightness = result.brightness.values;
  brightness.reserve(pixels.size() / 2);
  for (std::size_t i = 0; i < pixels.size(); i += 2)
    brightness.push_back(static_cast<float>(pixels[i]) * static_cast<float>(pixels[i + 1]) / (255.0f * 255.0f));
  // Black on nothing: the opacity is the picture.
  const bool is_black = std::ranges::all_of(brightness, [](float b) { return b == 0; });
  if (is_black)
    for (std::size_t i = 0; i < brightness.size(); ++i) brightness[i] = static_cast<float>(pixels[2 * i + 1]) / 255.0f;
  const bool is_opaque = std::ranges::all_of(brightness, [](float b) { return b == 1; });
  if (is_black && is_opaque) std::ranges::fill(brightness, 0.0f);
  if (is_black && !is_opaque) result.notes.push_back("all colours are black: the shape is what is not transparent");
  for (const float b : brightness) result.values.push_back(std::round(255 * b));
  if (!is_black || is_opaque) keep_values(bytes, result);
  note_orientation(exif_orientation(bytes), result);
  return result;
}

}  // namespace shellmatch

// PNG through libpng's simplified interface, which handles damaged files safely. (VTK 9.1's reader calls
// longjmp() into a function that has returned.)
#include "base/error.h"
#include "geometry/io/read_mask.h"

#include <png.h>

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

}  // namespace

GreyImage read_png(const std::string& path, std::string_view bytes) {
  Image image;
  const auto check = [&](int success) {
    if (!success || PNG_IMAGE_FAILED(image.control))
      throw_input_error("{}: the PNG image is cut off or damaged ({}); save it again", path,
                        image.control.message);
  };
  check(png_image_begin_read_from_memory(&image.control, bytes.data(), bytes.size()));
  const std::int64_t width = image.control.width, height = image.control.height;
  if (width * height > max_pixels)
    throw_input_error("{}: {} x {} pixels; up to {} million are read: scale the image", path, width, height,
                      max_pixels / 1'000'000);
  // Brightness and opacity with 8 bits each for all files. Without this flag libpng interprets 16 bit values
  // as linear light, and they would be converted to other greys than 8 bit values.
  image.control.flags |= PNG_IMAGE_FLAG_16BIT_sRGB;
  image.control.format = PNG_FORMAT_GA;
  std::vector<png_byte> pixels(PNG_IMAGE_SIZE(image.control));
  check(png_image_finish_read(&image.control, nullptr, pixels.data(), 0, nullptr));
  GreyImage result{static_cast<int>(width), static_cast<int>(height), {}};
  result.values.reserve(pixels.size() / 2);
  for (std::size_t i = 0; i < pixels.size(); i += 2)
    result.values.push_back(static_cast<float>(pixels[i]) * static_cast<float>(pixels[i + 1]) /
                            (255.0f * 255.0f));
  return result;
}

}  // namespace shellmatch

// JPEG through libjpeg-turbo's own interface, which returns errors instead of calling longjmp().
#include "base/error.h"
#include "geometry/picture/picture.h"

#include <fmt/format.h>
#include <turbojpeg.h>

#include <cmath>
#include <memory>
#include <string>

namespace shellmatch {

namespace {

// Cameras leave bytes between the segments before the first scan. The library would skip them with a warning, which
// hides what it says of the rest.
std::string without_stray_bytes(std::string_view bytes) {
  std::string whole(bytes.substr(0, 2));
  for (std::size_t at = 2; at + 4 <= bytes.size();) {
    const auto byte = [&](std::size_t k) { return static_cast<unsigned char>(bytes[at + k]); };
    if (byte(0) != 0xff || byte(1) == 0xff) {  // the latter only fills
      ++at;
      continue;
    }
    const std::size_t size = 2 + (std::size_t{byte(2)} << 8 | byte(3));
    if (byte(1) == 0xda || size > bytes.size() - at) return whole.append(bytes.substr(at));
    whole.append(bytes.substr(at, size));
    at += size;
  }
  return std::string(bytes);  // without a scan
}

}  // namespace

Picture read_jpeg(const std::string& path, std::string_view bytes) {
  struct Closed {
    void operator()(void* handle) const { tjDestroy(handle); }
  };
  const std::unique_ptr<void, Closed> handle(tjInitDecompress());
  const auto check = [&](int result) {
    if (result != 0)
      throw_input_error("{}: the JPEG image is cut off or damaged ({}); save it again", path,
                        tjGetErrorStr2(handle.get()));
  };
  const std::string whole = without_stray_bytes(bytes);
  const std::size_t n_stray = bytes.size() - whole.size();
  const auto* const data = reinterpret_cast<const unsigned char*>(whole.data());
  int width = 0, height = 0, subsampling = 0, colours = 0;
  check(tjDecompressHeader3(handle.get(), data, whole.size(), &width, &height, &subsampling, &colours));
  check_picture_size(width, height, path);
  if (colours == TJCS_CMYK || colours == TJCS_YCCK)
    throw_input_error("{}: the JPEG image has the colours of printing (CMYK); save it in RGB or grey", path);
  const bool is_grey = colours == TJCS_GRAY;
  const std::size_t n = static_cast<std::size_t>(width) * static_cast<std::size_t>(height), n_parts = is_grey ? 1 : 3;
  std::vector<unsigned char> pixels(n * n_parts);
  check(tjDecompress2(handle.get(), data, whole.size(), pixels.data(), width, 0, height, is_grey ? TJPF_GRAY : TJPF_RGB,
                      TJFLAG_LIMITSCANS));
  Picture picture{{width, height, {}}, {}, is_grey ? PictureKind::grey : PictureKind::colour, true};
  picture.brightness.values.reserve(n);
  picture.values.reserve(n);
  for (std::size_t i = 0; i < n; ++i) {
    const unsigned char* const p = &pixels[i * n_parts];
    picture.brightness.values.push_back(is_grey ? static_cast<float>(p[0]) / 255 : luminance(p[0], p[1], p[2]));
    picture.values.push_back(std::round(255 * picture.brightness.values.back()));
  }
  note_orientation(exif_orientation(bytes), picture);
  if (n_stray > 0) picture.notes.push_back(fmt::format("{} bytes between its parts are left out", n_stray));
  return picture;
}

}  // namespace shellmatch

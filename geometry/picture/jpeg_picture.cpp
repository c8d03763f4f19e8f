// JPEG through libjpeg-turbo's own interface, which returns errors instead of calling longjmp().
#include "base/error.h"
#include "geometry/picture/orientation.h"
#include "geometry/picture/picture.h"

#include <fmt/format.h>
#include <turbojpeg.h>

#include <cmath>
#include <memory>
#include <type_traits>

namespace shellmatch {

Picture read_jpeg(const std::string& path, std::string_view bytes) {
  struct Closed {
    void operator()(void* handle) const { tjDestroy(handle); }
  };
  const std::unique_ptr<void, Closed> handle(tjInitDecompress());
  std::string stray;
  const auto check = [&](int result) {
    if (result == 0) return;
    const std::string complaint = tjGetErrorStr2(handle.get());
    // Cameras leave bytes between the parts of a picture; nothing of it is lost.
    if (tjGetErrorCode(handle.get()) == TJERR_WARNING && complaint.find("extraneous bytes") != complaint.npos)
      stray = complaint;
    else throw_input_error("{}: the JPEG image is cut off or damaged ({}); save it again", path, complaint);
  };
  const auto* const data = reinterpret_cast<const unsigned char*>(bytes.data());
  int width = 0, height = 0, subsampling = 0, colours = 0;
  check(tjDecompressHeader3(handle.get(), data, bytes.size(), &width, &height, &subsampling, &colours));
  check_picture_size(width, height, path);
  if (colours == TJCS_CMYK || colours == TJCS_YCCK)
    throw_input_error("{}: the JPEG image has the colours of printing (CMYK); save it in RGB or grey", path);
  const bool is_grey = colours == TJCS_GRAY;
  const std::size_t n = static_cast<std::size_t>(width) * static_cast<std::size_t>(height), n_parts = is_grey ? 1 : 3;
  std::vector<unsigned char> pixels(n * n_parts);
  check(tjDecompress2(handle.get(), data, bytes.size(), pixels.data(), width, 0, height, is_grey ? TJPF_GRAY : TJPF_RGB,
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
  if (!stray.empty()) picture.notes.push_back(fmt::format("bytes between its parts are left out ({})", stray));
  return picture;
}

}  // namespace shellmatch

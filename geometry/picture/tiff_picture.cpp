// TIFF through libtiff: pages of one value per pixel as they are, all others as colours.
#include "base/error.h"
#include "base/text.h"
#include "geometry/picture/label_choice.h"
#include "geometry/picture/picture.h"

#include <tiffio.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <memory>

namespace shellmatch {
namespace {

// The bytes of a file, which libtiff reads as a stream; and its first complaint.
struct Stream {
  std::string_view bytes;
  std::size_t position = 0;
  std::string complaint = {};
};

tmsize_t read_stream(thandle_t handle, void* buffer, tmsize_t size) {
  Stream& s = *static_cast<Stream*>(handle);
  const std::size_t n = std::min(static_cast<std::size_t>(std::max<tmsize_t>(size, 0)),
                                 s.bytes.size() - std::min(s.position, s.bytes.size()));
  if (n > 0) std::memcpy(buffer, s.bytes.data() + s.position, n);
  s.position += n;
  return static_cast<tmsize_t>(n);
}
tmsize_t write_nothing(thandle_t, void*, tmsize_t) { return 0; }
toff_t seek_stream(thandle_t handle, toff_t offset, int whence) {
  Stream& s = *static_cast<Stream*>(handle);
  const std::size_t from = whence == SEEK_SET ? 0 : whence == SEEK_CUR ? s.position : s.bytes.size();
  s.position = from + static_cast<std::size_t>(offset);
  return s.position;
}
int close_nothing(thandle_t) { return 0; }
toff_t stream_size(thandle_t handle) { return static_cast<Stream*>(handle)->bytes.size(); }
int keep_complaint(TIFF*, void* user, const char*, const char* format, va_list arguments) {
  std::string& complaint = static_cast<Stream*>(user)->complaint;
  char text[200];
  if (complaint.empty() && std::vsnprintf(text, sizeof text, format, arguments) > 0) complaint = text;
  return 1;  // said: nothing goes to standard error
}
int ignore_warning(TIFF*, void*, const char*, const char*, va_list) { return 1; }

struct Closed {
  void operator()(TIFF* tiff) const { TIFFClose(tiff); }
  void operator()(TIFFOpenOptions* options) const { TIFFOpenOptionsFree(options); }
};

struct Layout {
  uint32_t width = 0, height = 0;
  uint16_t bits = 1, samples = 1, format = SAMPLEFORMAT_UINT, photometric = PHOTOMETRIC_MINISBLACK,
           orientation = ORIENTATION_TOPLEFT;
};

template <class T>
float value_of(const unsigned char* bytes) {
  T value;
  std::memcpy(&value, bytes, sizeof value);  // libtiff has turned the bytes into the order of this machine
  return static_cast<float>(value);
}

// Sample `i` of a line.
float sample(const unsigned char* line, std::size_t i, const Layout& l) {
  if (l.bits < 8)
    return static_cast<float>(line[i * l.bits / 8] >> (8 - l.bits - i * l.bits % 8) & ((1 << l.bits) - 1));
  const unsigned char* const at = line + i * l.bits / 8;
  const bool is_signed = l.format == SAMPLEFORMAT_INT;
  if (l.format == SAMPLEFORMAT_IEEEFP) return l.bits == 32 ? value_of<float>(at) : value_of<double>(at);
  if (l.bits == 8) return is_signed ? value_of<int8_t>(at) : value_of<uint8_t>(at);
  if (l.bits == 16) return is_signed ? value_of<int16_t>(at) : value_of<uint16_t>(at);
  return is_signed ? value_of<int32_t>(at) : value_of<uint32_t>(at);
}

bool is_single_valued(const Layout& l) {
  const bool is_float = l.format == SAMPLEFORMAT_IEEEFP && (l.bits == 32 || l.bits == 64);
  const bool is_whole =
      (l.format == SAMPLEFORMAT_UINT || l.format == SAMPLEFORMAT_INT || l.format == SAMPLEFORMAT_VOID) &&
      (l.bits == 1 || l.bits == 2 || l.bits == 4 || l.bits == 8 || l.bits == 16 || l.bits == 32);
  return l.samples == 1 && (is_float || is_whole) &&
         (l.photometric == PHOTOMETRIC_MINISBLACK || l.photometric == PHOTOMETRIC_MINISWHITE ||
          l.photometric == PHOTOMETRIC_PALETTE);
}

class Reader {
 public:
  Reader(const std::string& path, std::string_view bytes) : path_(path), stream_{bytes} {
    const std::unique_ptr<TIFFOpenOptions, Closed> options(TIFFOpenOptionsAlloc());
    TIFFOpenOptionsSetMaxSingleMemAlloc(options.get(), tmsize_t{8} * max_pixels);
    TIFFOpenOptionsSetErrorHandlerExtR(options.get(), keep_complaint, &stream_);
    TIFFOpenOptionsSetWarningHandlerExtR(options.get(), ignore_warning, &stream_);
    tiff_.reset(TIFFClientOpenExt(path.c_str(), "rm", &stream_, read_stream, write_nothing, seek_stream, close_nothing,
                                  stream_size, nullptr, nullptr, options.get()));
    if (!tiff_) damaged();
  }

  Picture read() {
    TIFF* const tiff = tiff_.get();
    TIFFGetField(tiff, TIFFTAG_IMAGEWIDTH, &layout_.width);
    TIFFGetField(tiff, TIFFTAG_IMAGELENGTH, &layout_.height);
    TIFFGetFieldDefaulted(tiff, TIFFTAG_BITSPERSAMPLE, &layout_.bits);
    TIFFGetFieldDefaulted(tiff, TIFFTAG_SAMPLESPERPIXEL, &layout_.samples);
    TIFFGetFieldDefaulted(tiff, TIFFTAG_SAMPLEFORMAT, &layout_.format);
    TIFFGetField(tiff, TIFFTAG_PHOTOMETRIC, &layout_.photometric);
    TIFFGetFieldDefaulted(tiff, TIFFTAG_ORIENTATION, &layout_.orientation);
    check_picture_size(layout_.width, layout_.height, path_);
    uint16_t compression = COMPRESSION_NONE;
    TIFFGetFieldDefaulted(tiff, TIFFTAG_COMPRESSION, &compression);
    Picture picture;
    picture.brightness = {static_cast<int>(layout_.width), static_cast<int>(layout_.height), {}};
    picture.is_lossy =
        compression == COMPRESSION_JPEG || compression == COMPRESSION_OJPEG || compression == COMPRESSION_LERC;
    if (is_single_valued(layout_)) read_values(picture);
    else read_colours(picture);
    note_orientation(layout_.orientation, picture);
    if (TIFFReadDirectory(tiff) == 1) picture.notes.push_back("only the first page of the TIFF file is read");
    return picture;
  }

 private:
  [[noreturn]] void damaged() const {
    throw_input_error("{}: the TIFF image is cut off, damaged or of a kind that is not read ({}); save it again", path_,
                      stream_.complaint.empty() ? "libtiff gives no reason" : stream_.complaint);
  }

  void read_values(Picture& picture) {
    picture.kind = layout_.photometric == PHOTOMETRIC_PALETTE ? PictureKind::palette : PictureKind::grey;
    picture.values.assign(std::size_t{layout_.width} * layout_.height, 0.0f);
    if (TIFFIsTiled(tiff_.get())) read_tiles(picture);
    else read_lines(picture);
    for (const float v : picture.values) {
      if (!std::isfinite(v)) throw_input_error("{}: a pixel of the TIFF image is not finite; replace it by 0", path_);
      if (layout_.bits == 32 && layout_.format != SAMPLEFORMAT_IEEEFP && std::abs(v) > largest_label)
        throw_input_error(
            "{}: a pixel of the TIFF image is {:.0f}; values up to {:.0f} can be told apart: number the labels anew",
            path_, v, largest_label);
    }
    set_brightness(picture);
  }

  void read_lines(Picture& picture) {
    const tmsize_t size = TIFFScanlineSize(tiff_.get());
    if (size < tmsize_t{(std::int64_t{layout_.width} * layout_.bits + 7) / 8}) damaged();
    std::vector<unsigned char> line(static_cast<std::size_t>(size));
    for (uint32_t row = 0; row < layout_.height; ++row) {
      if (TIFFReadScanline(tiff_.get(), line.data(), row) != 1) damaged();
      for (uint32_t i = 0; i < layout_.width; ++i)
        picture.values[std::size_t{row} * layout_.width + i] = sample(line.data(), i, layout_);
    }
  }

  void read_tiles(Picture& picture) {
    uint32_t width = 0, height = 0;
    TIFFGetField(tiff_.get(), TIFFTAG_TILEWIDTH, &width);
    TIFFGetField(tiff_.get(), TIFFTAG_TILELENGTH, &height);
    const tmsize_t size = TIFFTileSize(tiff_.get()), row_size = TIFFTileRowSize(tiff_.get());
    if (width == 0 || height == 0 || size <= 0 || size > tmsize_t{8} * max_pixels ||
        row_size < tmsize_t{(std::int64_t{width} * layout_.bits + 7) / 8} || size / row_size < tmsize_t{height})
      damaged();
    std::vector<unsigned char> tile(static_cast<std::size_t>(size));
    for (uint32_t top = 0; top < layout_.height; top += height)
      for (uint32_t left = 0; left < layout_.width; left += width) {
        if (TIFFReadTile(tiff_.get(), tile.data(), left, top, 0, 0) < 0) damaged();
        const uint32_t n_rows = std::min(height, layout_.height - top),
                       n_columns = std::min(width, layout_.width - left);
        for (uint32_t row = 0; row < n_rows; ++row)
          for (uint32_t i = 0; i < n_columns; ++i)
            picture.values[std::size_t{top + row} * layout_.width + left + i] =
                sample(tile.data() + row * row_size, i, layout_);
        if (layout_.height - top <= height && layout_.width - left <= width) return;
      }
  }

  // White is the largest value that the bits can hold, or 1 of floating values.
  void set_brightness(Picture& picture) {
    std::vector<float>& brightness = picture.brightness.values;
    brightness.resize(picture.values.size());
    uint16_t *red = nullptr, *green = nullptr, *blue = nullptr;
    if (picture.kind == PictureKind::palette) {
      if (layout_.bits > 16 || TIFFGetField(tiff_.get(), TIFFTAG_COLORMAP, &red, &green, &blue) != 1) damaged();
      const auto part = [](uint16_t c) { return static_cast<unsigned char>(c >> 8); };
      for (std::size_t i = 0; i < brightness.size(); ++i) {
        const auto k =
            static_cast<std::size_t>(std::clamp(picture.values[i], 0.0f, std::ldexp(1.0f, layout_.bits) - 1));
        brightness[i] = luminance(part(red[k]), part(green[k]), part(blue[k]));
      }
      return;
    }
    const int used_bits = layout_.bits - (layout_.format == SAMPLEFORMAT_INT ? 1 : 0);
    const float white = layout_.format == SAMPLEFORMAT_IEEEFP ? 1.0f : std::ldexp(1.0f, used_bits) - 1;
    for (std::size_t i = 0; i < brightness.size(); ++i) {
      brightness[i] = std::clamp(picture.values[i] / white, 0.0f, 1.0f);
      if (layout_.photometric == PHOTOMETRIC_MINISWHITE) brightness[i] = 1 - brightness[i];
    }
  }

  void read_colours(Picture& picture) {
    picture.kind = PictureKind::colour;
    std::vector<uint32_t> pixels(std::size_t{layout_.width} * layout_.height);
    // In the orientation of the file, rows come as they are stored.
    if (TIFFReadRGBAImageOriented(tiff_.get(), layout_.width, layout_.height, pixels.data(), layout_.orientation, 1) !=
        1)
      damaged();
    const auto part = [](uint32_t c) { return static_cast<unsigned char>(c); };
    for (const uint32_t p : pixels) {  // libtiff has multiplied the colours by the opacity
      picture.brightness.values.push_back(luminance(part(TIFFGetR(p)), part(TIFFGetG(p)), part(TIFFGetB(p))));
      picture.values.push_back(std::round(255 * picture.brightness.values.back()));
    }
  }

  std::string path_;
  Stream stream_;
  std::unique_ptr<TIFF, Closed> tiff_;
  Layout layout_;
};

}  // namespace

Picture read_tiff(const std::string& path, std::string_view bytes) { return Reader(path, bytes).read(); }

}  // namespace shellmatch

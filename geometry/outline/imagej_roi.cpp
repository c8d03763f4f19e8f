// Regions of interest of ImageJ: a header of 64 bytes, big-endian, coordinates, and a second header with the name
// (https://github.com/imagej/ImageJ, ij/io/RoiDecoder.java).

#include "base/error.h"
#include "base/printable.h"
#include "base/text.h"
#include "geometry/mesh_text/read_text.h"
#include "geometry/outline/drawing.h"
#include "geometry/scene/zip_file.h"
#include "geometry/bytes/inflate.h"

#include <bit>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <utility>

namespace shellmatch {

namespace {

enum RoiType { polygon, rectangle, oval, line, free_line, polyline, nothing, freehand, traced, angle, point };
constexpr std::string_view type_names[] = {"a polygon",       "a rectangle",        "an oval", "a line",
                                           "a freehand line", "a line of segments", "nothing", "a freehand area",
                                           "a traced area",   "an angle",           "points"};

// Where the parts of the header are, and what options say.
namespace at {
constexpr std::size_t version = 4, type = 6, top = 8, left = 10, bottom = 12, right = 14, n_points = 16, floats = 18,
                      shape_size = 36, subtype = 48, options = 50, parameter = 52, arc_size = 54, second_header = 60,
                      coordinates = 64, name_offset = 16, name_length = 20;
}
constexpr int spline_fit = 1, sub_pixel = 128;
constexpr int text_box = 1, ellipse = 3, image_box = 4, turned_rectangle = 5;

class RoiReader {
 public:
  /// \param name where the file has none \param place for messages: the file, or the part of the archive
  RoiReader(std::string place, std::string_view bytes, std::string name)
      : place_(std::move(place)), bytes_(bytes), file_name_(std::move(name)) {
    if (!bytes.starts_with("Iout"))
      throw_input_error("{}: no region of interest of ImageJ: it does not begin with 'Iout'", place_);
    if (bytes.size() < at::coordinates) cut_off();
    type_ = byte(at::type);
    if (type_ > point)
      throw_input_error("{}: the type {} of the region is unknown; save it from ImageJ as a polygon", place_, type_);
  }

  bool is_area() const {
    return is_composite() || type_ == polygon || (type_ == rectangle && !is_overlay()) || type_ == oval ||
           type_ == freehand || type_ == traced;
  }
  std::string_view kind() const {
    return !is_overlay() ? type_names[type_] : half(at::subtype) == text_box ? "a text" : "an image";
  }
  bool is_spline() const {
    return !is_composite() && (option(spline_fit)) && (type_ == polygon || type_ == freehand || type_ == traced);
  }

  DrawnArea area() const {
    DrawnArea result;
    if (const std::string name = own_name(); !name.empty() && name != file_name_) result.names.push_back(name);
    result.names.push_back(file_name_);
    result.paths = is_composite() ? composite() : std::vector{path()};
    return result;
  }

 private:
  [[noreturn]] void cut_off() const {
    throw_input_error("{}: the region is cut off or damaged; save it again", place_);
  }

  // What lies on a picture in the box that a rectangle has.
  bool is_overlay() const {
    return type_ == rectangle && (half(at::subtype) == text_box || half(at::subtype) == image_box);
  }

  int byte(std::size_t where) const { return static_cast<unsigned char>(bytes_[where]); }
  std::uint32_t word(std::size_t where) const {
    if (where > bytes_.size() || bytes_.size() - where < 4) cut_off();
    return static_cast<std::uint32_t>(byte(where)) << 24 | static_cast<std::uint32_t>(byte(where + 1)) << 16 |
           static_cast<std::uint32_t>(byte(where + 2)) << 8 | static_cast<std::uint32_t>(byte(where + 3));
  }
  double real(std::size_t where) const { return std::bit_cast<float>(word(where)); }
  Vec<2> reals(std::size_t where) const { return {real(where), real(where + 4)}; }
  // 16 bits with a sign, but beyond 32767 where that is likelier, as ImageJ reads them.
  int half(std::size_t where) const {
    if (where > bytes_.size() || bytes_.size() - where < 2) cut_off();
    const int value = byte(where) << 8 | byte(where + 1);
    return value >= 0x8000 && value - 0x10000 >= -5000 ? value - 0x10000 : value;
  }
  bool option(int flag) const { return (half(at::options) & flag) != 0; }
  bool is_sub_pixel() const { return option(sub_pixel) && half(at::version) >= 222; }
  bool is_composite() const { return static_cast<std::int32_t>(word(at::shape_size)) > 0; }

  // UTF-16 of the second header.
  std::string own_name() const {
    const std::size_t second = word(at::second_header);
    if (second == 0 || second > bytes_.size() || bytes_.size() - second < at::name_length + 4) return "";
    const std::size_t begin = word(second + at::name_offset), n = word(second + at::name_length);
    if (begin == 0 || n > bytes_.size() / 2 || begin > bytes_.size() - 2 * n) return "";
    std::string name;
    for (std::size_t i = 0; i < n; ++i) {
      auto c = static_cast<std::uint32_t>(byte(begin + 2 * i) << 8 | byte(begin + 2 * i + 1));
      if ((c & 0xfc00) == 0xd800 && i + 1 < n) {
        ++i;
        c = 0x10000 + ((c & 0x3ff) << 10) +
            (static_cast<std::uint32_t>(byte(begin + 2 * i) << 8 | byte(begin + 2 * i + 1)) & 0x3ff);
      }
      const auto put = [&](std::uint32_t bits, std::uint32_t mark) { name.push_back(static_cast<char>(mark | bits)); };
      if (c < 0x80) put(c, 0);
      else if (c < 0x800) put(c >> 6, 0xc0);
      else if (c < 0x10000) put(c >> 12, 0xe0);
      else put(c >> 18, 0xf0);
      if (c >= 0x10000) put(c >> 12 & 0x3f, 0x80);
      if (c >= 0x800) put(c >> 6 & 0x3f, 0x80);
      if (c >= 0x80) put(c & 0x3f, 0x80);
    }
    return name;
  }

  DrawnPath path() const {
    const bool is_box = type_ == rectangle || type_ == oval;
    if (is_box) {
      Vec<2> corner(half(at::left), half(at::top)),
          size(half(at::right) - half(at::left), half(at::bottom) - half(at::top));
      if (is_sub_pixel() && half(at::version) >= 223) corner = reals(at::floats), size = reals(at::floats + 8);
      if (!(size.minCoeff() > 0) || !size.allFinite())
        throw_input_error("{}: {} of {:g} x {:g} pixels has no area", place_, kind(), size.x(), size.y());
      if (type_ == oval) return ellipse_path(corner + size / 2, {size.x() / 2, 0}, {0, size.y() / 2});
      const double radius = std::max(0, half(at::arc_size)) / 2.0;
      return rectangle_path(corner, size, size.cwiseMin(Vec<2>::Constant(2 * radius)) / 2);
    }
    const int subtype = half(at::subtype);
    if (type_ == freehand && (subtype == ellipse || subtype == turned_rectangle)) {
      // The longer axis, and the other one's share of it or the width.
      const Vec<2> from = reals(at::floats), to = reals(at::floats + 8), along = (to - from) / 2;
      const Vec<2> across(-along.y(), along.x());
      const double parameter = real(at::parameter);
      if (subtype == ellipse)
        return ellipse_path((from + to) / 2, along, std::min(1.0, std::max(0.0, parameter)) * across);
      const Vec<2> side = parameter / 2 * across / across.norm();
      return path_through({from + side, to + side, to - side, from - side}, true);
    }
    return path_through(points(), true);
  }

  std::vector<Vec<2>> points() const {
    // Numbers beyond 65535 stand elsewhere.
    std::size_t n = static_cast<std::size_t>(byte(at::n_points) << 8 | byte(at::n_points + 1));
    if (n == 0) n = word(at::floats);
    if (n < 3) throw_input_error("{}: {} of {} has no area", place_, kind(), counted(n, "point", "points"));
    const bool is_exact = is_sub_pixel();
    const std::size_t first = at::coordinates + (is_exact ? 4 * n : 0), size = is_exact ? 4 : 2;
    if (bytes_.size() < first + 2 * n * size) cut_off();
    std::vector<Vec<2>> result;
    result.reserve(n);
    for (std::size_t i = 0; i < n; ++i) {
      const std::size_t x = first + i * size, y = x + n * size;
      if (is_exact) result.emplace_back(real(x), real(y));
      else result.emplace_back(half(at::left) + std::max(0, half(x)), half(at::top) + std::max(0, half(y)));
    }
    return result;
  }

  // Segments of java.awt.geom.PathIterator as floats: the kind, then its points.
  std::vector<DrawnPath> composite() const {
    const std::size_t n = word(at::shape_size);
    if (n > (bytes_.size() - at::coordinates) / 4) cut_off();
    const std::size_t end = at::coordinates + 4 * n;
    PathPen pen;
    for (std::size_t i = at::coordinates; i < end;) {
      const double kind = real(i);
      const std::size_t n_points = kind == 0 || kind == 1 ? 1 : kind == 2 ? 2 : kind == 3 ? 3 : 0;
      if (n_points == 0 && kind != 4)
        throw_input_error("{}: a segment of its path is of the kind {:g}, which there is not; save it again", place_,
                          kind);
      i += 4;
      if (end - i < 8 * n_points) cut_off();
      const auto next = [&] {
        i += 8;
        return reals(i - 8);
      };
      if (kind == 0) pen.move_to(next());
      if (kind == 1) pen.line_to(next());
      if (kind == 2) {
        const Vec<2> control = next();
        pen.quadratic_to(control, next());
      }
      if (kind == 3) {
        const Vec<2> first = next(), second = next();
        pen.cubic_to(first, second, next());
      }
      if (kind == 4) pen.close();
    }
    return pen.take();
  }

  std::string place_;
  std::string_view bytes_;
  std::string file_name_;
  int type_;
};

void add_area(const RoiReader& roi, Drawing& drawing, std::size_t& n_splines) {
  drawing.areas.push_back(roi.area());
  n_splines += roi.is_spline();
}

void note_splines(std::size_t n, Drawing& drawing) {
  if (n > 0)
    drawing.notes.push_back(
        counted(n, "area", "areas") +
        " fitted by a spline in ImageJ: the points that were clicked are taken; 'Interpolate' there keeps the curve");
}

bool is_roi_name(std::string_view name) {
  return name.size() > 4 && equals_ignoring_case(name.substr(name.size() - 4), ".roi");
}

}  // namespace

Drawing read_roi(const std::string& path, std::string_view bytes) {
  const RoiReader roi(path, bytes, std::filesystem::path(path).stem().string());
  if (!roi.is_area())
    throw_input_error("{}: {} instead of an area; save an area: a polygon, rectangle, oval, freehand or traced one",
                      path, roi.kind());
  Drawing drawing;
  drawing.is_downward = true;
  std::size_t n_splines = 0;
  add_area(roi, drawing, n_splines);
  note_splines(n_splines, drawing);
  return drawing;
}

Drawing read_roi_set(const std::string& path, std::string_view bytes) {
  const ZipFile archive(path, bytes);
  Drawing drawing;
  drawing.is_downward = true;
  std::size_t n_splines = 0, n_others = 0, n_files = 0, n_unpacked = 0;
  for (const std::string& name : archive.names()) {
    if (!is_roi_name(name)) {
      ++n_files;
      continue;
    }
    const std::string part = *archive.part(name);
    // Parts of an honest archive do not lie on each other.
    if ((n_unpacked += part.size()) / max_expansion > bytes.size())
      throw_input_error("{}: its parts are larger than it can hold; the archive is damaged", path);
    const RoiReader roi(fmt::format("{}: its part '{}'", path, printable(name, 60)), part,
                        name.substr(0, name.size() - 4));
    if (roi.is_area()) add_area(roi, drawing, n_splines);
    else ++n_others;
  }
  if (drawing.areas.empty() && n_others == 0)
    throw_input_error("{}: no regions of interest of ImageJ in the archive; save them from its ROI Manager ('Save...')",
                      path);
  note_splines(n_splines, drawing);
  if (n_others > 0)
    drawing.notes.push_back(counted(n_others, "region", "regions") +
                            " without an area left out: lines, angles, points, texts, images");
  if (n_files > 0) drawing.notes.push_back(counted(n_files, "other file", "other files") + " in the archive left out");
  return drawing;
}

}  // namespace shellmatch

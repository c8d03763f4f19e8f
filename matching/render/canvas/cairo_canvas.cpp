#include "base/error.h"
#include "base/printable.h"
#include "matching/render/canvas/canvas.h"
#include "matching/render/canvas/fontconfig_fonts.h"

#include <cairo-pdf.h>
#include <cairo-svg.h>
#include <cairo.h>

#include <cmath>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <memory>
#include <new>
#include <numbers>

namespace shellmatch {

struct Canvas::State {
  int width, height;
  CanvasKind kind;
  std::string text;  // of SVG or PDF
  cairo_surface_t* surface = nullptr;
  cairo_t* cairo = nullptr;

  State(int w, int h, CanvasKind k) : width(w), height(h), kind(k) {}
  State(const State&) = delete;
  State& operator=(const State&) = delete;
  ~State() {
    cairo_destroy(cairo);
    cairo_surface_destroy(surface);
  }
  void set_color(const Color& c, double alpha) { cairo_set_source_rgba(cairo, c.r, c.g, c.b, alpha); }
  void set_font(const TextStyle& style) {
    use_fonts_beside_the_program();
    cairo_select_font_face(cairo, "DejaVu Sans", CAIRO_FONT_SLANT_NORMAL,
                           style.bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
    cairo_set_font_size(cairo, style.size);
  }
};

namespace {

// Called by cairo, which is written in C: no exception may leave it.
cairo_status_t append(void* text, const unsigned char* data, unsigned int length) noexcept try {
  static_cast<std::string*>(text)->append(reinterpret_cast<const char*>(data), length);
  return CAIRO_STATUS_SUCCESS;
} catch (const std::bad_alloc&) {
  return CAIRO_STATUS_NO_MEMORY;
}

// Throws std::bad_alloc for want of memory, and for what is no fault of the machine's tells the broken invariant.
// Encoding a picture in memory fails for want of it alone.
void check(cairo_status_t status, const char* invariant) {
  if (status == CAIRO_STATUS_NO_MEMORY || status == CAIRO_STATUS_PNG_ERROR) throw std::bad_alloc();
  if (status == CAIRO_STATUS_FREETYPE_ERROR)
    throw_environment_error("no text can be drawn ({})", cairo_status_to_string(status));
  SHELLMATCH_CHECK(status == CAIRO_STATUS_SUCCESS, invariant);
}

struct Destroyed {
  void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
};
using OwnSurface = std::unique_ptr<cairo_surface_t, Destroyed>;

void write_bytes(const std::string& bytes, const std::string& path) {
  std::ofstream out(path, std::ios::binary);
  out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  out.close();
  if (!out)
    cannot_be_written(
        0, fmt::format("{}: the picture cannot be written; is the disk full or the folder read-only?", path));
}

std::string png_bytes(cairo_surface_t* surface) {
  std::string bytes;
  check(cairo_surface_write_to_png_stream(surface, append, &bytes), "a picture in memory must be encodable as PNG");
  return bytes;
}

OwnSurface surface_of(const Image& picture) {
  OwnSurface surface(cairo_image_surface_create(CAIRO_FORMAT_RGB24, picture.width, picture.height));
  check(cairo_surface_status(surface.get()), "the picture's size must be valid");
  unsigned char* data = cairo_image_surface_get_data(surface.get());
  const int stride = cairo_image_surface_get_stride(surface.get());
  for (int y = 0; y < picture.height; ++y)
    for (int x = 0; x < picture.width; ++x) {
      const std::uint8_t* p = picture.at(x, y);
      const std::uint32_t word = (std::uint32_t{p[0]} << 16) | (std::uint32_t{p[1]} << 8) | p[2];
      std::memcpy(data + static_cast<std::ptrdiff_t>(y) * stride + 4 * x, &word, 4);
    }
  cairo_surface_mark_dirty(surface.get());
  return surface;
}

// Composites pre-multiplied alpha over white; formats without alpha are copied.
Image image_of(cairo_surface_t* surface) {
  cairo_surface_flush(surface);
  Image picture(cairo_image_surface_get_width(surface), cairo_image_surface_get_height(surface));
  const unsigned char* data = cairo_image_surface_get_data(surface);
  const int stride = cairo_image_surface_get_stride(surface);
  const bool has_alpha = cairo_image_surface_get_format(surface) == CAIRO_FORMAT_ARGB32;
  for (int y = 0; y < picture.height; ++y)
    for (int x = 0; x < picture.width; ++x) {
      std::uint32_t word;
      std::memcpy(&word, data + static_cast<std::ptrdiff_t>(y) * stride + 4 * x, 4);
      const std::uint32_t rest = has_alpha ? 255 - (word >> 24) : 0;
      std::uint8_t* p = picture.at(x, y);
      for (int k = 0; k < 3; ++k) p[k] = static_cast<std::uint8_t>(((word >> (16 - 8 * k)) & 255) + rest);
    }
  return picture;
}

void trace(cairo_t* cairo, std::span<const Vec<2>> points, bool closed) {
  if (points.empty()) return;
  cairo_move_to(cairo, points[0].x(), points[0].y());
  for (const Vec<2>& p : points.subspan(1)) cairo_line_to(cairo, p.x(), p.y());
  if (closed) cairo_close_path(cairo);
}

// Where cairo's rasteriser finds no memory it leaves its error handling by a frame that has gone (1.16): it must find
// some when it begins. Its own needs are a share of this.
void require_memory_to_draw() {
  constexpr std::size_t enough = std::size_t{8} << 20;
  void* volatile room = std::malloc(enough);  // volatile: compilers may leave out an allocation that is not used
  if (room == nullptr) throw std::bad_alloc();
  std::free(room);
}

}  // namespace

Canvas::Canvas(int width, int height, CanvasKind kind, const Color& background)
    : state_(std::make_unique<State>(width, height, kind)) {
  SHELLMATCH_CHECK(width > 0 && height > 0, "a canvas needs an area");
  State& s = *state_;
  s.surface = kind == CanvasKind::raster ? cairo_image_surface_create(CAIRO_FORMAT_RGB24, width, height)
              : kind == CanvasKind::svg  ? cairo_svg_surface_create_for_stream(append, &s.text, width, height)
                                         : cairo_pdf_surface_create_for_stream(append, &s.text, width, height);
  // The same bytes from the same run, whenever it is drawn.
  if (kind == CanvasKind::pdf)
    cairo_pdf_surface_set_metadata(s.surface, CAIRO_PDF_METADATA_CREATE_DATE, "2000-01-01T00:00:00Z");
  s.cairo = cairo_create(s.surface);
  check(cairo_status(s.cairo), "the canvas must be creatable");
  require_memory_to_draw();
  s.set_color(background, 1);
  cairo_paint(s.cairo);
  cairo_set_line_join(s.cairo, CAIRO_LINE_JOIN_ROUND);
  cairo_set_antialias(s.cairo, CAIRO_ANTIALIAS_GOOD);
}
Canvas::~Canvas() = default;
Canvas::Canvas(Canvas&&) noexcept = default;
Canvas& Canvas::operator=(Canvas&&) noexcept = default;

int Canvas::width() const { return state_->width; }
int Canvas::height() const { return state_->height; }

void Canvas::polyline(std::span<const Vec<2>> points, bool closed, const LineStyle& style) {
  State& s = *state_;
  trace(s.cairo, points, closed);
  s.set_color(style.color, style.alpha);
  cairo_set_line_width(s.cairo, style.width);
  cairo_set_line_cap(s.cairo, style.dashes.empty() ? CAIRO_LINE_CAP_ROUND : CAIRO_LINE_CAP_BUTT);
  cairo_set_dash(s.cairo, style.dashes.data(), static_cast<int>(style.dashes.size()), 0);
  cairo_stroke(s.cairo);
}

void Canvas::fill(std::span<const std::vector<Vec<2>>> rings, const Color& color, double alpha) {
  State& s = *state_;
  for (const std::vector<Vec<2>>& ring : rings) trace(s.cairo, ring, true);
  cairo_set_fill_rule(s.cairo, CAIRO_FILL_RULE_EVEN_ODD);
  s.set_color(color, alpha);
  cairo_fill(s.cairo);
}

void Canvas::rectangle(const Vec<2>& upper_left, const Vec<2>& size, const Color& color, double alpha) {
  State& s = *state_;
  cairo_rectangle(s.cairo, upper_left.x(), upper_left.y(), size.x(), size.y());
  s.set_color(color, alpha);
  cairo_fill(s.cairo);
}

void Canvas::disc(const Vec<2>& centre, double radius, const Color& color, double alpha) {
  State& s = *state_;
  cairo_new_sub_path(s.cairo);
  cairo_arc(s.cairo, centre.x(), centre.y(), radius, 0, 2 * std::numbers::pi);
  s.set_color(color, alpha);
  cairo_fill(s.cairo);
}

double Canvas::text_width(const std::string& words, const TextStyle& style) {
  state_->set_font(style);
  cairo_text_extents_t extents;
  // Cairo draws nothing any more after a text that is no UTF-8.
  cairo_text_extents(state_->cairo, printable(words).c_str(), &extents);
  return extents.x_advance;
}

void Canvas::text(const std::string& words, const Vec<2>& position, const TextStyle& style) {
  State& s = *state_;
  const double width = text_width(words, style);
  const double cap_height = 0.73 * style.size;  // of DejaVu Sans
  cairo_save(s.cairo);
  cairo_translate(s.cairo, position.x(), position.y());
  cairo_rotate(s.cairo, -style.turn * std::numbers::pi / 180);
  cairo_move_to(s.cairo, -style.anchor_x * width, style.anchor_y * cap_height);
  s.set_color(style.color, 1);
  cairo_show_text(s.cairo, printable(words).c_str());
  cairo_new_path(s.cairo);
  cairo_restore(s.cairo);
}

void Canvas::image(const Image& picture, int x, int y) {
  State& s = *state_;
  const OwnSurface source = surface_of(picture);
  cairo_set_source_surface(s.cairo, source.get(), x, y);
  cairo_paint(s.cairo);
  cairo_set_source_rgb(s.cairo, 0, 0, 0);
}

void Canvas::clip(const Vec<2>& upper_left, const Vec<2>& size) {
  cairo_rectangle(state_->cairo, upper_left.x(), upper_left.y(), size.x(), size.y());
  cairo_clip(state_->cairo);
}
void Canvas::unclip() { cairo_reset_clip(state_->cairo); }

Image Canvas::to_image() const {
  SHELLMATCH_CHECK(state_->kind == CanvasKind::raster, "only a raster canvas becomes an image");
  check(cairo_status(state_->cairo), "everything must have been drawn");
  return image_of(state_->surface);
}

std::string Canvas::bytes() {
  State& s = *state_;
  // Where a drawing fails, cairo remembers the error and ignores what follows.
  check(cairo_status(s.cairo), "everything must have been drawn");
  if (s.kind == CanvasKind::raster) return png_bytes(s.surface);
  cairo_surface_finish(s.surface);
  check(cairo_surface_status(s.surface), "everything must have been drawn");
  return s.text;
}

void Canvas::write(const std::string& path) { write_bytes(bytes(), path); }

Image::Image(int image_width, int image_height, const Color& color)
    : width(image_width), height(image_height), pixels(3 * static_cast<std::size_t>(width) * height) {
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) set(x, y, color);
}

void Image::set(int x, int y, const Color& color) {
  std::uint8_t* p = at(x, y);
  p[0] = static_cast<std::uint8_t>(std::lround(255 * color.r));
  p[1] = static_cast<std::uint8_t>(std::lround(255 * color.g));
  p[2] = static_cast<std::uint8_t>(std::lround(255 * color.b));
}

void write_png(const Image& image, const std::string& path) { write_bytes(png_bytes(surface_of(image).get()), path); }

Image read_png(const std::string& path) {
  const OwnSurface surface(cairo_image_surface_create_from_png(path.c_str()));
  const cairo_status_t status = cairo_surface_status(surface.get());
  if (status != CAIRO_STATUS_SUCCESS)
    throw_input_error("{}: not a readable PNG picture ({})", path, cairo_status_to_string(status));
  // Cairo uses other pixel formats only for pictures with 16 bits per channel.
  const cairo_format_t format = cairo_image_surface_get_format(surface.get());
  if (format != CAIRO_FORMAT_ARGB32 && format != CAIRO_FORMAT_RGB24)
    throw_input_error("{}: a PNG picture of more than 8 bits a channel; convert it to 8 bits", path);
  return image_of(surface.get());
}

}  // namespace shellmatch

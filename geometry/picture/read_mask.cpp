#include "geometry/picture/read_mask.h"

#include "base/error.h"
#include "base/text.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace shellmatch {
namespace {

constexpr float level = 0.5f;
constexpr double min_ring_length = 8;     // pixels
constexpr double max_area_change = 0.02;  // relative, beyond which a note says so

// The brightness that counts: of an image of two tones, whichever they are, 1 for the brighter one and 0 for the other.
class Brightness {
 public:
  explicit Brightness(const GreyImage& image) {
    const auto extremes = std::minmax_element(image.values.begin(), image.values.end());
    const float low = *extremes.first;
    high_ = *extremes.second;
    has_two_tones_ = low < high_ && std::ranges::all_of(image.values, [&](float v) { return v == low || v == high_; });
  }
  bool has_two_tones() const { return has_two_tones_; }
  float operator()(float value) const { return has_two_tones_ ? (value == high_ ? 1.0f : 0.0f) : value; }

 private:
  float high_;
  bool has_two_tones_;
};

void check_foreground(const GreyImage& image, const Brightness& brightness, const std::string& source) {
  float brightest = 0;
  std::int64_t n_rim = 0;
  for (int row = 0; row < image.height; ++row)
    for (int column = 0; column < image.width; ++column) {
      const float value = brightness(image.at(column, row));
      brightest = std::max(brightest, value);
      const bool rim = row == 0 || column == 0 || row == image.height - 1 || column == image.width - 1;
      n_rim += rim && value > level ? 1 : 0;
    }
  if (brightest <= level)
    throw_input_error(
        "{}: no pixel is brighter than half of white (the brightest has {:.3g} of it); the shape must be "
        "white on black",
        source, brightest);
  if (n_rim > 0)
    throw_input_error(
        "{}: the bright part touches the rim of the image ({}), so the shape is cut off there; add a "
        "dark margin, or exchange black and white",
        source, counted(n_rim, "pixel", "pixels"));
}

// The image as it counts, with dark pixels all around.
GreyImage padded(const GreyImage& image, const Brightness& brightness, int width) {
  GreyImage result{image.width + 2 * width, image.height + 2 * width, {}};
  result.values.assign(static_cast<std::size_t>(result.width) * result.height, 0.0f);
  for (int row = 0; row < image.height; ++row)
    for (int column = 0; column < image.width; ++column)
      result.values[static_cast<std::size_t>(row + width) * result.width + column + width] =
          brightness(image.at(column, row));
  return result;
}

// One direction of a Gaussian; `next` is the distance of neighbours in `values`. Outside is dark.
void smooth_lines(std::vector<float>& values, int n_lines, int length, std::ptrdiff_t line_step, std::ptrdiff_t next,
                  const std::vector<float>& kernel) {
  const int reach = static_cast<int>(kernel.size()) - 1;
  std::vector<float> line(static_cast<std::size_t>(length) + 2 * static_cast<std::size_t>(reach), 0.0f);
  for (int l = 0; l < n_lines; ++l) {
    float* const start = values.data() + l * line_step;
    for (int i = 0; i < length; ++i) line[i + reach] = start[i * next];
    for (int i = 0; i < length; ++i) {
      float sum = kernel[0] * line[i + reach];
      for (int k = 1; k <= reach; ++k) sum += kernel[k] * (line[i + reach - k] + line[i + reach + k]);
      start[i * next] = sum;
    }
  }
}

void smooth(GreyImage& image, double deviation) {
  std::vector<float> kernel;
  double sum = 0;
  for (int k = 0; k <= std::ceil(4 * deviation); ++k) {
    const double weight = std::exp(-0.5 * k * k / (deviation * deviation));
    kernel.push_back(static_cast<float>(weight));
    sum += k == 0 ? weight : 2 * weight;
  }
  for (float& weight : kernel) weight /= static_cast<float>(sum);
  smooth_lines(image.values, image.height, image.width, image.width, 1, kernel);
  smooth_lines(image.values, image.width, image.height, 1, image.width, kernel);
  // A corner value of exactly 1/2 would put several points of a ring in one place.
  for (float& v : image.values)
    if (std::abs(v - level) < 1e-3f) v = level + 1e-3f;
}

// Marching squares. Crossing points lie on the grid's edges; each has one successor, with bright to the left.
class MarchingSquares {
 public:
  explicit MarchingSquares(const GreyImage& image) : image_(image), n_(image.values.size()), next_(2 * n_, no_edge) {
    for (int row = 0; row + 1 < image.height; ++row)
      for (int column = 0; column + 1 < image.width; ++column) march(column, row);
  }

  // Rings of points in (column, -row) coordinates, in the order of their first edge.
  std::vector<std::vector<Vec<2>>> rings() {
    std::vector<std::vector<Vec<2>>> result;
    for (std::size_t start = 0; start < next_.size(); ++start) {
      if (next_[start] == no_edge) continue;
      result.emplace_back();
      for (std::size_t e = start; next_[e] != no_edge;) {
        result.back().push_back(point(e));
        e = std::exchange(next_[e], no_edge);
      }
    }
    return result;
  }

 private:
  static constexpr std::size_t no_edge = static_cast<std::size_t>(-1);

  std::size_t pixel(int column, int row) const { return static_cast<std::size_t>(row) * image_.width + column; }

  // Edge to the right of a pixel: its number; edge below it: n + its number.
  void march(int column, int row) {
    // Corners counter-clockwise as one sees the image: lower left, lower right, upper right, upper left.
    const std::array<float, 4> value = {image_.at(column, row + 1), image_.at(column + 1, row + 1),
                                        image_.at(column + 1, row), image_.at(column, row)};
    // Edge k runs from corner k to corner k + 1.
    const std::array<std::size_t, 4> edge = {pixel(column, row + 1), n_ + pixel(column + 1, row), pixel(column, row),
                                             n_ + pixel(column, row)};
    const auto bright = [&](std::size_t k) { return value[k % 4] > level; };
    // Along the square's border, the contour leaves where bright turns dark and enters where dark turns
    // bright.
    std::array<std::size_t, 2> leaves{}, enters{};
    std::size_t n_leaves = 0, n_enters = 0;
    for (std::size_t k = 0; k < 4; ++k) {
      if (bright(k) && !bright(k + 1)) leaves[n_leaves++] = k;
      if (!bright(k) && bright(k + 1)) enters[n_enters++] = k;
    }
    if (n_leaves == 1) {
      next_[edge[leaves[0]]] = edge[enters[0]];
    } else if (n_leaves == 2) {
      // A saddle: the mean decides whether the bright corners or the dark ones are joined.
      const bool joined = (value[0] + value[1] + value[2] + value[3]) / 4 > level;
      for (const std::size_t k : leaves) next_[edge[k]] = edge[(joined ? k + 1 : k + 3) % 4];
    }
  }

  Vec<2> point(std::size_t e) const {
    const bool right = e < n_;
    const int column = static_cast<int>((right ? e : e - n_) % image_.width);
    const int row = static_cast<int>((right ? e : e - n_) / image_.width);
    const double a = image_.at(column, row), b = right ? image_.at(column + 1, row) : image_.at(column, row + 1);
    const double t = (level - a) / (b - a);
    return right ? Vec<2>(column + t, -row) : Vec<2>(column, -row - t);
  }

  const GreyImage& image_;
  std::size_t n_;
  std::vector<std::size_t> next_;
};

double length(const std::vector<Vec<2>>& ring) {
  double sum = 0;
  for (std::size_t k = 0; k < ring.size(); ++k) sum += (ring[(k + 1) % ring.size()] - ring[k]).norm();
  return sum;
}

}  // namespace

OriginalShape<2> mask_rings(const GreyImage& image, const std::string& source, std::vector<std::string>& notes) {
  const Brightness brightness(image);
  check_foreground(image, brightness, source);
  constexpr int pad = 6;  // more than the smoothing reaches
  GreyImage smoothed = padded(image, brightness, pad);
  smooth(smoothed, brightness.has_two_tones() ? 1.0 : 0.5);
  OriginalShape<2> shape;
  std::size_t n_specks = 0;
  double area = 0;
  for (const std::vector<Vec<2>>& ring : MarchingSquares(smoothed).rings()) {
    if (length(ring) < min_ring_length) {
      ++n_specks;
      continue;
    }
    std::vector<Index> polygon;
    for (std::size_t k = 0; k < ring.size(); ++k) {
      const Vec<2>&x = ring[k], &y = ring[(k + 1) % ring.size()];
      area += 0.5 * (x.x() * y.y() - x.y() * y.x());
      polygon.push_back(static_cast<Index>(shape.vertices.size()));
      shape.vertices.emplace_back(x.x() - pad + 0.5, x.y() + pad + image.height - 0.5);
    }
    shape.polygons.push_back(std::move(polygon));
  }
  if (n_specks > 0) notes.push_back(counted(n_specks, "ring", "rings") + " shorter than 8 pixels left out");
  // Each pixel counts as far as it is bright; thin lines and small spots lose that in the smoothing.
  double bright = 0;
  for (const float v : image.values) bright += brightness(v);
  if (brightness.has_two_tones() && std::abs(area - bright) > max_area_change * bright)
    notes.push_back(
        fmt::format("smoothing the border changed the area by {:.1f} %: thin or small parts went, a finer "
                    "image would keep them",
                    100 * (area / bright - 1)));
  if (shape.polygons.empty())
    throw_input_error("{}: the bright part is too small or too thin for an outline; enlarge the image", source);
  return shape;
}

}  // namespace shellmatch

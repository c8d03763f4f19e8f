#include "geometry/picture/picture_shape.h"

#include "base/error.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <unordered_set>

namespace shellmatch {

namespace {

constexpr float half_of_white = 0.5f;

template <class Keep>
GreyImage image_of(const Picture& picture, Keep keep) {
  GreyImage image{picture.brightness.width, picture.brightness.height, std::vector<float>(picture.values.size())};
  for (std::size_t i = 0; i < picture.values.size(); ++i) image.values[i] = static_cast<float>(keep(i));
  return image;
}

// The share of the picture's outermost pixels for which `is` holds.
template <class Is>
double share_of_rim(const Picture& picture, Is is) {
  const int width = picture.brightness.width, height = picture.brightness.height;
  std::size_t n = 0, n_rim = 0;
  for (int row = 0; row < height; ++row)
    for (int column = 0; column < width; ++column) {
      if (row > 0 && row < height - 1 && column > 0 && column < width - 1) {
        column = width - 2;
        continue;
      }
      ++n_rim;
      n += is(static_cast<std::size_t>(row) * width + column);
    }
  return static_cast<double>(n) / static_cast<double>(n_rim);
}

// Up to ten of the values, as text.
std::string some_values(const Picture& picture) {
  std::set<float> values;
  for (const float v : picture.values) {
    if (!values.contains(v)) values.insert(v);
    if (values.size() > 10) return fmt::format("{:g}, ...", fmt::join(values, ", "));
  }
  return fmt::format("{:g}", fmt::join(values, ", "));
}

// What labels in pictures are told by (picture_shape.h, rule 3).
class Areas {
 public:
  explicit Areas(const Picture& picture) {
    const int width = picture.brightness.width, height = picture.brightness.height;
    std::unordered_set<float> seen, filling;
    float last = 0;
    std::size_t n_inside = 0, n_in_areas = 0, n_changes = 0, n_small_changes = 0;
    const auto at = [&](int column, int row) { return picture.values[static_cast<std::size_t>(row) * width + column]; };
    for (int row = 0; row < height; ++row)
      for (int column = 0; column < width; ++column) {
        const float value = at(column, row);
        if (value != std::floor(value)) return;
        if (column > 0 && at(column - 1, row) != value) {
          ++n_changes;
          n_small_changes += std::abs(at(column - 1, row) - value) <= 2;
        }
        if (column == 0 || at(column - 1, row) != value) seen.insert(value);
        if (seen.size() > most_labels) return;
        const bool fills = column + 1 < width && row + 1 < height && at(column + 1, row) == value &&
                           at(column, row + 1) == value && at(column + 1, row + 1) == value;
        if (fills && (filling.empty() || value != last)) filling.insert(last = value);
        if (value == 0) continue;
        ++n_inside;
        n_in_areas += fills;
      }
    n_values = seen.size();
    // Many values that follow each other are shades, not labels.
    const bool is_gradual = n_values > 16 && 2 * n_small_changes > n_changes;
    are_labels = n_values > 2 && filling.size() == n_values && 3 * n_in_areas > n_inside && !is_gradual;
  }

  std::size_t n_values = 0;  ///< 0 where they are no labels for certain
  bool are_labels = false;

 private:
  static constexpr std::size_t most_labels = 100000;
};

// Is every value one of two? The darker one first.
struct TwoValues {
  float dark = 0, bright = 0;
};
std::optional<TwoValues> two_values(const Picture& picture) {
  const auto& values = picture.values;
  const auto other = std::find_if(values.begin(), values.end(), [&](float v) { return v != values.front(); });
  if (other == values.end()) return std::nullopt;
  if (!std::all_of(other, values.end(), [&](float v) { return v == values.front() || v == *other; }))
    return std::nullopt;
  const auto& brightness = picture.brightness.values;
  const float first = brightness.front(), second = brightness[static_cast<std::size_t>(other - values.begin())];
  // Values of 16 bits may differ where their brightness does not.
  const bool ascending = first != second ? first < second : values.front() < *other;
  return ascending ? TwoValues{values.front(), *other} : TwoValues{*other, values.front()};
}

GreyImage chosen_shape(const Picture& picture, const VoxelChoice& choice, const std::string& source,
                       std::vector<std::string>& notes) {
  if (!choice.labels.empty() && (picture.is_lossy || picture.kind == PictureKind::colour))
    throw_input_error(
        "{}: the picture has {}, no labels; choose by brightness from 0 to 255, as in \"mask.png:>100\", or save "
        "labels as grey values",
        source, picture.is_lossy ? "values that its compression changed" : "colours");
  GreyImage image = image_of(picture, [&](std::size_t i) { return choice.contains(picture.values[i]) ? 1 : 0; });
  const auto n = std::ranges::count(image.values, 1.0f);
  const auto [least, most] = std::ranges::minmax_element(picture.values);
  if (n == 0)
    throw_input_error("{}: no pixel is in the shape ({}); the values are from {:g} to {:g}: {}", source, choice.text(),
                      *least, *most, some_values(picture));
  if (n == static_cast<std::ptrdiff_t>(image.values.size()))
    throw_input_error("{}: every pixel is in the shape ({}); the values are from {:g} to {:g}", source, choice.text(),
                      *least, *most);
  notes.push_back(fmt::format("{}: {} pixels", choice.text(), n));
  return image;
}

}  // namespace

GreyImage shape_of_picture(const Picture& picture, const std::optional<VoxelChoice>& choice, const std::string& source,
                           std::vector<std::string>& notes) {
  notes.insert(notes.end(), picture.notes.begin(), picture.notes.end());
  const std::vector<float>&values = picture.values, &brightness = picture.brightness.values;
  if (choice) return chosen_shape(picture, *choice, source, notes);
  if (const auto two = two_values(picture)) {
    const bool is_dark = share_of_rim(picture, [&](std::size_t i) { return values[i] == two->bright; }) > 0.5;
    if (is_dark) notes.push_back("most of the rim is bright: the dark part is the shape");
    return image_of(picture, [&](std::size_t i) { return (values[i] == two->bright) != is_dark ? 1 : 0; });
  }
  if (!picture.is_lossy && share_of_rim(picture, [&](std::size_t i) { return values[i] == 0; }) > 0.5) {
    const Areas areas(picture);
    if (areas.are_labels) {
      notes.push_back(fmt::format(
          "a picture of {} {} (0, the background, not counted; values {}): all that is not {} is the shape{}",
          areas.n_values - 1, picture.kind == PictureKind::colour ? "colours" : "labels", some_values(picture),
          picture.kind == PictureKind::colour ? "black" : "0",
          picture.kind == PictureKind::colour ? "" : "; FILE:N chooses the label N"));
      return image_of(picture, [&](std::size_t i) { return values[i] != 0 ? 1 : 0; });
    }
  }
  const bool is_dark = share_of_rim(picture, [&](std::size_t i) { return brightness[i] > half_of_white; }) > 0.5;
  const bool is_uniform = std::ranges::all_of(values, [&](float v) { return v == values.front(); });
  if (is_dark && !is_uniform) {
    notes.push_back("a picture of shades, most of its rim bright: what is darker than half of white is the shape");
    return image_of(picture, [&](std::size_t i) { return 1 - brightness[i]; });
  }
  const auto [least, most] = std::ranges::minmax_element(values);
  if (picture.kind == PictureKind::grey && !is_uniform && *std::ranges::max_element(brightness) <= half_of_white)
    throw_input_error(
        "{0}: no pixel is brighter than half of white, and the values, from {1:g} to {2:g}, are not labels that fill "
        "areas; choose a "
        "threshold, as in \"{0}:>{3:g}\"",
        source, *least, *most, std::floor(0.5 * (*least + *most)));
  notes.push_back("a picture of shades: what is brighter than half of white is the shape");
  return picture.brightness;
}

}  // namespace shellmatch

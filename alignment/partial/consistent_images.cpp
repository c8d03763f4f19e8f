#include "alignment/partial/consistent_images.h"

#include <algorithm>
#include <cstddef>
#include <tuple>
#include <utility>

namespace shellmatch {

namespace {

constexpr float unlikeness_weight = 2;
// A difference of distances counts as 1 where it reaches `coarse`, between samples and along edges, and this share of
// the distance.
constexpr float coarse = 0.05F, lengthened = 0.3F, shortened = 0.1F;
constexpr float largest = 4;         // what one pair of distances adds at most: ways around a cut may be anything
constexpr float alike = 0.12F;       // assignments whose images all lie so near are the same
constexpr float akin = 0.4F;         // and those that lie so near are variants of one: no limb is another
constexpr std::size_t n_kinds = 10;  // variants of one are at most this part of all that go on
constexpr std::size_t offered = 30;  // for each one that goes on

float stretch(float on_part, float on_whole) {
  const float more = on_part - on_whole;
  const float ratio = more / (coarse + (more > 0 ? lengthened : shortened) * on_part);
  return std::min(largest, ratio * ratio);
}

/// A placement of the samples so far, and one more.
struct Extended {
  float cost;
  std::size_t from;
  int image;
  bool operator<(const Extended& other) const {
    return std::tuple(cost, from, image) < std::tuple(other.cost, other.from, other.image);
  }
};

/// Placements that differ little from the first of them.
struct Variants {
  std::vector<int> images;
  std::size_t n;
};

}  // namespace

std::vector<SampleImages> consistent_images(const SampleDistances& distances, std::size_t width) {
  const Eigen::Index n = distances.on_whole.rows();
  std::vector<SampleImages> kept(1);
  for (Eigen::Index m = 0; m < distances.on_part.rows(); ++m) {
    std::vector<Extended> all;
    all.reserve(kept.size() * static_cast<std::size_t>(n));
    for (std::size_t from = 0; from < kept.size(); ++from) {
      Eigen::ArrayXf costs = unlikeness_weight * distances.unlikeness.row(m).transpose().array() + kept[from].cost;
      for (Eigen::Index a = 0; a < m; ++a) {
        const auto of_image = distances.on_whole.col(kept[from].images[static_cast<std::size_t>(a)]);
        for (Eigen::Index i = 0; i < n; ++i)
          costs[i] += stretch(distances.on_part(a, m), of_image[i]) / static_cast<float>(m);
      }
      for (Eigen::Index i = 0; i < n; ++i) all.push_back({costs[i], from, static_cast<int>(i)});
    }
    const std::size_t n_offered = std::min(all.size(), offered * width);
    std::partial_sort(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(n_offered), all.end());
    std::vector<SampleImages> next;
    std::vector<Variants> kinds;
    for (std::size_t k = 0; k < n_offered && next.size() < width; ++k) {
      SampleImages extended{kept[all[k].from].images, all[k].cost};
      extended.images.push_back(all[k].image);
      const auto is_within = [&](const std::vector<int>& images, float limit) {
        for (std::size_t a = 0; a < images.size(); ++a)
          if (distances.on_whole(extended.images[a], images[a]) >= limit) return false;
        return true;
      };
      // Otherwise variants of one would crowd out the others, as those of a mirrored placement the right ones.
      auto kind = std::ranges::find_if(kinds, [&](const Variants& v) { return is_within(v.images, akin); });
      if (kind == kinds.end()) kind = kinds.insert(kind, {extended.images, 0});
      if (kind->n >= std::max<std::size_t>(1, width / n_kinds)) continue;
      if (std::ranges::any_of(next, [&](const SampleImages& other) { return is_within(other.images, alike); }))
        continue;
      ++kind->n;
      next.push_back(std::move(extended));
    }
    kept = std::move(next);
  }
  for (SampleImages& k : kept) k.cost /= static_cast<float>(std::max<Eigen::Index>(1, distances.on_part.rows()));
  return kept;
}

}  // namespace shellmatch

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
  std::size_t from;  ///< the kept placement that the first one goes on from
  int image;         ///< its last one
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
    const auto end_offered = all.begin() + static_cast<std::ptrdiff_t>(std::min(all.size(), offered * width));
    std::nth_element(all.begin(), end_offered, all.end());
    std::sort(all.begin(), end_offered);
    std::vector<SampleImages> next;
    std::vector<Variants> kinds;
    // Those that go on from one placement. From two, which were not alike before, no two are alike.
    std::vector<std::vector<int>> last_images(kept.size());
    for (auto way = all.begin(); way != end_offered && next.size() < width; ++way) {
      const auto is_within = [&](int image, float limit) { return distances.on_whole(way->image, image) < limit; };
      const auto begins_akin = [&](std::size_t from) {
        const std::vector<int>&images = kept[way->from].images, &others = kept[from].images;
        return std::ranges::equal(images, others, [&](int i, int j) { return distances.on_whole(i, j) < akin; });
      };
      // Otherwise variants of one would crowd out the others, as those of a mirrored placement the right ones.
      auto kind = std::ranges::find_if(
          kinds, [&](const Variants& v) { return is_within(v.image, akin) && begins_akin(v.from); });
      if (kind == kinds.end()) kind = kinds.insert(kind, {way->from, way->image, 0});
      if (kind->n >= std::max<std::size_t>(1, width / n_kinds)) continue;
      std::vector<int>& before = last_images[way->from];
      if (std::ranges::any_of(before, [&](int image) { return is_within(image, alike); })) continue;
      ++kind->n;
      before.push_back(way->image);
      next.push_back({kept[way->from].images, way->cost});
      next.back().images.push_back(way->image);
    }
    kept = std::move(next);
  }
  for (SampleImages& k : kept) k.cost /= static_cast<float>(std::max<Eigen::Index>(1, distances.on_part.rows()));
  return kept;
}

}  // namespace shellmatch

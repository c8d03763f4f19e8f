#pragma once
/// \file
/// Which of many boxes overlap.

#include "base/stop.h"
#include "geometry/surface/surface.h"

#include <algorithm>
#include <cstdint>
#include <type_traits>
#include <utility>
#include <vector>

namespace shellmatch {

/// Finds overlapping pairs by division of space. A box is in every part that it reaches; a pair is visited in the one
/// part that holds the lower corner of what the two share. Parts are halved at a mean or median of the boxes' centres
/// while that separates boxes.
template <int Dim, class Visit>
class OverlappingBoxes {
 public:
  OverlappingBoxes(const std::vector<Box<Dim>>& boxes, Visit& visit) : boxes_(boxes), visit_(visit) {}

  void run() {
    std::vector<std::uint32_t> all(boxes_.size());
    for (std::size_t i = 0; i < all.size(); ++i) all[i] = static_cast<std::uint32_t>(i);
    Box<Dim> everywhere;
    std::swap(everywhere.min, everywhere.max);
    search(all, everywhere);
  }

 private:
  using Members = std::vector<std::uint32_t>;
  static constexpr std::size_t few = 12;

  double centre(std::uint32_t i, int axis) const { return 0.5 * (boxes_[i].min[axis] + boxes_[i].max[axis]); }

  void compare_all(const Members& members, const Box<Dim>& part) {
    for (std::size_t i = 0; i < members.size(); ++i) {
      if (i % 64 == 0 && members.size() > 1000) stop_if_wanted();
      const Box<Dim>& a = boxes_[members[i]];
      for (std::size_t j = i + 1; j < members.size(); ++j) {
        const Box<Dim>& b = boxes_[members[j]];
        bool is_here = true;
        for (int k = 0; k < Dim && is_here; ++k) {
          const double low = std::max(a.min[k], b.min[k]);
          is_here = low <= std::min(a.max[k], b.max[k]) && low >= part.min[k] && low < part.max[k];
        }
        if (is_here) visit_(members[i], members[j]);
      }
    }
  }

  // The members below and above a plane; empty where it separates too few.
  std::pair<Members, Members> divided(const Members& members, int axis, double at) const {
    std::pair<Members, Members> parts;
    for (const std::uint32_t i : members) {
      if (boxes_[i].min[axis] < at) parts.first.push_back(i);
      if (boxes_[i].max[axis] >= at) parts.second.push_back(i);
    }
    const std::size_t n = members.size();
    if (4 * std::max(parts.first.size(), parts.second.size()) > 3 * n + 4) return {};
    return parts;
  }

  double mean_centre(const Members& members, int axis) const {
    double sum = 0;
    for (const std::uint32_t i : members) sum += centre(i, axis);
    return sum / static_cast<double>(members.size());
  }

  double median_centre(const Members& members, int axis) const {
    std::vector<double> centres;
    for (const std::uint32_t i : members) centres.push_back(centre(i, axis));
    const auto middle = centres.begin() + static_cast<std::ptrdiff_t>(centres.size() / 2);
    std::nth_element(centres.begin(), middle, centres.end());
    return *middle;
  }

  void search(const Members& members, const Box<Dim>& part) {
    if (members.size() <= few) return compare_all(members, part);
    stop_if_wanted();
    Box<Dim> centres;
    for (const std::uint32_t i : members) centres.add(0.5 * (boxes_[i].min + boxes_[i].max));
    int axes[Dim];
    for (int k = 0; k < Dim; ++k) axes[k] = k;
    const Vec<Dim> size = centres.max - centres.min;
    std::sort(axes, axes + Dim, [&](int a, int b) { return size[a] > size[b]; });
    for (const int axis : axes)
      for (const bool by_mean : {true, false}) {
        const double at = by_mean ? mean_centre(members, axis) : median_centre(members, axis);
        const auto [below, above] = divided(members, axis, at);
        if (below.empty() && above.empty()) continue;
        Box<Dim> half = part;
        half.max[axis] = at;
        search(below, half);
        half = part;
        half.min[axis] = at;
        return search(above, half);
      }
    compare_all(members, part);
  }

  const std::vector<Box<Dim>>& boxes_;
  Visit& visit_;
};

/// Calls visit(i, j) once for every two boxes that overlap or touch, in no order that matters. \pre finite coordinates
template <int Dim, class Visit>
void for_overlapping_boxes(const std::vector<Box<Dim>>& boxes, Visit&& visit) {
  OverlappingBoxes<Dim, std::remove_reference_t<Visit>>(boxes, visit).run();
}

}  // namespace shellmatch

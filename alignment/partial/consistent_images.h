#pragma once
/// \file
/// Where samples of a part may lie on a whole, so that their distances agree.

#include <Eigen/Core>

#include <vector>

namespace shellmatch {

/// What is known of m samples of a part and n of a whole; lengths in roots of the whole's area.
struct SampleDistances {
  Eigen::MatrixXf on_part;     ///< m x m
  Eigen::MatrixXf on_whole;    ///< n x n
  Eigen::MatrixXf unlikeness;  ///< m x n: how little the surroundings resemble each other, 0 alike
};

struct SampleImages {
  std::vector<int> images;  ///< of each sample of the part, one of the whole
  float cost = 0;           ///< per sample; 0 where distances are the same and surroundings alike
};

/// Assignments of little cost that differ from one another, at most `width`, ascending. A beam search: samples are
/// placed in turn, and of all ways so far the cheapest that differ go on, of those that differ by less than 0.4
/// everywhere at most a tenth. Ways on a surface with holes are longer than those on the whole, but not shorter, so
/// that lengthening costs less. Mirrored assignments cost the same.
std::vector<SampleImages> consistent_images(const SampleDistances& distances, std::size_t width);

}  // namespace shellmatch

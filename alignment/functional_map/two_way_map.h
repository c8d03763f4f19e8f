#pragma once
/// \file
/// A map between two surfaces in both directions: points that correspond, and the matrix of the functional map.
///
/// A functional map C carries the coefficients of a function on surface 2 to those of the same function on surface 1:
/// functions_1 C a_2 is f_2 read through the map from surface 1 to surface 2. Ovsjanikov, Ben-Chen, Solomon, Butscher
/// and Guibas, 'Functional maps: a flexible representation of maps between shapes', SIGGRAPH 2012. Between isometric
/// surfaces C is orthogonal; in general its transpose is taken for the map the other way.

#include "alignment/functional_map/nearest_features.h"
#include "alignment/spectrum/spectral_shape.h"

#include <algorithm>
#include <array>
#include <span>

namespace shellmatch {

/// Some vertices of a surface, which are searched for images or have images themselves.
struct VertexSet {
  std::vector<Index> vertices;                    ///< m
  Features functions;                             ///< k x m: the eigenfunctions there
  std::vector<Index> order = {};                  ///< compact_order() of the functions, or empty
  std::vector<std::array<Index, 3>> facets = {};  ///< of the surface, around these vertices; empty: all

  std::size_t size() const { return vertices.size(); }
};

/// Fewer landmarks do not tell a map.
inline constexpr std::size_t n_least_landmarks = 4;

/// Both surfaces at two resolutions.
struct ShapePairSpectra {
  const SpectralShape* shapes[2];
  Features functions[2];  ///< k x n: the eigenfunctions at all vertices, in their order
  SmoothedSurfaces smoothed[2];
  Features local[2];                               ///< p x n: main components of the spin images of both
  Eigen::MatrixXd signatures[2];                   ///< m x n: SpectralShape::signature, a column for each vertex
  VertexSet coarsest[2];                           ///< of `coarse`, as many as few functions need
  VertexSet coarse[2];                             ///< the vertices of landmarks, then the other samples
  VertexSet dense[2];                              ///< all vertices: those of `coarse`, then the others
  int n_functions;                                 ///< of both
  std::vector<std::pair<Index, Index>> landmarks;  ///< pairs of vertices; the first of both sets, in this order
};

/// \param landmarks vertices of both that are known to correspond;
///   those of which a vertex has been named before are left out,
///   and all where fewer than n_least_landmarks remain
/// \pre the shapes outlive the result
ShapePairSpectra make_shape_pair(const SpectralShape& shape_1, const SpectralShape& shape_2,
                                 const std::vector<std::pair<Index, Index>>& landmarks = {});

/// Weight of the normals in the embeddings of a search, where a function has mean square 1.
inline constexpr double embedded_normal_weight = 2;

/// Images of vertices of either surface on the other one.
struct VertexMatches {
  std::vector<Index> from[2];  ///< vertices of surface 1, and of surface 2
  std::vector<Index> to[2];    ///< their images, vertices of the other surface
};

/// The orthogonal k x k matrix C that minimises the sum of |functions_1(p) C - functions_2(q)|^2 over all pairs (p, q).
/// It keeps maps from leaving out parts, so that it serves the search.
Eigen::MatrixXd orthogonal_map(const ShapePairSpectra& pair, const VertexMatches& matches, int k);

/// The k x k matrix C between both least squares problems: the mean of the minimiser of the sum of
/// |functions_1(p) C - functions_2(q)|^2 over all pairs (p, q), and of that of |functions_1(p) - functions_2(q) C^T|^2.
/// Where the surfaces are far from isometric it is far from orthogonal, and refinement with it is much more exact
/// (docs/alignment.md).
/// \param landmark_weights of each landmark, where all pairs together have weight 1; empty: landmarks do not count
Eigen::MatrixXd functional_map(const ShapePairSpectra& pair, const VertexMatches& matches, int k,
                               std::span<const double> landmark_weights = {});

/// Of each landmark, the larger of the distances, on either surface, between where the map takes its point and where it
/// belongs, in roots of the area. \pre `matches` are those of a set of `pair`, from its beginning
std::vector<double> landmark_distances(const ShapePairSpectra& pair, const VertexMatches& matches);

/// The part of the landmarks' distances from where the map takes them that even near ones do not share, in the median,
/// in roots of the area: errors of maps grow apart with distance, those of landmarks do not. Half the square by which
/// they differ is extrapolated from pairs of near landmarks to no distance, so that few landmarks far from each other
/// tell as well. \pre as landmark_distances(); two at least
double landmark_noise(const ShapePairSpectra& pair, const VertexMatches& matches);

/// Vectors that nearly agree at corresponding points, a column for each vertex of a set on either surface.
struct Embedding {
  Features on[2];
};

/// The first k eigenfunctions, those of surface 1 through C (k x k), and `normal_weight` times normals: those of either
/// surface smoothed to k functions, and those of the other surface's smoothed coordinates pulled back to it. The latter
/// change sign where a map reverses orientation, in any pose. As in Eisenberger, Laehner and Cremers, 'Smooth shells',
/// CVPR 2020. Then `local_weight` times ShapePairSpectra::local, which tell front from back where functions as smooth
/// as these do not, as at a head.
Embedding spectral_embedding(const ShapePairSpectra& pair, const VertexSet (&sets)[2], const Eigen::MatrixXd& c,
                             double normal_weight, double local_weight = 0);

/// The embedding of all vertices, in their order, with the weight of normals that the search uses.
Embedding dense_embedding(const ShapePairSpectra& pair, const Eigen::MatrixXd& c, double local_weight = 0);

/// The weight of ShapePairSpectra::local beside functions through C that fit these matches: at most 8 for surfaces of
/// 5000 vertices (errors are alike for 6 to 10) and less for fewer, and less the more exactly functions fit, as on one
/// shape with two triangulations.
double local_weight(const ShapePairSpectra& pair, const VertexMatches& matches, const Eigen::MatrixXd& c);

/// For the first `n_queries` vertices of each set, the nearest of the other set in the embedding.
VertexMatches match_vertices(const VertexSet (&sets)[2], const Embedding& embedding, std::size_t n_queries);

/// All matches as (vertex of surface 1, vertex of surface 2): first those from 1, then those from 2, so that a pair
/// found both ways stands twice.
std::vector<std::pair<Index, Index>> pairs_of(const VertexMatches& matches);

}  // namespace shellmatch

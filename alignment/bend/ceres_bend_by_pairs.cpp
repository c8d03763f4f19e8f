#include "alignment/bend/bend_by_pairs.h"
#include "alignment/bend/deformation_graph.h"
#include "base/parallel.h"
#include "geometry/distance/facet_tree.h"
#include "geometry/surface/facet_point.h"

#include <ceres/ceres.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace shellmatch {

namespace {

constexpr std::size_t n_nodes = 400;  // on people and animals 200 and 800 ended alike
// Of the turns between neighbours; without, surfaces that are pressed turn inside out.
constexpr double turn_weight = 0.3;
// Roots of the area. Limbs begin far from where they belong; at the end the scale is that of errors of the pairs.
constexpr double first_scale = 0.3, last_scale = 0.03, scale_factor = 0.6;
constexpr int n_iterations = 5;  // at each scale
// Of all pairs together, at weight 1: how many they are does not change how stiff the surface is.
constexpr double pull = 1000;

/// The edge from node a to node b, which turns with a, against its new position. All lengths are in roots of the area.
struct EdgeStretch {
  Vec<3> edge;
  double root_weight;

  template <class T>
  bool operator()(const T* turn_a, const T* shift_a, const T* shift_b, T* residual) const {
    using Vector = Eigen::Matrix<T, 3, 1>;
    const Eigen::Map<const Eigen::Quaternion<T>> turn(turn_a);
    const Vector e = edge.cast<T>();
    Eigen::Map<Vector>{residual} =
        T(root_weight) * (turn * e + Eigen::Map<const Vector>(shift_a) - e - Eigen::Map<const Vector>(shift_b));
    return true;
  }
};

/// The turn of node b against node a, in radians where it is small.
struct EdgeTurn {
  double root_weight;

  template <class T>
  bool operator()(const T* turn_a, const T* turn_b, T* residual) const {
    using Turn = Eigen::Map<const Eigen::Quaternion<T>>;
    const Eigen::Quaternion<T> turn = Turn(turn_a).conjugate() * Turn(turn_b);
    const T factor(turn.w() < T(0) ? -2 * root_weight : 2 * root_weight);  // q and -q are one rotation
    for (int k = 0; k < 3; ++k) residual[k] = factor * turn.vec()[k];
    return true;
  }
};

/// A point carried by its nodes, whose turns and shifts alternate, against where it belongs.
struct PairDistance {
  struct Node {
    Vec<3> centre;
    double weight;
  };
  std::vector<Node> nodes;
  Vec<3> point, goal;

  template <class T>
  bool operator()(const T* const* motions, T* residual) const {
    using Vector = Eigen::Matrix<T, 3, 1>;
    Vector sum = -goal.cast<T>();
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      const Eigen::Map<const Eigen::Quaternion<T>> turn(motions[2 * i]);
      const Vector from = (point - nodes[i].centre).cast<T>(), centre = nodes[i].centre.cast<T>();
      sum += T(nodes[i].weight) * (turn * from + centre + Eigen::Map<const Vector>(motions[2 * i + 1]));
    }
    Eigen::Map<Vector>{residual} = sum;
    return true;
  }
};

class Bending {
 public:
  Bending(const DeformationGraph& graph, double length)
      : graph_(graph), length_(length), motions_(graph.centres().size()) {
    for (NodeMotion& m : motions_) {
      problem_.AddParameterBlock(turn(m), 4, new ceres::EigenQuaternionManifold);
      problem_.AddParameterBlock(shift(m), 3);
    }
    for (const DeformationGraph::Edge& edge : graph.edges()) {
      NodeMotion &a = motions_[edge.from], &b = motions_[edge.to];
      const Vec<3> e = (graph.centres()[edge.to] - graph.centres()[edge.from]) / length;
      problem_.AddResidualBlock(
          new ceres::AutoDiffCostFunction<EdgeStretch, 3, 4, 3, 3>(new EdgeStretch{e, std::sqrt(edge.weight)}), nullptr,
          turn(a), shift(a), shift(b));
      if (edge.from < edge.to)
        problem_.AddResidualBlock(new ceres::AutoDiffCostFunction<EdgeTurn, 3, 4, 4>(
                                      new EdgeTurn{std::sqrt(turn_weight * edge.weight) * e.norm()}),
                                  nullptr, turn(a), turn(b));
    }
  }

  void add(const CorrespondingPoints& pair, Index vertex) {
    auto* distance = new PairDistance{{}, pair.on_reference / length_, pair.on_template / length_};
    auto* cost = new ceres::DynamicAutoDiffCostFunction<PairDistance, 7>(distance);
    cost->SetNumResiduals(3);
    std::vector<double*> blocks;
    const DeformationGraph::Influence& influence = graph_.influence(vertex);
    for (std::size_t i = 0; i < DeformationGraph::n_influences; ++i) {
      if (influence.weights[i] == 0) continue;
      distance->nodes.push_back({graph_.centres()[influence.nodes[i]] / length_, influence.weights[i]});
      NodeMotion& m = motions_[influence.nodes[i]];
      blocks.insert(blocks.end(), {turn(m), shift(m)});
      cost->AddParameterBlock(4);
      cost->AddParameterBlock(3);
    }
    losses_.push_back({new ceres::LossFunctionWrapper(nullptr, ceres::TAKE_OWNERSHIP), pair.weight});
    problem_.AddResidualBlock(cost, losses_.back().function, blocks);
  }

  /// With a loss that narrows: what is far at first has its pull, and loses it where the rest says otherwise.
  std::vector<NodeMotion> solve() {
    ceres::Solver::Options options;
    options.linear_solver_type = ceres::SPARSE_NORMAL_CHOLESKY;
    options.max_num_iterations = n_iterations;
    options.function_tolerance = 1e-4;
    options.num_threads = 1;  // for the same bits
    options.logging_type = ceres::SILENT;
    for (double scale = first_scale; scale > last_scale; scale *= scale_factor) {
      for (const auto& [loss, weight] : losses_)
        loss->Reset(new ceres::ScaledLoss(new ceres::CauchyLoss(scale),
                                          weight * pull / static_cast<double>(losses_.size()), ceres::TAKE_OWNERSHIP),
                    ceres::TAKE_OWNERSHIP);
      ceres::Solver::Summary summary;
      ceres::Solve(options, &problem_, &summary);
    }
    std::vector<NodeMotion> motions = motions_;
    for (NodeMotion& m : motions) m.translation *= length_;
    return motions;
  }

 private:
  static double* turn(NodeMotion& m) { return m.rotation.coeffs().data(); }
  static double* shift(NodeMotion& m) { return m.translation.data(); }

  struct Loss {
    ceres::LossFunctionWrapper* function;  ///< the problem's
    double weight;
  };

  const DeformationGraph& graph_;
  const double length_;
  std::vector<NodeMotion> motions_;  ///< translations in units of `length_`
  std::vector<Loss> losses_;
  ceres::Problem problem_;
};

// The corner of the nearest facet that is nearest.
Index nearest_vertex(const Surface<3>& surface, const FacetTree<3>& tree, const Vec<3>& x) {
  const auto& facet = surface.facets[tree.nearest(x)];
  return *std::ranges::min_element(facet, {}, [&](Index v) { return (surface.vertices[v] - x).squaredNorm(); });
}

}  // namespace

std::vector<Vec<3>> bend_by_pairs(const Surface<3>& surface, std::span<const CorrespondingPoints> pairs) {
  const DeformationGraph graph(surface, n_nodes);
  Bending bending(graph, std::sqrt(surface_measure(surface)));
  const FacetTree<3> tree(surface);
  for (const CorrespondingPoints& pair : pairs) bending.add(pair, nearest_vertex(surface, tree, pair.on_reference));
  const std::vector<NodeMotion> motions = bending.solve();
  std::vector<Vec<3>> bent(surface.vertices.size());
  parallel_for(bent.size(),
               [&](std::size_t v) { bent[v] = graph.moved(static_cast<Index>(v), surface.vertices[v], motions); });
  return bent;
}

}  // namespace shellmatch

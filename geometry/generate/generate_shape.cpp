#include "geometry/generate/generate_shape.h"

#include "base/error.h"
#include "geometry/generate/families.h"
#include "geometry/generate/hand.h"

#include <deque>
#include <memory>
#include <mutex>

namespace shellmatch {

namespace {

template <int Dim>
OriginalShape<Dim> posed(const Body<Dim>& body, std::string_view name) {
  OriginalShape<Dim> shape;
  for (const Vec<Dim>& x : body.rest.vertices) {
    shape.vertices.push_back(body.pose(x));
    const Vec<Dim>& y = shape.vertices.back();
    if (!(y.minCoeff() >= 0.05 && y.maxCoeff() <= 0.95))
      throw_input_error(
          "{}: with these parameters the shape leaves [0.05, 0.95]^{}; choose smaller or less extreme ones", name, Dim);
  }
  if constexpr (Dim == 3) {
    for (const auto& facet : body.rest.facets) shape.polygons.emplace_back(facet.begin(), facet.end());
  } else {
    // An outline is one ring of points in order.
    shape.polygons.emplace_back();
    for (const auto& facet : body.rest.facets) shape.polygons.front().push_back(facet[0]);
  }
  return shape;
}

/// A family's body. The last two are kept: a run asks for both shapes first and for their known positions later.
std::shared_ptr<const AnyBody> built(const Family& family, const GeneratorParameters& parameters, double edge_length) {
  struct Kept {
    std::string name;
    GeneratorParameters parameters;
    double edge_length;
    std::shared_ptr<const AnyBody> body;
  };
  static std::mutex mutex;
  static std::deque<Kept> kept;
  {
    const std::lock_guard lock(mutex);
    for (const Kept& one : kept)
      if (one.name == family.info.name && one.parameters == parameters && one.edge_length == edge_length)
        return one.body;
  }
  const auto body = std::make_shared<const AnyBody>(family.build(parameters, edge_length));
  const std::lock_guard lock(mutex);
  kept.push_back({family.info.name, parameters, edge_length, body});
  if (kept.size() > 2) kept.pop_front();
  return body;
}

double checked_edge_length(const GeneratorInfo& info, double edge_length) {
  if (edge_length == 0) return info.edge_length;
  if (!(edge_length >= 0.003 && edge_length <= 0.05))
    throw_input_error("{}: edge length {:g} is out of range; give 0.003 <= x <= 0.05, or 0 for {:g}", info.name,
                      edge_length, info.edge_length);
  return edge_length;
}

HandOptions hand_options(const GeneratorParameters& p) {
  return {.spread = p.at("spread"),
          .bend_thumb = p.at("bend_thumb"),
          .bend_index = p.at("bend_index"),
          .bend_middle = p.at("bend_middle"),
          .bend_ring = p.at("bend_ring"),
          .bend_little = p.at("bend_little")};
}

template <int Dim>
KnownPositions<Dim> truth_between(const Family& family, const GeneratorParameters& from, const GeneratorParameters& to,
                                  const std::vector<Vec<Dim>>& rest, const Body<Dim>& target) {
  const std::string& name = family.info.name;
  KnownPositions<Dim> truth;
  if (name == "beet" || name == "face") return truth;
  for (Index v = 0; v < static_cast<Index>(rest.size()); ++v)
    if (name != "hand") truth.push_back({v, target.pose(rest[v])});
  if constexpr (Dim == 3)
    if (name == "hand") {
      const Hand hand(hand_options(from)), other(hand_options(to));
      for (Index v = 0; v < static_cast<Index>(rest.size()); ++v)
        if (const auto y = hand.corresponding_point(other, rest[v])) truth.push_back({v, *y});
    }
  return truth;
}

template <int Dim>
GeneratedPair<Dim> make_pair(const Family& family, double edge_length) {
  const std::string& name = family.info.name;
  const GeneratorParameters &from = family.info.variants[0].values, &to = family.info.variants[1].values;
  const auto reference = std::get<Body<Dim>>(family.build(from, edge_length));
  const auto target = std::get<Body<Dim>>(family.build(to, 1.2 * edge_length));
  return {posed(reference, name), posed(target, name),
          truth_between<Dim>(family, from, to, reference.rest.vertices, target)};
}

}  // namespace

std::vector<GeneratorInfo> generator_catalogue() {
  std::vector<GeneratorInfo> catalogue;
  for (const Family& f : families()) catalogue.push_back(f.info);
  return catalogue;
}

AnyOriginal generate_shape(std::string_view name, std::string_view variant, double edge_length,
                           const GeneratorParameters& parameters) {
  const Family& family = find_family(name);
  const GeneratorParameters complete = complete_parameters(family.info, variant, parameters);
  return std::visit([&](const auto& body) -> AnyOriginal { return posed(body, name); },
                    *built(family, complete, checked_edge_length(family.info, edge_length)));
}

AnyKnownPositions known_positions(std::string_view name, std::string_view from, std::string_view to) {
  const Family& family = find_family(name);
  const GeneratorParameters first = complete_parameters(family.info, from, {});
  const GeneratorParameters second = complete_parameters(family.info, to, {});
  const auto known = [&]<int Dim>(std::integral_constant<int, Dim>) -> AnyKnownPositions {
    const auto reference = built(family, first, family.info.edge_length),
               target = built(family, second, family.info.edge_length);
    return truth_between<Dim>(family, first, second, std::get<Body<Dim>>(*reference).rest.vertices,
                              std::get<Body<Dim>>(*target));
  };
  if (family.info.dimension == 2) return known(std::integral_constant<int, 2>());
  return known(std::integral_constant<int, 3>());
}

AnyPair generated_pair(std::string_view name, double edge_length) {
  const Family& family = find_family(name);
  const double edge = checked_edge_length(family.info, edge_length);
  if (family.info.dimension == 2) return make_pair<2>(family, edge);
  return make_pair<3>(family, edge);
}

}  // namespace shellmatch

#include "geometry/generate/families.h"

#include "base/error.h"
#include "geometry/generate/dolphin.h"
#include "geometry/generate/hand.h"
#include "geometry/generate/implicit_bodies.h"
#include "geometry/generate/outline.h"
#include "geometry/generate/round.h"

#include <fmt/ranges.h>

#include <cmath>
#include <type_traits>

namespace shellmatch {

namespace {

struct ListParameters {
  std::vector<GeneratorParameter> parameters;
  template <class T>
  void operator()(std::string_view name, const T& value, const OptionInfo& info) {
    parameters.push_back({std::string(name), static_cast<double>(value), std::is_integral_v<T>, info});
  }
};

struct SetParameters {
  const GeneratorParameters& values;
  template <class T>
  void operator()(std::string_view name, T& value, const OptionInfo&) {
    value = static_cast<T>(values.at(std::string(name)));
  }
};

template <class Options>
struct Variant {
  std::string name, meaning;
  Options options;
};

template <int Dim, class Options>
Family family(std::string name, std::string meaning, double edge_length, Body<Dim> (*build)(const Options&, double),
              std::vector<Variant<Options>> variants) {
  Family f;
  f.info = {std::move(name), std::move(meaning), Dim, 0, edge_length, {}, {}};
  for (const Variant<Options>& v : variants) {
    ListParameters list;
    Options::describe(v.options, list);
    GeneratorVariant entry{v.name, v.meaning, {}};
    for (const GeneratorParameter& p : list.parameters) entry.values.emplace(p.name, p.default_value);
    f.info.variants.push_back(std::move(entry));
    if (f.info.parameters.empty()) f.info.parameters = std::move(list.parameters);
  }
  f.build = [build](const GeneratorParameters& values, double edge) -> AnyBody {
    Options options;
    SetParameters set{values};
    Options::describe(options, set);
    return build(options, edge);
  };
  return f;
}

std::vector<Family> make_families() {
  std::vector<Family> all;
  all.push_back(family<3, SphereOptions>("sphere", "a sphere", 0.01, &sphere_body,
                                         {{"large", "radius 0.25", {}}, {"small", "radius 0.18", {.radius = 0.18}}}));
  all.push_back(family<3, EllipsoidOptions>(
      "ellipsoid", "an ellipsoid; corresponds to every sphere", 0.01, &ellipsoid_body,
      {{"round", "a sphere of radius 0.25", {.semi_x = 0.25, .semi_y = 0.25, .semi_z = 0.25}},
       {"long", "three different semi-axes", {}}}));
  all.push_back(
      family<3, TorusOptions>("torus", "a torus about the z axis", 0.01, &torus_body,
                              {{"thick", "radii 0.26 and 0.1", {}},
                               {"thin", "radii 0.29 and 0.075", {.major_radius = 0.29, .minor_radius = 0.075}}}));
  all.back().info.genus = 1;
  all.push_back(family<3, BoxOptions>(
      "box", "a box with rounded edges", 0.01, &box_body,
      {{"cube", "a cube", {}},
       {"compressed", "the cube compressed to 64 % and turned by 25 degrees", {.compression = 0.64, .turn = 25}}}));
  all.push_back(family<3, BeetOptions>("beet", "a sugar beet: root, crown, grooves, uneven skin", 0.0075, &beet_body,
                                       {{"first", "a fat beet", {}},
                                        {"second",
                                         "a slimmer one that bends the other way",
                                         {.width = 0.175,
                                          .bend = -0.03,
                                          .groove_depth = 0.024,
                                          .groove_turn = 20,
                                          .bumpiness = 0.006,
                                          .individual = 2}}}));
  all.push_back(family<3, HandOptions>(
      "hand", "a hand whose fingers turn rigidly about their bases", 0.0065, &hand_body,
      {{"rest", "stretched out", {}},
       {"bent",
        "fingers bent by 20 to 30 degrees",
        {.bend_thumb = 20, .bend_index = 25, .bend_middle = 30, .bend_ring = 25, .bend_little = 20}}}));
  all.push_back(
      family<3, DolphinOptions>("dolphin", "a dolphin that swims", 0.0065, &dolphin_body,
                                {{"straight", "at rest", {}},
                                 {"bent", "tail down by 45 degrees and a little aside", {.bend = 45, .sway = 12}},
                                 {"turned", "at rest, turned by 30 degrees", {.turn = 30}},
                                 {"reversed", "at rest, turned by 180 degrees", {.turn = 180}}}));
  all.push_back(family<3, RingOptions>(
      "ring", "a bar bent to a ring", 0.0085, &ring_body,
      {{"open", "with a gap", {}},
       {"clasped", "its ends press into each other: the surface crosses itself", {.arc = 330}}}));
  all.push_back(family<3, FaceOptions>(
      "face", "a head with nose, brows, eyes, mouth, chin and ears", 0.0085, &face_body,
      {{"neutral", "a head at rest", {}},
       {"smiling", "the same head, smiling", {.smile = 1}},
       {"other", "another head", {.nose = 1.3, .brow = 1.3, .jaw = 1.12, .width = 0.94, .ears = 1.15}}}));
  all.push_back(family<2, LeafOptions>("leaf", "a leaf with lobes and teeth", 0.004, &leaf_body,
                                       {{"deep", "deep bays", {}},
                                        {"shallow",
                                         "shallow bays, longer, bent and lopsided",
                                         {.depth = 0.36, .asymmetry = -0.05, .slenderness = 1.12, .bend = 15}}}));
  all.push_back(family<2, CircleOptions>("circle", "a circle", 0.004, &circle_body,
                                         {{"large", "radius 0.3", {}}, {"small", "radius 0.2", {.radius = 0.2}}}));
  all.push_back(family<2, EllipseOptions>(
      "ellipse", "an ellipse; corresponds to every circle", 0.004, &ellipse_body,
      {{"round", "a circle of radius 0.3", {.semi_x = 0.3, .semi_y = 0.3}}, {"long", "two different semi-axes", {}}}));
  all.push_back(family<2, StarOptions>(
      "star", "a star with rounded points", 0.004, &star_body,
      {{"mild", "five points", {}}, {"sharp", "deeper and turned", {.radius = 0.27, .depth = 0.42, .turn = 12}}}));
  all.push_back(family<2, BlobOptions>("blob", "a random smooth outline", 0.004, &blob_body,
                                       {{"first", "one outline", {}}, {"second", "another", {.individual = 2}}}));
  return all;
}

[[noreturn]] void throw_unknown(std::string_view what, std::string_view word, const std::vector<std::string>& known) {
  const std::string near = nearest_word(word, known);
  throw_input_error("{} '{}' is unknown{}; there are: {}", what, word,
                    near.empty() ? "" : fmt::format(", did you mean '{}'?", near), fmt::join(known, ", "));
}

}  // namespace

const std::vector<Family>& families() {
  static const std::vector<Family> all = make_families();
  return all;
}

const Family& find_family(std::string_view name) {
  std::vector<std::string> known;
  for (const Family& f : families()) {
    if (f.info.name == name) return f;
    known.push_back(f.info.name);
  }
  throw_unknown("shape", name, known);
}

GeneratorParameters complete_parameters(const GeneratorInfo& info, std::string_view variant,
                                        const GeneratorParameters& parameters) {
  const GeneratorVariant* found = variant.empty() ? &info.variants.front() : nullptr;
  std::vector<std::string> known;
  for (const GeneratorVariant& v : info.variants) {
    if (v.name == variant) found = &v;
    known.push_back(v.name);
  }
  if (!found) throw_unknown(info.name + ": variant", variant, known);
  GeneratorParameters complete = found->values;
  known.clear();
  for (const GeneratorParameter& p : info.parameters) known.push_back(p.name);
  for (const auto& [name, value] : parameters) {
    const auto place = complete.find(name);
    if (place == complete.end()) throw_unknown(info.name + ": parameter", name, known);
    place->second = value;
  }
  for (const GeneratorParameter& p : info.parameters) {
    const double value = complete.at(p.name);
    if (!in_range(value, p.info))
      throw_input_error("{}: {} = {:g} is out of range; give {}", info.name, p.name, value, range_text(p.info));
    if (p.whole_number && value != std::floor(value))
      throw_input_error("{}: {} = {:g} must be a whole number", info.name, p.name, value);
  }
  return complete;
}

}  // namespace shellmatch

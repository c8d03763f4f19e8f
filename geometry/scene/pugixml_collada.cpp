// COLLADA: "COLLADA - Digital Asset Schema Release 1.4.1", Khronos 2008, chapter 5 (geometry, scene), and 1.5.0. Read
// by pugixml and not by assimp, which gives each corner of a face a vertex of its own and crashes on some damaged
// files.
#include "base/printable.h"
#include "geometry/scene/pugixml_node.h"
#include "geometry/scene/scene_shape.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

namespace shellmatch {

namespace {

class ColladaReader {
 public:
  ColladaReader(const std::string& path, std::string_view bytes) : path_(path), shape_(path) {
    parse_xml(path, bytes, document_);
    root_ = child_of(document_, "COLLADA");
    if (!root_) throw_input_error("{}: no COLLADA file: its element <COLLADA> is missing", path);
    remember(root_, 0);
  }

  MeshFile read() && {
    const pugi::xml_node scene = child_of(child_of(root_, "scene"), "instance_visual_scene");
    if (scene) {
      add_children(target_of(scene), {}, 0);
    } else {
      shape_.note("without a scene: its meshes taken as they stand");
      for (const pugi::xml_node& library : children_of(root_, "library_geometries"))
        for (const pugi::xml_node& geometry : children_of(library, "geometry")) add_geometry(geometry, {});
    }
    return std::move(shape_).finish(frame());
  }

 private:
  // Elements are named by their attribute id.
  void remember(const pugi::xml_node& node, int depth) {
    if (depth > 2 * deepest_node)
      throw_input_error("{}: elements within elements more than {} deep; flatten the scene", path_, 2 * deepest_node);
    if (const std::string_view id = attribute_of(node, "id"); !id.empty()) by_id_.emplace(id, node);
    for (const pugi::xml_node& child : node.children())
      if (child.type() == pugi::node_element) remember(child, depth + 1);
  }

  pugi::xml_node find(std::string_view reference) const {
    if (!reference.starts_with('#'))
      throw_input_error("{}: refers to '{}', which is another file; export all into one file", path_,
                        printable(reference, 60));
    const auto found = by_id_.find(reference.substr(1));
    if (found == by_id_.end())
      throw_input_error("{}: refers to '{}', which is not in it; the file is damaged", path_, printable(reference, 60));
    return found->second;
  }
  pugi::xml_node target_of(const pugi::xml_node& instance) const { return find(attribute_of(instance, "url")); }

  SceneFrame frame() const {
    const pugi::xml_node asset = child_of(root_, "asset"), unit = child_of(asset, "unit");
    SceneFrame frame{1000, "metre", UpAxis::y};
    if (const std::string_view metres = attribute_of(unit, "meter"); !metres.empty()) {
      const std::optional<double> value = to_double(metres);
      if (!value || !(*value > 1e-12 && *value < 1e12))
        throw_input_error("{}: a unit of '{}' metres; give it a number above 0", path_, printable(metres, 30));
      // 0.001 metres are a millimetre: without the rounding error of the product.
      frame.millimetres = std::abs(*value * 1000 - 1) < 1e-12 ? 1 : *value * 1000;
      const std::string_view name = attribute_of(unit, "name");
      frame.unit = name.empty() ? fmt::format("{:g} metre", *value) : printable(name, 30);
    }
    const std::string_view up = child_of(asset, "up_axis").child_value();
    if (up.find('Z') != up.npos) frame.up = UpAxis::z;
    if (up.find('X') != up.npos) frame.up = UpAxis::x;
    return frame;
  }

  std::vector<double> numbers(const pugi::xml_node& node, std::size_t n) const {
    std::vector<double> values = numbers_in(path_, node.child_value(), fmt::format("<{}>", node.name()));
    if (values.size() != n)
      throw_input_error("{}: <{}> has {} numbers, but {} belong there", path_, node.name(), values.size(), n);
    return values;
  }

  Affine matrix(const pugi::xml_node& node) const {
    const std::vector<double> m = numbers(node, 16);
    Affine result;
    for (Eigen::Index i = 0; i < 3; ++i)
      for (Eigen::Index k = 0; k < 4; ++k)
        (k < 3 ? result.linear(i, k) : result.offset[i]) = m[static_cast<std::size_t>(4 * i + k)];
    return result;
  }

  // The product of a node's transformations in their order.
  Affine place_of(const pugi::xml_node& node) const {
    Affine place;
    for (const pugi::xml_node& child : node.children()) {
      const std::string_view name = local_name(child);
      Affine next;
      if (name == "matrix") next = matrix(child);
      else if (name == "translate") next.offset = vec(numbers(child, 3));
      else if (name == "scale") next.linear = vec(numbers(child, 3)).asDiagonal();
      else if (name == "rotate") next.linear = rotation(numbers(child, 4));
      else if (name == "lookat" || name == "skew")
        throw_input_error("{}: a mesh is placed by <{}>; export it with <matrix>", path_, name);
      else continue;
      place = place * next;
    }
    return place;
  }
  static Vec<3> vec(const std::vector<double>& v) { return {v[0], v[1], v[2]}; }
  static Mat<3> rotation(const std::vector<double>& v) {
    const Vec<3> axis = vec(v);
    if (!(axis.norm() > 0)) return Mat<3>::Identity();
    return Eigen::AngleAxisd(v[3] * std::numbers::pi / 180, axis.normalized()).toRotationMatrix();
  }

  void add_children(const pugi::xml_node& parent, const Affine& place, int depth) {
    if (depth > deepest_node)
      throw_input_error("{}: nodes within nodes more than {} deep; flatten the scene", path_, deepest_node);
    for (const pugi::xml_node& child : parent.children()) {
      const std::string_view name = local_name(child);
      if (name == "node") add_children(child, place * place_of(child), depth + 1);
      else if (name == "instance_node") add_instance(target_of(child), place, depth + 1);
      else if (name == "instance_geometry") add_geometry(target_of(child), place);
      else if (name == "instance_controller") add_skin(target_of(child), place, depth + 1);
    }
  }
  void add_instance(const pugi::xml_node& node, const Affine& place, int depth) {
    // Instances of instances grow as powers, also where none of them has a mesh.
    if (++n_instances_ > 100000)
      throw_input_error("{}: more than 100000 instances of nodes; export a part of the scene", path_);
    add_children(node, place * place_of(node), depth);
  }
  void add_skin(const pugi::xml_node& controller, const Affine& place, int depth) {
    if (depth > deepest_node)
      throw_input_error("{}: controllers of controllers more than {} deep", path_, deepest_node);
    const pugi::xml_node skin = child_of(controller, "skin"), part = skin ? skin : child_of(controller, "morph");
    const pugi::xml_node source = find(attribute_of(part, "source")), bind = child_of(part, "bind_shape_matrix");
    shape_.note("taken in the pose of its mesh: that of its bones is not applied");
    const Affine inner = bind ? place * matrix(bind) : place;
    if (local_name(source) == "controller") add_skin(source, inner, depth + 1);
    else add_geometry(source, inner);
  }

  void add_geometry(const pugi::xml_node& geometry, const Affine& place) {
    const pugi::xml_node mesh = child_of(geometry, "mesh");
    if (!mesh) return;
    std::vector<std::vector<Index>> polygons;
    std::string_view positions;
    for (const pugi::xml_node& part : mesh.children()) add_primitive(part, positions, polygons);
    if (!positions.empty()) shape_.add(place, vertices_of(find(positions)), polygons);
  }

  // <vertices> names the source of positions.
  std::vector<Vec<3>> vertices_of(const pugi::xml_node& vertices) const {
    for (const pugi::xml_node& input : children_of(vertices, "input"))
      if (attribute_of(input, "semantic") == "POSITION") return positions_of(find(attribute_of(input, "source")));
    throw_input_error("{}: vertices without positions; the file is damaged", path_);
  }
  std::vector<Vec<3>> positions_of(const pugi::xml_node& source) const {
    const pugi::xml_node accessor = child_of(child_of(source, "technique_common"), "accessor");
    const std::vector<double> values =
        numbers_in(path_, child_of(source, "float_array").child_value(), "the positions of a mesh");
    const auto count_of = [&](std::string_view name, std::int64_t otherwise) {
      return static_cast<std::size_t>(
          std::max<std::int64_t>(0, to_integer(attribute_of(accessor, name)).value_or(otherwise)));
    };
    const std::size_t stride = count_of("stride", 3), offset = count_of("offset", 0);
    const std::size_t n = count_of("count", static_cast<std::int64_t>(values.size() / 3));
    if (stride < 3 || offset > values.size() || n > (values.size() - offset) / stride)
      throw_input_error("{}: {} positions are declared, which are not there; the file is damaged or was cut off", path_,
                        n);
    std::vector<Vec<3>> positions;
    for (std::size_t i = 0; i < n; ++i)
      positions.emplace_back(values[offset + i * stride], values[offset + i * stride + 1],
                             values[offset + i * stride + 2]);
    return positions;
  }

  void add_primitive(const pugi::xml_node& part, std::string_view& positions,
                     std::vector<std::vector<Index>>& polygons) const {
    const std::string_view kind = local_name(part);
    if (kind != "triangles" && kind != "polylist" && kind != "polygons" && kind != "tristrips" && kind != "trifans")
      return;
    std::size_t stride = 0, offset = 0;
    for (const pugi::xml_node& input : children_of(part, "input")) {
      const auto place = static_cast<std::size_t>(
          std::clamp<std::int64_t>(to_integer(attribute_of(input, "offset")).value_or(0), 0, 1000));
      stride = std::max(stride, place + 1);
      if (attribute_of(input, "semantic") != "VERTEX") continue;
      offset = place;
      positions = attribute_of(input, "source");
    }
    if (stride == 0 || positions.empty())
      throw_input_error("{}: <{}> names no vertices; the file is damaged", path_, kind);
    std::vector<pugi::xml_node> lists = children_of(part, "p");
    for (const pugi::xml_node& with_hole : children_of(part, "ph"))
      if (with_hole) throw_input_error("{}: a polygon with holes; triangulate the mesh before export", path_);
    std::vector<Index> sizes;
    if (kind == "polylist") sizes = indices_in(path_, child_of(part, "vcount").child_value(), "<vcount>");
    for (const pugi::xml_node& list : lists) {
      const std::vector<Index> all = indices_in(path_, list.child_value(), "<p>");
      if (all.size() % stride != 0)
        throw_input_error("{}: <p> of <{}> ends within a corner; the file is damaged or was cut off", path_, kind);
      std::vector<Index> corners;
      for (std::size_t i = offset; i < all.size(); i += stride) corners.push_back(all[i]);
      add_faces(kind, corners, sizes, polygons);
    }
  }

  void add_faces(std::string_view kind, const std::vector<Index>& c, const std::vector<Index>& sizes,
                 std::vector<std::vector<Index>>& polygons) const {
    if (kind == "polygons") polygons.push_back(c);
    if (kind == "triangles") {
      if (c.size() % 3 != 0)
        throw_input_error("{}: <triangles> have {} corners; the file is damaged or was cut off", path_, c.size());
      for (std::size_t i = 0; i < c.size(); i += 3) polygons.push_back({c[i], c[i + 1], c[i + 2]});
    }
    if (kind == "polylist") {
      std::size_t at = 0;
      for (const Index n : sizes) {
        if (static_cast<std::size_t>(n) > c.size() - at)
          throw_input_error(
              "{}: <polylist> has fewer corners than <vcount> declares; the file is damaged or was cut off", path_);
        polygons.emplace_back(c.begin() + static_cast<std::ptrdiff_t>(at),
                              c.begin() + static_cast<std::ptrdiff_t>(at) + n);
        at += static_cast<std::size_t>(n);
      }
      if (at != c.size())
        throw_input_error("{}: <polylist> has {} corners, but <vcount> declares {}", path_, c.size(), at);
    }
    for (std::size_t i = 2; i < c.size() && kind == "trifans"; ++i) polygons.push_back({c[0], c[i - 1], c[i]});
    for (std::size_t i = 2; i < c.size() && kind == "tristrips"; ++i)
      polygons.push_back(i % 2 == 0 ? std::vector{c[i - 2], c[i - 1], c[i]} : std::vector{c[i - 1], c[i - 2], c[i]});
  }

  const std::string& path_;
  pugi::xml_document document_;
  pugi::xml_node root_;
  std::map<std::string_view, pugi::xml_node> by_id_;
  std::size_t n_instances_ = 0;
  SceneShape shape_;
};

}  // namespace

MeshFile read_collada(const std::string& path, std::string_view bytes) { return ColladaReader(path, bytes).read(); }

}  // namespace shellmatch

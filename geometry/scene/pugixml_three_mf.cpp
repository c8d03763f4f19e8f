// 3D Manufacturing Format: "3MF Core Specification" 1.3, chapters 3 and 4, and "3MF Production Extension" 1.1 (parts in
// files of their own). Read by pugixml and not by assimp, which ends the program on a damaged archive, nor by Debian's
// lib3mf, whose headers lack its present interface.
#include "base/printable.h"
#include "geometry/scene/pugixml_node.h"
#include "geometry/scene/scene_shape.h"
#include "geometry/scene/zip_file.h"

#include <map>
#include <memory>
#include <utility>

namespace shellmatch {

namespace {

// A part of the archive with objects.
struct ModelPart {
  pugi::xml_document document;
  pugi::xml_node model;
  std::map<std::string_view, pugi::xml_node> objects;
};

class ThreeMfReader {
 public:
  ThreeMfReader(const std::string& path, std::string_view bytes) : path_(path), archive_(path, bytes), shape_(path) {}

  MeshFile read() && {
    const std::string name = root_name();
    const ModelPart& root = part(name);
    for (const pugi::xml_node& item : children_of(child_of(root.model, "build"), "item")) add_object(item, name, {}, 0);
    if (n_supports_ > 0) shape_.note(counted(n_supports_, "support structure", "support structures") + " left out");
    return std::move(shape_).finish(frame(root.model));
  }

 private:
  std::string root_name() const {
    const std::optional<std::string> relations = archive_.part("_rels/.rels");
    if (!relations) throw_input_error("{}: no 3MF file: its part _rels/.rels is missing", path_);
    pugi::xml_document document;
    parse_xml(path_, *relations, document);
    for (const pugi::xml_node& relation : children_of(child_of(document, "Relationships"), "Relationship"))
      if (attribute_of(relation, "Type").ends_with("/3dmodel")) return std::string(attribute_of(relation, "Target"));
    throw_input_error("{}: no 3MF file: it names no model", path_);
  }

  const ModelPart& part(const std::string& name) {
    std::unique_ptr<ModelPart>& known = parts_[name];
    if (known) return *known;
    known = std::make_unique<ModelPart>();
    const std::optional<std::string> bytes =
        archive_.part(name.starts_with('/') ? std::string_view(name).substr(1) : name);
    if (!bytes) throw_input_error("{}: its part '{}' is missing; the file is damaged", path_, printable(name, 60));
    parse_xml(path_, *bytes, known->document);
    known->model = child_of(known->document, "model");
    if (!known->model) throw_input_error("{}: its part '{}' holds no model", path_, printable(name, 60));
    for (const pugi::xml_node& object : children_of(child_of(known->model, "resources"), "object"))
      known->objects.emplace(attribute_of(object, "id"), object);
    return *known;
  }

  SceneFrame frame(const pugi::xml_node& model) const {
    constexpr std::pair<std::string_view, double> units[] = {{"micron", 0.001}, {"millimeter", 1}, {"centimeter", 10},
                                                             {"inch", 25.4},    {"foot", 304.8},   {"meter", 1000}};
    const std::string_view name = attribute_of(model, "unit");
    if (name.empty()) return {};
    for (const auto& [unit, millimetres] : units)
      if (unit == name) return {millimetres, std::string(name), UpAxis::z};
    throw_input_error("{}: the unit '{}' is unknown; micron, millimeter, centimeter, inch, foot and meter are known",
                      path_, printable(name, 30));
  }

  // Twelve numbers, row by row, for points as rows: x' = x M.
  Affine transform_of(const pugi::xml_node& node) const {
    Affine place;
    const std::string_view text = attribute_of(node, "transform");
    if (text.empty()) return place;
    const std::vector<double> m = numbers_in(path_, text, "a transform");
    if (m.size() != 12) throw_input_error("{}: a transform has {} numbers, but 12 belong there", path_, m.size());
    for (Eigen::Index i = 0; i < 3; ++i) {
      for (Eigen::Index k = 0; k < 3; ++k) place.linear(k, i) = m[static_cast<std::size_t>(3 * i + k)];
      place.offset[i] = m[static_cast<std::size_t>(9 + i)];
    }
    return place;
  }

  // The object that an item of the build or a component names.
  void add_object(const pugi::xml_node& reference, const std::string& own_part, const Affine& parent, int depth) {
    if (depth > deepest_node || ++n_references_ > 1000000)
      throw_input_error("{}: components within components without end; the file is damaged", path_);
    const std::string_view other = attribute_of(reference, "path"), id = attribute_of(reference, "objectid");
    const std::string name = other.empty() ? own_part : std::string(other);
    const ModelPart& there = part(name);
    const auto found = there.objects.find(id);
    if (found == there.objects.end())
      throw_input_error("{}: refers to object '{}', which is not in it; the file is damaged", path_, printable(id, 30));
    const pugi::xml_node object = found->second;
    if (const std::string_view type = attribute_of(object, "type"); type == "support" || type == "solidsupport") {
      ++n_supports_;
      return;
    }
    const Affine place = parent * transform_of(reference);
    if (const pugi::xml_node mesh = child_of(object, "mesh")) add_mesh(mesh, place);
    for (const pugi::xml_node& component : children_of(child_of(object, "components"), "component"))
      add_object(component, name, place, depth + 1);
  }

  void add_mesh(const pugi::xml_node& mesh, const Affine& place) {
    std::vector<Vec<3>> vertices;
    std::vector<std::vector<Index>> polygons;
    for (const pugi::xml_node& vertex : child_of(mesh, "vertices").children()) {
      Vec<3> x;
      for (int k = 0; k < 3; ++k)
        x[k] = number(attribute_of(vertex, std::string_view("xyz").substr(static_cast<std::size_t>(k), 1)), "a vertex",
                      vertices.size());
      vertices.push_back(x);
    }
    for (const pugi::xml_node& triangle : child_of(mesh, "triangles").children()) {
      std::vector<Index> corners;
      for (const std::string_view corner : {"v1", "v2", "v3"}) {
        const std::optional<std::int64_t> v = to_integer(attribute_of(triangle, corner));
        // What is no index of a vertex is refused where the mesh is added.
        corners.push_back(v && *v >= 0 && *v < static_cast<std::int64_t>(vertices.size()) ? static_cast<Index>(*v)
                                                                                          : no_index);
      }
      polygons.push_back(std::move(corners));
    }
    shape_.add(place, vertices, polygons);
  }

  double number(std::string_view text, std::string_view what, std::size_t i) const {
    const std::optional<double> value = to_double(text);
    if (!value)
      throw_input_error("{}: '{}' is no coordinate of {} ({}, counted from 0)", path_, printable(text, 30), what, i);
    return *value;
  }

  const std::string& path_;
  ZipFile archive_;
  std::map<std::string, std::unique_ptr<ModelPart>> parts_;
  std::size_t n_supports_ = 0, n_references_ = 0;
  SceneShape shape_;
};

}  // namespace

MeshFile read_three_mf(const std::string& path, std::string_view bytes) { return ThreeMfReader(path, bytes).read(); }

}  // namespace shellmatch

// SVG: what its elements enclose, each in its place. Styles are not looked at but for what they hide and how they fill.

#include "base/error.h"
#include "base/printable.h"
#include "base/text.h"
#include "geometry/outline/drawing.h"
#include "geometry/outline/svg_text.h"
#include "geometry/scene/pugixml_node.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <utility>

namespace shellmatch {

namespace {

// A property as an attribute or in the style, which goes first.
std::string_view property_of(const pugi::xml_node& node, std::string_view name) {
  std::string_view style = attribute_of(node, "style"), found = attribute_of(node, name);
  constexpr std::string_view blanks = " \t\r\n";
  const auto trimmed = [&](std::string_view text) {
    text.remove_prefix(std::min(text.find_first_not_of(blanks), text.size()));
    return text.substr(0, text.find_last_not_of(blanks) + 1);
  };
  while (!style.empty()) {
    const std::string_view entry = style.substr(0, style.find(';'));
    style.remove_prefix(std::min(entry.size() + 1, style.size()));
    const std::size_t colon = entry.find(':');
    if (colon != entry.npos && trimmed(entry.substr(0, colon)) == name) found = trimmed(entry.substr(colon + 1));
  }
  return found.substr(0, found.find_first_of(" !"));
}

// Where an element stands: its coordinates in those of the drawing, what is around it, and what it inherits.
struct Surroundings {
  PlaneMap place;
  std::size_t group = no_group;
  bool is_filled_by_turns = true;
  Vec<2> whole = Vec<2>::Constant(100);  // of which percentages are
  int depth = 0;
};

class SvgReader {
 public:
  SvgReader(const std::string& path, std::string_view bytes) : path_(path) {
    pugi::xml_document document;
    parse_xml(path, bytes, document);
    const pugi::xml_node root = child_of(document, "svg");
    if (!root) throw_input_error("{}: no SVG file: its element <svg> is missing", path);
    drawing_.is_downward = true;
    place_ = path_ + ": <svg>";
    Surroundings around;
    around.whole = set_unit(root);
    for (const pugi::xml_node& child : root.children()) read(child, around);
    if (!left_out_.empty()) drawing_.notes.push_back(fmt::format("left out: {}", fmt::join(left_out_, ", ")));
  }

  Drawing take() { return std::move(drawing_); }

 private:
  double length(const pugi::xml_node& node, std::string_view name, double whole, double absent = 0) const {
    const std::string_view text = attribute_of(node, name);
    return text.empty() || text == "auto" ? absent : svg_length({text, place_}, whole).user_units;
  }

  // x, y, width and height of a viewBox, if there is one that is no line.
  std::optional<std::array<double, 4>> view_box(const pugi::xml_node& node) const {
    const std::string_view text = attribute_of(node, "viewBox");
    if (text.empty()) return {};
    const SvgText source{text, place_};
    SvgNumbers numbers(source);
    std::array<double, 4> box;
    for (double& x : box) x = numbers.next();
    return box[2] > 0 && box[3] > 0 ? std::optional(box) : std::nullopt;
  }

  // Millimetres where width or height name a length; returns what 100 % are.
  Vec<2> set_unit(const pugi::xml_node& root) {
    const auto box = view_box(root);
    Vec<2> whole = box ? Vec<2>((*box)[2], (*box)[3]) : Vec<2>(Vec<2>::Constant(100));
    double scale = 0;
    for (const int k : {0, 1}) {
      const std::string_view text = attribute_of(root, k == 0 ? "width" : "height");
      if (text.empty() || text == "auto") continue;
      const SvgLength size = svg_length({text, place_}, whole[k]);
      if (!box && size.user_units > 0) whole[k] = size.user_units;
      if (!(size.millimetres > 0)) continue;
      const double own = box ? size.millimetres / whole[k] : millimetres_per_user_unit;
      scale = scale > 0 ? std::min(scale, own) : own;
    }
    if (std::isfinite(scale) && scale > 0) {
      drawing_.scale = scale;
      drawing_.unit = "mm";
      drawing_.notes.push_back(
          fmt::format("in millimetres: a unit of the drawing has {:.6g}, by its width and height", scale));
    } else {
      drawing_.notes.push_back(
          "coordinates are units of the drawing: its width and height are no lengths such as 210mm");
    }
    return whole;
  }

  // An <svg> within: its view box fits into its rectangle, in the middle of it.
  PlaneMap viewport(const pugi::xml_node& node, const Vec<2>& whole, Vec<2>& inner) const {
    const Vec<2> corner(length(node, "x", whole.x()), length(node, "y", whole.y()));
    const Vec<2> size(length(node, "width", whole.x(), whole.x()), length(node, "height", whole.y(), whole.y()));
    PlaneMap map{Mat<2>::Identity(), corner};
    inner = size;
    const auto box = view_box(node);
    if (!box) return map;
    const Vec<2> begin((*box)[0], (*box)[1]);
    inner = {(*box)[2], (*box)[3]};
    const double scale = size.cwiseQuotient(inner).minCoeff();
    map.linear *= scale;
    map.offset = corner + (size - scale * inner) / 2 - scale * begin;
    return map;
  }

  void read(const pugi::xml_node& node, Surroundings around) {
    if (node.type() != pugi::node_element) return;
    const std::string_view name = local_name(node);
    const bool is_nested = name == "svg", is_group = is_nested || name == "g" || name == "a" || name == "switch";
    const bool is_shape = name == "path" || name == "polygon" || name == "polyline" || name == "rect" ||
                          name == "circle" || name == "ellipse";
    if (!is_group && !is_shape) {
      for (const std::string_view what : {"use", "text", "image", "foreignObject", "line"})
        if (name == what) left_out_.insert(what);
      return;
    }
    if (property_of(node, "display") == "none" || property_of(node, "visibility") == "hidden") return;
    const std::string_view id = attribute_of(node, "id"), label = attribute_of(node, "label");
    place_ = fmt::format("{}: <{}>{}", path_, name, id.empty() ? "" : fmt::format(" '{}'", printable(id, 60)));
    if (const std::string_view text = attribute_of(node, "transform"); !text.empty())
      around.place = around.place * svg_transform({text, place_});
    if (const std::string_view rule = property_of(node, "fill-rule"); !rule.empty() && rule != "inherit")
      around.is_filled_by_turns = rule != "evenodd";
    std::vector<std::string> names;
    for (const std::string_view own : {id, label})
      if (!own.empty()) names.emplace_back(own);
    if (is_shape) return add(names, paths_of(node, name, around.whole), around);
    if (++around.depth > deepest_group)
      throw_input_error("{}: groups are nested more than {} deep; ungroup them", path_, deepest_group);
    if (is_nested) {
      Vec<2> inner;
      around.place = around.place * viewport(node, around.whole, inner);
      around.whole = inner;
    }
    if (!names.empty()) {
      drawing_.groups.push_back({std::move(names), around.group});
      around.group = drawing_.groups.size() - 1;
    }
    for (const pugi::xml_node& child : node.children()) read(child, around);
  }

  std::vector<DrawnPath> paths_of(const pugi::xml_node& node, std::string_view name, const Vec<2>& whole) const {
    if (name == "path") return svg_paths({attribute_of(node, "d"), place_});
    if (name == "polygon" || name == "polyline") {
      const std::vector<Vec<2>> points = svg_points({attribute_of(node, "points"), place_});
      return points.empty() ? std::vector<DrawnPath>() : std::vector{path_through(points, name == "polygon")};
    }
    const auto along = [&](std::string_view attribute, int axis, double absent = 0) {
      return length(node, attribute, whole[axis], absent);
    };
    if (name == "rect") {
      const Vec<2> size(along("width", 0), along("height", 1));
      if (!(size.minCoeff() > 0)) return {};
      const double rx = along("rx", 0, -1), ry = along("ry", 1, -1);
      const Vec<2> radii(rx < 0 ? std::max(0.0, ry) : rx, ry < 0 ? std::max(0.0, rx) : ry);
      return {rectangle_path({along("x", 0), along("y", 1)}, size,
                             radii.minCoeff() > 0 ? Vec<2>(radii.cwiseMin(size / 2)) : Vec<2>(Vec<2>::Zero()))};
    }
    const double diagonal = whole.norm() / std::sqrt(2.0);
    const double r = length(node, "r", diagonal), rx = name == "circle" ? r : along("rx", 0, along("ry", 1)),
                 ry = name == "circle" ? r : along("ry", 1, rx);
    if (!(rx > 0) || !(ry > 0)) return {};
    return {ellipse_path({along("cx", 0), along("cy", 1)}, {rx, 0}, {0, ry})};
  }

  void add(std::vector<std::string> names, std::vector<DrawnPath> paths, const Surroundings& around) {
    if (paths.empty()) return;
    for (DrawnPath& path : paths) path.move(around.place);
    drawing_.areas.push_back({std::move(names), around.group, std::move(paths), around.is_filled_by_turns});
  }

  const std::string& path_;
  std::string place_;
  Drawing drawing_;
  std::set<std::string_view> left_out_;
};

}  // namespace

Drawing read_svg(const std::string& path, std::string_view bytes) { return SvgReader(path, bytes).take(); }

}  // namespace shellmatch

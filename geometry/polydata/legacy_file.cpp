// VTK's legacy format: a head of three or four lines, then sections that begin with a word.

#include "geometry/polydata/legacy_scanner.h"
#include "geometry/polydata/polydata.h"

#include "base/printable.h"
#include "base/text.h"

#include <algorithm>
#include <map>
#include <utility>

namespace shellmatch {

namespace {

/// Lists of cells as the file has them.
struct LegacyCells {
  std::vector<double> ends, corners;
};

class LegacyFile {
 public:
  LegacyFile(const std::string& path, std::string_view bytes) : path_(path), in_(path, bytes), data_(path) {}

  OriginalShape<3> read(std::vector<std::string>& notes) {
    read_head();
    while (read_section()) {
    }
    if (!has_points_) throw_input_error("{}: no points in it", path_);
    for (const auto& [kind, cells] : cells_) data_.add_cells(kind, cells.ends, cells.corners, 0);
    add_grid_cells();
    return data_.finish(notes);
  }

 private:
  void read_head() {
    std::string_view first = in_.line();
    if (first.starts_with("\xEF\xBB\xBF")) first.remove_prefix(3);
    if (!first.starts_with("# vtk DataFile Version"))
      throw_input_error("{}: a VTK file starts with '# vtk DataFile Version'", path_);
    data_.shape().space = space_in_comment(in_.line());
    const bool is_text = in_.take("ascii");
    if (!is_text && !in_.take("binary")) in_.fail("the third line should be ASCII or BINARY");
    if (!in_.take("dataset")) in_.fail("DATASET should stand here");
    if (in_.take("unstructured_grid")) is_grid_ = true;
    else if (!in_.take("polydata"))
      in_.fail("the file holds a {}; a surface is POLYDATA, or an UNSTRUCTURED_GRID of polygons",
               printable(in_.word(), 40));
    in_.set_binary(!is_text);
  }

  // False at the end of the file.
  bool read_section() {
    for (const auto& [name, kind] : {std::pair{"vertices", CellKind::vertices},
                                     {"lines", CellKind::lines},
                                     {"polygons", CellKind::polygons},
                                     {"triangle_strips", CellKind::strips}}) {
      if (!in_.take(name)) continue;
      if (is_grid_ || cells_.contains(kind)) in_.fail("the cells are there already, or belong to another kind of data");
      cells_[kind] = read_cells();
      return true;
    }
    if (in_.take("points")) read_points();
    else if (is_grid_ && in_.take("cells")) grid_cells_ = read_cells();
    else if (is_grid_ && in_.take("cell_types")) {
      const std::size_t n = in_.count("the number of types");
      grid_types_ = in_.values(ValueType::int32, n, "types of cells");
    } else if (in_.take("point_data")) begin_data(true);
    else if (in_.take("cell_data")) begin_data(false);
    else if (in_.take("metadata")) skip_metadata();
    else if (in_.take("field")) read_field();
    else if (has_data_ && read_attribute()) return true;
    else {
      const std::string_view word = in_.word();
      if (!word.empty()) in_.fail("unknown word '{}'", printable(word, 40));
      return false;
    }
    return true;
  }

  void read_points() {
    if (std::exchange(has_points_, true)) in_.fail("a second list of points");
    const std::size_t n = in_.count("the number of points");
    const ValueType type = in_.type();
    if (n > static_cast<std::size_t>(std::numeric_limits<Index>::max()))
      in_.fail("{} points are more than a file holds", n);
    data_.add_points(in_.values(type, 3 * n, "coordinates"));
  }

  // Before version 5 each cell is its number of corners and the corners; from 5 on there are two arrays.
  LegacyCells read_cells() {
    const std::size_t a = in_.count("the number of cells"), b = in_.count("the size of the list");
    LegacyCells cells;
    if (in_.take("offsets")) {
      const ValueType type = in_.type();
      cells.ends = in_.values(type, a, "ends of cells");
      if (!in_.take("connectivity")) in_.fail("CONNECTIVITY should stand here");
      const ValueType corner_type = in_.type();
      cells.corners = in_.values(corner_type, b, "corners");
      if (!cells.ends.empty()) {
        if (cells.ends.front() != 0) in_.fail("the first cell does not begin at 0");
        cells.ends.erase(cells.ends.begin());
      }
      return cells;
    }
    const std::vector<double> list = in_.values(ValueType::int32, b, "numbers of cells");
    std::size_t next = 0;
    for (std::size_t i = 0; i < a; ++i) {
      const double n = next < list.size() ? list[next] : -1;
      if (!(n >= 0 && n <= static_cast<double>(list.size() - next - 1)))
        in_.fail("cell {} has {} corners, beyond the {} numbers of the list", i, n, list.size());
      cells.corners.insert(cells.corners.end(), list.begin() + static_cast<std::ptrdiff_t>(next + 1),
                           list.begin() + static_cast<std::ptrdiff_t>(next + 1 + static_cast<std::size_t>(n)));
      next += 1 + static_cast<std::size_t>(n);
      cells.ends.push_back(static_cast<double>(cells.corners.size()));
    }
    if (next != list.size()) in_.fail("the cells take {} of the {} numbers of their list", next, list.size());
    return cells;
  }

  // The types of cells of an unstructured grid that make a surface, in VTK's numbers.
  void add_grid_cells() {
    if (grid_types_.size() != grid_cells_.ends.size())
      throw_input_error("{}: {} cells, but {} types of cells", path_, grid_cells_.ends.size(), grid_types_.size());
    std::size_t begin = 0;
    for (std::size_t i = 0; i < grid_types_.size(); ++i) {
      const int type = grid_types_[i] >= 0 && grid_types_[i] < 100 ? static_cast<int>(grid_types_[i]) : -1;
      CellKind kind = CellKind::polygons;
      if (type <= 2 && type >= 0) kind = CellKind::vertices;
      else if (type == 3 || type == 4) kind = CellKind::lines;
      else if (type == 6) kind = CellKind::strips;
      else if (type != 5 && type != 7 && type != 8 && type != 9)
        throw_input_error(
            "{}: cell {} is of VTK's type {}, which is no polygon; extract the surface of the grid first (in ParaView: "
            "Extract Surface)",
            path_, i, grid_types_[i]);
      const double end = grid_cells_.ends[i];
      if (!(end >= static_cast<double>(begin) && end <= static_cast<double>(grid_cells_.corners.size())))
        throw_input_error("{}: cell {} ends at {} of {} corners; the file is damaged or was cut off", path_, i, end,
                          grid_cells_.corners.size());
      std::vector<double> corners(grid_cells_.corners.begin() + static_cast<std::ptrdiff_t>(begin),
                                  grid_cells_.corners.begin() + static_cast<std::ptrdiff_t>(end));
      if (type == 8 && corners.size() == 4) std::swap(corners[2], corners[3]);  // a pixel goes to and fro
      begin = static_cast<std::size_t>(end);
      data_.add_cells(kind, {static_cast<double>(corners.size())}, corners, 0);
    }
  }

  void begin_data(bool of_points) {
    n_tuples_ = in_.count("the number of tuples");
    is_point_data_ = of_points;
    has_data_ = true;
    if (of_points && !has_points_) in_.fail("POINT_DATA comes before the points");
    if (of_points && n_tuples_ != data_.n_points())
      in_.fail("POINT_DATA of {} points, but there are {}", n_tuples_, data_.n_points());
  }

  // Values of point data become columns, those of cells and of the whole are left out.
  void take_values(const std::string& name, ValueType type, std::size_t n_components, std::size_t n_tuples,
                   bool is_column) {
    if (n_components == 0 || n_components > max_columns)
      in_.fail("'{}' has {} components; up to {} can be used", printable(name), n_components, max_columns);
    if (n_tuples > std::numeric_limits<std::size_t>::max() / max_columns / 8)
      in_.fail("'{}' has {} tuples", printable(name), n_tuples);
    const std::vector<double> values = in_.values(type, n_tuples * n_components, "values");
    if (is_column) data_.add_point_array(name, column_type(type), n_components, values);
    else if (has_data_ && !is_point_data_ && !std::exchange(has_cell_data_, true))
      data_.add_dropped("cell data dropped");
  }

  bool read_attribute() {
    const auto simple = [&](std::string_view word, std::size_t n_components) {
      if (!in_.take(word)) return false;
      const std::string name = in_.name();
      const ValueType type = in_.type();
      take_values(word == "normals" ? "Normals" : name, type, n_components, n_tuples_, is_point_data_);
      return true;
    };
    for (const auto& [word, n] : {std::pair<std::string_view, std::size_t>{"vectors", 3},
                                  {"normals", 3},
                                  {"tensors", 9},
                                  {"tensors6", 6},
                                  {"global_ids", 1},
                                  {"pedigree_ids", 1},
                                  {"edge_flags", 1}})
      if (simple(word, n)) return true;
    if (in_.take("scalars")) {
      const std::string name = in_.name();
      const ValueType type = in_.type();
      std::size_t n_components = 1;
      if (!in_.take("lookup_table")) {
        n_components = in_.count("the number of components");
        if (!in_.take("lookup_table")) in_.fail("LOOKUP_TABLE should stand here");
      }
      in_.word();
      take_values(name, type, n_components, n_tuples_, is_point_data_);
    } else if (in_.take("color_scalars")) {
      const std::string name = in_.name();
      const std::size_t n = in_.count("the number of values");
      take_values(name, in_.is_binary() ? ValueType::uint8 : ValueType::float32, n, n_tuples_, is_point_data_);
    } else if (in_.take("lookup_table")) {
      in_.word();
      const std::size_t n = in_.count("the size of the table");
      take_values("", in_.is_binary() ? ValueType::uint8 : ValueType::float32, 4, n, false);
    } else if (in_.take("texture_coordinates")) {
      const std::string name = in_.name();
      const std::size_t n = in_.count("the dimension");
      const ValueType type = in_.type();
      take_values(name, type, n, n_tuples_, is_point_data_);
    } else {
      return false;
    }
    return true;
  }

  void read_field() {
    in_.word();
    const std::size_t n_arrays = in_.count("the number of arrays");
    for (std::size_t i = 0; i < n_arrays; ++i) {
      while (in_.take("metadata")) skip_metadata();
      const std::string name = in_.name();
      if (name == "NULL_ARRAY") continue;
      if (name.empty()) in_.fail("cut off: {} of {} arrays are there", i, n_arrays);
      const std::size_t n_components = in_.count("the number of components"),
                        n_tuples = in_.count("the number of tuples");
      const bool is_column = has_data_ && is_point_data_;
      if (is_column && n_tuples != n_tuples_)
        in_.fail("'{}' has {} tuples, but there are {} points", printable(name), n_tuples, n_tuples_);
      if (in_.take("string")) {
        if (n_components != 0 && n_tuples > std::numeric_limits<std::size_t>::max() / n_components)
          in_.fail("'{}' has {} tuples", printable(name), n_tuples);
        in_.skip_strings(n_components * n_tuples);
        if (is_column) data_.add_dropped(fmt::format("point data '{}' dropped: texts are not kept", printable(name)));
        continue;
      }
      const ValueType type = in_.type();
      take_values(name, type, n_components, n_tuples, is_column);
    }
  }

  // Up to a blank line.
  void skip_metadata() {
    in_.line();
    while (!in_.line().empty()) {
    }
  }

  const std::string& path_;
  LegacyScanner in_;
  PolyData data_;
  std::map<CellKind, LegacyCells> cells_;
  LegacyCells grid_cells_;
  std::vector<double> grid_types_;
  std::size_t n_tuples_ = 0;
  bool is_grid_ = false, has_points_ = false, has_data_ = false, is_point_data_ = false, has_cell_data_ = false;
};

}  // namespace

OriginalShape<3> read_legacy_vtk(const std::string& path, std::string_view bytes, std::vector<std::string>& notes) {
  return LegacyFile(path, bytes).read(notes);
}

}  // namespace shellmatch

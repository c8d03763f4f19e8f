// VTK's XML format of polygonal data: pieces, each with points, cells and their arrays.

#include "geometry/polydata/polydata.h"
#include "geometry/vtk_xml/xml_file.h"

#include "base/error.h"
#include "base/printable.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace shellmatch {

namespace {

constexpr XmlExpectation polygonal{"PolyData", "VTK file of polygonal data",
                                   "a surface is of type PolyData (in ParaView: Extract Surface, save as .vtp)"};

class VtpFile {
 public:
  VtpFile(const std::string& path, std::string_view bytes) : path_(path), file_(path, bytes, polygonal) {}

  OriginalShape<3> read(std::vector<std::string>& notes) {
    PolyData data(path_);
    for (const XmlPiece& piece : file_.pieces()) add_piece(piece, data);
    if (data.n_points() == 0) throw_input_error("{}: no points in it", path_);
    add_notes(notes);
    add_point_data(data);
    data.shape().space = file_.space();
    return data.finish(notes);
  }

 private:
  std::size_t n_points(const XmlPiece& piece) const { return file_.number(piece.tag, "NumberOfPoints", 0); }

  const XmlArray& array_in(const XmlPiece& piece, std::string_view section, std::string_view name) const {
    const XmlArray* array = VtkXmlFile::find(piece, section, name);
    if (array == nullptr) file_.damaged(fmt::format("{} has no array {}", section, name));
    return *array;
  }

  void add_piece(const XmlPiece& piece, PolyData& data) const {
    const std::size_t first = data.n_points(), n = n_points(piece);
    if (n > 0) {
      const XmlArray& points = array_in(piece, "Points", "");
      if (points.n_components != 3) file_.damaged("points have three components");
      data.add_points(file_.values(points, 3 * n));
    }
    for (const auto& [section, kind] : {std::pair{"Verts", CellKind::vertices},
                                        {"Lines", CellKind::lines},
                                        {"Polys", CellKind::polygons},
                                        {"Strips", CellKind::strips}}) {
      const std::size_t n_cells = file_.number(piece.tag, fmt::format("NumberOf{}", section), 0);
      if (n_cells == 0) continue;
      const std::vector<double> ends = file_.values(array_in(piece, section, "offsets"), n_cells);
      const double n_corners = ends.back();
      if (!(n_corners >= 0 && n_corners < 1e12) || n_corners != std::floor(n_corners))
        file_.damaged(fmt::format("the offsets of {}", section));
      data.add_cells(kind, ends,
                     file_.values(array_in(piece, section, "connectivity"), static_cast<std::size_t>(n_corners)),
                     first);
    }
  }

  void add_notes(std::vector<std::string>& notes) const {
    const std::size_t shown = std::min<std::size_t>(file_.dropped().size(), 20);
    notes.insert(notes.end(), file_.dropped().begin(), file_.dropped().begin() + static_cast<std::ptrdiff_t>(shown));
    if (std::ranges::any_of(file_.pieces(),
                            [](const XmlPiece& p) { return VtkXmlFile::find(p, "CellData", "") != nullptr; }))
      notes.emplace_back("cell data dropped");
  }

  // The arrays that all pieces have, in the order of the first.
  void add_point_data(PolyData& data) const {
    const auto with_points = std::ranges::find_if(file_.pieces(), [&](const XmlPiece& p) { return n_points(p) > 0; });
    const auto first = with_points->sections.find("PointData");
    if (first == with_points->sections.end()) return;
    for (const XmlArray& array : first->second) {
      std::vector<double> values;
      bool is_in_all = true;
      for (const XmlPiece& piece : file_.pieces()) {
        if (n_points(piece) == 0) continue;
        const auto arrays = piece.sections.find("PointData");
        const auto same = [&](const XmlArray& a) {
          return a.name == array.name && a.type == array.type && a.n_components == array.n_components;
        };
        const XmlArray* own = nullptr;
        if (arrays != piece.sections.end())
          if (const auto at = std::ranges::find_if(arrays->second, same); at != arrays->second.end()) own = &*at;
        if (own == nullptr) {
          is_in_all = false;
          break;
        }
        const std::vector<double> more = file_.values(*own, n_points(piece) * array.n_components);
        values.insert(values.end(), more.begin(), more.end());
      }
      if (is_in_all) data.add_point_array(array.name, column_type(array.type), array.n_components, values);
      else data.add_dropped(fmt::format("point data '{}' dropped: not every piece has it", printable(array.name)));
    }
  }

  const std::string& path_;
  VtkXmlFile file_;
};

}  // namespace

OriginalShape<3> read_vtp(const std::string& path, std::string_view bytes, std::vector<std::string>& notes) {
  return VtpFile(path, bytes).read(notes);
}

}  // namespace shellmatch

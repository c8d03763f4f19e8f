// VTK's XML format of images.
#include "base/error.h"
#include "base/printable.h"
#include "geometry/io/input_file.h"
#include "geometry/mesh_text/read_text.h"
#include "geometry/volume/grid_file.h"
#include "geometry/volume/volume_header.h"
#include "geometry/vtk_xml/xml_file.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <utility>

namespace shellmatch {

namespace {

constexpr XmlExpectation image{"ImageData", "VTK file of images",
                               "a volume is of type ImageData (in ParaView: Resample To Image, save as .vti)"};

class VtiFile {
 public:
  VtiFile(const std::string& path, std::string_view bytes) : path_(path), file_(path, bytes, image) {
    if (file_.pieces().size() != 1 ||
        extent(file_.pieces()[0].tag, "Extent") != extent(file_.data_set(), "WholeExtent"))
      throw_input_error("{}: an image in {} pieces, or of a part; save it as one whole", path_, file_.pieces().size());
    find_values();
    set_grid();
    const std::optional<VoxelType> type = voxel_type(values_->type);
    if (!type) throw_input_error("{}: values of single bits are not supported; save them as numbers", path_);
    header_.type = *type;
    header_.file = path_;
  }
  const VolumeHeader& header() const { return header_; }
  std::vector<double> values() const { return file_.values(*values_, header_.grid.n_voxels()); }

 private:
  template <std::size_t N>
  std::optional<std::array<double, N>> numbers(const XmlTag& tag, std::string_view key) const {
    const auto text = tag.find(key);
    if (!text) return std::nullopt;
    std::array<double, N> values;
    std::string_view rest = *text;
    for (double& value : values) {
      const auto number = to_double(next_word(rest, " \t\r\n"));
      if (!number) file_.damaged(fmt::format("{} has not {} numbers", key, N));
      value = *number;
    }
    return values;
  }

  std::array<std::int64_t, 6> extent(const XmlTag& tag, std::string_view key) const {
    const auto values = numbers<6>(tag, key);
    if (!values) file_.damaged(fmt::format("no {}", key));
    std::array<std::int64_t, 6> result;
    for (std::size_t i = 0; i < 6; ++i) {
      if (!(std::abs((*values)[i]) < 1e9)) file_.damaged(fmt::format("{} {}", key, (*values)[i]));
      result[i] = static_cast<std::int64_t>((*values)[i]);
    }
    return result;
  }

  // The one array with one number for each point or, where there is none, for each cell.
  void find_values() {
    for (const char* section : {"PointData", "CellData"}) {
      const auto arrays = file_.pieces()[0].sections.find(std::string_view(section));
      if (arrays == file_.pieces()[0].sections.end()) continue;
      for (const XmlArray& array : arrays->second) {
        if (array.n_components != 1 || array.name.starts_with("vtk")) continue;  // ghosts and masks of VTK's own
        if (values_ != nullptr)
          throw_input_error("{}: several arrays of numbers ('{}', '{}'); save the one that is meant", path_,
                            printable(values_->name, 60), printable(array.name, 60));
        values_ = &array;
      }
      if (values_ == nullptr) continue;
      is_of_cells_ = std::string_view(section) == "CellData";
      return;
    }
    throw_input_error("{}: no array with one number for each point or cell", path_);
  }

  void set_grid() {
    const std::array<std::int64_t, 6> range = extent(file_.data_set(), "WholeExtent");
    std::array<std::int64_t, 3> size;
    for (std::size_t k = 0; k < 3; ++k) size[k] = range[2 * k + 1] - range[2 * k] + (is_of_cells_ ? 0 : 1);
    VoxelGrid& grid = header_.grid;
    set_size(path_, size, grid);
    const auto spacing = numbers<3>(file_.data_set(), "Spacing").value_or(std::array<double, 3>{1, 1, 1});
    for (const double s : spacing)
      if (!(s > 0))
        throw_input_error("{}: the spacing of its voxels is {:g} along an axis, and must be positive", path_, s);
    const auto origin = numbers<3>(file_.data_set(), "Origin").value_or(std::array<double, 3>{0, 0, 0});
    const auto direction =
        numbers<9>(file_.data_set(), "Direction").value_or(std::array<double, 9>{1, 0, 0, 0, 1, 0, 0, 0, 1});
    for (int i = 0; i < 3; ++i)
      for (int k = 0; k < 3; ++k)
        grid.axes(i, k) = direction[static_cast<std::size_t>(3 * i + k)] * spacing[static_cast<std::size_t>(k)];
    Vec<3> first;  // indices of the first value: of a point, or of the middle of a cell
    for (int k = 0; k < 3; ++k)
      first[k] = static_cast<double>(range[static_cast<std::size_t>(2 * k)]) + (is_of_cells_ ? 0.5 : 0);
    grid.origin = Vec<3>(origin[0], origin[1], origin[2]) + grid.axes * first;
    grid.file = std::make_shared<const GridFile>(
        GridFile{"its origin and spacing, taken to be in RAS, as it names no frame", {}, {}, {}, {}});
  }

  const std::string& path_;
  VtkXmlFile file_;
  const XmlArray* values_ = nullptr;
  bool is_of_cells_ = false;
  VolumeHeader header_;
};

}  // namespace

std::pair<VolumeHeader, std::vector<double>> read_vti(const std::string& path, bool with_values) {
  const std::string bytes = InputFile(path).read();
  const VtiFile file(path, bytes);
  return {file.header(), with_values ? file.values() : std::vector<double>()};
}

}  // namespace shellmatch

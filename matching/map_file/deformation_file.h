#pragma once
/// \file
/// deformation.vtu: the map with its grid and all fields, as a VTK XML unstructured grid (binary, compressed)
/// that ParaView opens and from which the program reads the map back.

#include "matching/level/deformation.h"

#include <string>
#include <vector>

namespace shellmatch {

inline constexpr const char* deformation_file_name = "deformation.vtu";

/// Values at the grid's nodes, in the order of their numbers, hanging nodes included: "d1" with one
/// component, "n2" with Dim, a matrix's entries row by row, or the packed entries of a symmetric one.
struct NodalField {
  std::string name;
  int n_components = 1;
  std::vector<double> values;  ///< n_nodes * n_components, a node's components one after the other
};

/// One value for each leaf, in the order of Octree::leaves(): "in_band", "min_determinant".
struct CellField {
  std::string name;
  std::vector<double> values;
};

/// Writes cells (VTK_PIXEL or VTK_VOXEL) and nodes in the unit domain, the point data phi and displacement
/// and the given fields, the cell data level and the given fields, and the field data dimension,
/// placement_scale, placement_offset (user's coordinates to unit domain) and program_version.
/// In the plane the third coordinate is 0, and fields of two components get a third, 0, as ParaView wants
/// vectors. A comment with a checksum ends the file. \pre all fields are as long as the grid asks for.
/// \throws EnvironmentError if the file cannot be written
template <int Dim>
void write_deformation(const std::string& path, const Deformation<Dim>& deformation,
                       const std::vector<NodalField>& nodal_fields = {},
                       const std::vector<CellField>& cell_fields = {});

/// The same of a map that is still being worked on.
template <int Dim>
void write_deformation(const std::string& path, const Octree<Dim>& grid, const std::vector<Vec<Dim>>& phi,
                       const Similarity<Dim>& placement, const std::vector<NodalField>& nodal_fields = {},
                       const std::vector<CellField>& cell_fields = {});

/// Reads a map back: the same leaves, node positions and placement, and phi to the bit. The numbers of nodes
/// and cells may differ from those of the grid that was written.
/// \param path the file, or an output folder that holds it
/// \throws InputError if it is not there, is damaged, or is no file of dimension Dim that this program wrote
template <int Dim>
Deformation<Dim> read_deformation(const std::string& path);

/// 2 or 3. \throws InputError as read_deformation
int deformation_dimension(const std::string& path);

}  // namespace shellmatch

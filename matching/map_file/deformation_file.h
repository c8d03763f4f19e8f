#pragma once
/// \file
/// deformation.vtu: the map with its grid and all fields as a VTK XML unstructured grid (binary, compressed). ParaView
/// opens it, and the program reads the map back from it.

#include "matching/level/deformation.h"

#include <string>
#include <vector>

namespace shellmatch {

inline constexpr const char* deformation_file_name = "deformation.vtu";

/// Values at the nodes in the order of their numbers, hanging nodes included: "d1" with one component, "n2" with Dim, a
/// matrix with its entries row by row, or a symmetric matrix with its packed entries.
struct NodalField {
  std::string name;
  int n_components = 1;
  std::vector<double> values;  ///< n_nodes * n_components, node by node
};

/// One value for each leaf, in the order of Octree::leaves(): "in_band", "min_determinant".
struct CellField {
  std::string name;
  std::vector<double> values;
};

/// Writes cells (VTK_PIXEL or VTK_VOXEL) and nodes in the unit domain; the point data phi, displacement and the given
/// fields; the cell data level and the given fields; the field data dimension, placement_scale, placement_offset
/// (user's coordinates to unit domain), where there is a pose pose_scale, pose_rotation (row by row) and pose_offset,
/// is_backward with the value 1 where it holds, where the reference was bent bend_sizes, bend_vertices (before and
/// after) and bend_facets, space where the shapes name a frame (geometry/surface/space.h), and program_version. In the
/// plane the third coordinate is 0, and fields of two components get a third, 0, because ParaView expects vectors of
/// three. A comment with a checksum ends the file. \pre all fields have the grid's size \throws EnvironmentError if the
/// file cannot be written
template <int Dim>
void write_deformation(const std::string& path, const Deformation<Dim>& deformation,
                       const std::vector<NodalField>& nodal_fields = {},
                       const std::vector<CellField>& cell_fields = {});

/// Writes a map given by its parts.
template <int Dim>
void write_deformation(const std::string& path, const Octree<Dim>& grid, const std::vector<Vec<Dim>>& phi,
                       const MapFrame<Dim>& frame, const std::vector<NodalField>& nodal_fields = {},
                       const std::vector<CellField>& cell_fields = {});

/// Reads a map back: the same leaves, node positions and placement, and phi bit for bit. The numbers of nodes and cells
/// may differ from those of the grid that was written.
/// \param path the file, or an output folder that holds it
/// \throws InputError if it is missing, damaged, or no file of dimension Dim that this program wrote
template <int Dim>
Deformation<Dim> read_deformation(const std::string& path);

/// The same from the bytes of a file, of whose checksum nothing is asked. \param path for messages
template <int Dim>
Deformation<Dim> parse_deformation(const std::string& path, const std::string& bytes);

/// The dimension of the map in the file, 2 or 3. \throws InputError as read_deformation
int deformation_dimension(const std::string& path);

}  // namespace shellmatch

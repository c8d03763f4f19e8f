#pragma once
/// \file
/// What a volume's file says of the place of its voxels beyond the grid that is made of it.

#include "base/types.h"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace shellmatch {

/// The two transforms of a NIfTI, by the names of nifti1.h; lengths in millimetres where its unit is known.
struct NiftiPlacement {
  int qform_code = 0, sform_code = 0;
  double qfac = 1;  ///< pixdim[0]: 1 or -1
  Vec<3> pixdim = Vec<3>::Ones();
  std::array<double, 6> quatern{};  ///< b, c, d, offset x, y, z
  Mat<3> srow = Mat<3>::Zero();
  Vec<3> srow_offset = Vec<3>::Zero();

  /// Columns lead from voxel to voxel, by the qform.
  Mat<3> qform_axes() const;
  Vec<3> qform_origin() const { return {quatern[3], quatern[4], quatern[5]}; }
};

/// By which of the two ITK's reader goes (5.2; itkNiftiImageIO.cxx), and with it ANTs, elastix and 3D Slicer; spacings
/// are those of pixdim in any case. An sform whose axes are not at right angles or not as long as pixdim says it never
/// takes; one that is not the qform's only with code 1. Later ones (5.4) take no offence at lengths.
enum class ItkChoice { sform, qform, identity, refused };
ItkChoice itk_choice(const NiftiPlacement& placement, const std::array<int, 3>& size);

struct GridFile {
  std::string placed_by;  ///< "its sform (code 1), in RAS"
  std::vector<std::string>
      notes;  ///< where other programs may place the voxels elsewhere, and what the header contradicts itself in
  std::optional<NiftiPlacement> nifti;
  std::string unit;   ///< of an NRRD's or NIfTI's numbers, where they were turned into millimetres: "um"
  std::string space;  ///< of an NRRD, where readers differ on it: "left-anterior-superior"
};

}  // namespace shellmatch

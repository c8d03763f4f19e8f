#include "geometry/volume/nifti_placement.h"

#include "base/error.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace shellmatch {

namespace {

// The largest distance between the places that two frames give a corner of the volume.
double distance_between(const Mat<3>& axes, const Vec<3>& origin, const Mat<3>& other_axes, const Vec<3>& other_origin,
                        const std::array<int, 3>& size) {
  double largest = 0;
  for (int c = 0; c < 8; ++c) {
    Vec<3> corner;
    for (int a = 0; a < 3; ++a) corner[a] = c >> a & 1 ? size[a] - 1 : 0;
    largest = std::max(largest, ((axes - other_axes) * corner + origin - other_origin).norm());
  }
  return largest;
}

// The sform with columns as long as pixdim says: its directions.
Mat<3> srow_of_pixdim(const NiftiPlacement& p) { return p.srow.colwise().normalized() * p.pixdim.asDiagonal(); }

// At right angles, and as long as pixdim says.
bool is_rotation_of_pixdim(const NiftiPlacement& p) {
  const Mat<3> directions = p.srow * p.pixdim.cwiseInverse().asDiagonal();
  return (directions * directions.transpose() - Mat<3>::Identity()).cwiseAbs().maxCoeff() < 1e-4;
}

std::string three(const Vec<3>& x) { return fmt::format("{:.4g} x {:.4g} x {:.4g}", x[0], x[1], x[2]); }

}  // namespace

Mat<3> NiftiPlacement::qform_axes() const {
  const Vec<3> v(quatern[0], quatern[1], quatern[2]);
  const Eigen::Quaterniond q(std::sqrt(std::max(0.0, 1 - v.squaredNorm())), v[0], v[1], v[2]);
  Mat<3> axes = q.normalized().toRotationMatrix() * pixdim.asDiagonal();
  if (qfac < 0) axes.col(2) *= -1;
  return axes;
}

ItkChoice itk_choice(const NiftiPlacement& p, const std::array<int, 3>& size) {
  const bool has_qform = p.qform_code > 0, has_sform = p.sform_code > 0;
  if (!has_qform && !has_sform) return ItkChoice::identity;
  if (has_sform && is_rotation_of_pixdim(p)) {
    if (!has_qform || p.sform_code == 1) return ItkChoice::sform;
    // A difference in rounding places nothing elsewhere.
    if (distance_between(srow_of_pixdim(p), p.srow_offset, p.qform_axes(), p.qform_origin(), size) <
        1e-3 * p.pixdim.minCoeff())
      return ItkChoice::sform;
  }
  return has_qform ? ItkChoice::qform : ItkChoice::refused;
}

void place_by_nifti(const std::string& path, const NiftiPlacement& p, VoxelGrid& grid, GridFile& file) {
  constexpr double visible = 0.1;  // of a voxel: quaternions of single precision are off by less
  const double tolerance = visible * p.pixdim.minCoeff();
  if (p.sform_code > 0) {
    grid.axes = p.srow;
    grid.origin = p.srow_offset;
    file.placed_by = fmt::format("its sform (code {}), in RAS", p.sform_code);
  } else if (p.qform_code > 0) {
    grid.axes = p.qform_axes();
    grid.origin = p.qform_origin();
    file.placed_by = fmt::format("its qform (code {}), in RAS", p.qform_code);
  } else {
    grid.axes = p.pixdim.asDiagonal();
    grid.origin = Vec<3>::Zero();
    file.placed_by = "the size of its voxels alone";
    file.notes.emplace_back(
        "its header does not say where it lies (the codes of qform and sform are 0): taken to begin at 0 along the "
        "axes of RAS; "
        "ITK, ANTs and 3D Slicer take it to begin at 0 along those of LPS, nibabel to lie around 0 with x turned");
  }
  if (!grid.origin.allFinite() || !grid.axes.allFinite())
    throw_input_error("{}: its position in space is not finite (quatern or srow of the header)", path);
  const ItkChoice by_itk = itk_choice(p, grid.size);
  if (p.sform_code > 0) {
    const Vec<3> lengths = p.srow.colwise().norm();
    if (((lengths - p.pixdim).cwiseAbs().array() > 1e-3 * p.pixdim.array()).any())
      file.notes.push_back(fmt::format(
          "its voxels are {} by the sform and {} by pixdim: the sform is used; ITK, ANTs and 3D Slicer use pixdim",
          three(lengths), three(p.pixdim)));
    if (p.qform_code > 0) {
      const double apart =
          distance_between(srow_of_pixdim(p), p.srow_offset, p.qform_axes(), p.qform_origin(), grid.size);
      if (apart > tolerance)
        file.notes.push_back(
            fmt::format("its sform (code {}) and its qform (code {}) place voxels up to {:.3g} apart: the sform is "
                        "used, as by nibabel; ITK, ANTs "
                        "and 3D Slicer use the {}",
                        p.sform_code, p.qform_code, apart, by_itk == ItkChoice::sform ? "sform, too" : "qform"));
    }
  }
  if (by_itk == ItkChoice::refused)
    file.notes.emplace_back(
        "the axes of its sform are not at right angles or not as long as pixdim says, and there is no qform: ITK 5.2, "
        "and ANTs and "
        "3D Slicer with it, do not read such a NIfTI; they read an .nrrd of it");
}

}  // namespace shellmatch

#include "tests/apps/itk_transform.h"

#include <itkDisplacementFieldTransform.h>
#include <itkImageFileReader.h>
#include <itkMetaImageIO.h>
#include <itkNiftiImageIO.h>
#include <itkNrrdImageIO.h>

namespace shellmatch {

int itk_version() { return 100 * ITK_VERSION_MAJOR + ITK_VERSION_MINOR; }

std::vector<LpsPoint> moved_by_itk(const std::string& file, const std::vector<LpsPoint>& points) {
  using Transform = itk::DisplacementFieldTransform<double, 3>;
  using Reader = itk::ImageFileReader<Transform::DisplacementFieldType>;
  const auto reader = Reader::New();
  reader->SetImageIO(itk::NiftiImageIO::New());
  reader->SetFileName(file);
  reader->Update();
  const auto transform = Transform::New();
  transform->SetDisplacementField(reader->GetOutput());
  std::vector<LpsPoint> moved;
  for (const LpsPoint& x : points) {
    const auto y = transform->TransformPoint(Transform::InputPointType(x.data()));
    moved.push_back({y[0], y[1], y[2]});
  }
  return moved;
}

ItkVoxel voxel_by_itk(const std::string& file, const std::array<int, 3>& index) {
  using Image = itk::Image<double, 3>;
  const auto reader = itk::ImageFileReader<Image>::New();
  if (file.ends_with(".nrrd")) reader->SetImageIO(itk::NrrdImageIO::New());
  else if (file.ends_with(".mha")) reader->SetImageIO(itk::MetaImageIO::New());
  else reader->SetImageIO(itk::NiftiImageIO::New());
  reader->SetFileName(file);
  reader->Update();
  const Image::IndexType at{index[0], index[1], index[2]};
  Image::PointType x;
  reader->GetOutput()->TransformIndexToPhysicalPoint(at, x);
  return {{x[0], x[1], x[2]}, reader->GetOutput()->GetPixel(at)};
}

}  // namespace shellmatch

#include "tests/apps/itk_transform.h"

#include <itkDisplacementFieldTransform.h>
#include <itkImageFileReader.h>
#include <itkNiftiImageIO.h>

namespace shellmatch {

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

}  // namespace shellmatch

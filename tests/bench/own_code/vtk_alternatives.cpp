#include "tests/bench/own_code/alternatives.h"

#include <vtkCellArray.h>
#include <vtkCommand.h>
#include <vtkErrorCode.h>
#include <vtkImageData.h>
#include <vtkImageGaussianSmooth.h>
#include <vtkMarchingSquares.h>
#include <vtkNew.h>
#include <vtkObject.h>
#include <vtkPLYReader.h>
#include <vtkPNMReader.h>
#include <vtkPolyData.h>

namespace shellmatch::own_code {

namespace {

// Messages count as errors and are not printed.
class Errors : public vtkCommand {
 public:
  static Errors* New() { return new Errors; }
  void Execute(vtkObject*, unsigned long, void*) override { any = true; }
  bool any = false;
};

template <class Reader>
bool run(Reader& reader, const std::string& path) {
  vtkNew<Errors> errors;
  reader.AddObserver(vtkCommand::ErrorEvent, errors);
  reader.AddObserver(vtkCommand::WarningEvent, errors);
  reader.SetFileName(path.c_str());
  reader.Update();
  return !errors->any && reader.GetErrorCode() == vtkErrorCode::NoError;
}

}  // namespace

std::optional<OriginalShape<3>> vtk_ply(const std::string& path) {
  vtkNew<vtkPLYReader> reader;
  if (!run(*reader, path)) return std::nullopt;
  vtkPolyData& data = *reader->GetOutput();
  OriginalShape<3> shape;
  for (vtkIdType i = 0; i < data.GetNumberOfPoints(); ++i) shape.vertices.emplace_back(data.GetPoint(i));
  vtkIdType n = 0;
  const vtkIdType* corners = nullptr;
  for (data.GetPolys()->InitTraversal(); data.GetPolys()->GetNextCell(n, corners);)
    shape.polygons.emplace_back(corners, corners + n);
  return shape;
}

std::optional<GreyImage> vtk_pgm(const std::string& path) {
  vtkNew<vtkPNMReader> reader;
  if (reader->CanReadFile(path.c_str()) == 0 || !run(*reader, path)) return std::nullopt;
  vtkImageData& data = *reader->GetOutput();
  if (data.GetNumberOfPoints() == 0 || data.GetNumberOfScalarComponents() != 1) return std::nullopt;
  const int* size = data.GetDimensions();
  GreyImage image{size[0], size[1], {}};
  const auto copy = [&](const auto* values, float white) {
    for (int row = size[1] - 1; row >= 0; --row)
      for (int column = 0; column < size[0]; ++column)
        image.values.push_back(static_cast<float>(values[static_cast<std::ptrdiff_t>(row) * size[0] + column]) / white);
  };
  image.values.reserve(static_cast<std::size_t>(data.GetNumberOfPoints()));
  if (data.GetScalarType() == VTK_UNSIGNED_CHAR)
    copy(static_cast<const unsigned char*>(data.GetScalarPointer()), 255.0f);
  else if (data.GetScalarType() == VTK_UNSIGNED_SHORT)
    copy(static_cast<const unsigned short*>(data.GetScalarPointer()), 65535.0f);
  else return std::nullopt;
  return image;
}

std::vector<Vec<2>> vtk_mask_points(const GreyImage& image, double deviation) {
  constexpr int pad = 6;
  vtkNew<vtkImageData> data;
  data->SetDimensions(image.width + 2 * pad, image.height + 2 * pad, 1);
  data->AllocateScalars(VTK_FLOAT, 1);
  auto* values = static_cast<float*>(data->GetScalarPointer());
  std::fill_n(values, data->GetNumberOfPoints(), 0.0f);
  for (int row = 0; row < image.height; ++row)
    for (int column = 0; column < image.width; ++column)
      values[static_cast<std::ptrdiff_t>(image.height - 1 - row + pad) * (image.width + 2 * pad) + column + pad] =
          image.at(column, row);
  vtkNew<vtkImageGaussianSmooth> smooth;
  smooth->SetInputData(data);
  smooth->SetDimensionality(2);
  smooth->SetStandardDeviation(deviation);
  smooth->SetRadiusFactor(4);
  smooth->SetNumberOfThreads(1);
  vtkNew<vtkMarchingSquares> contour;
  contour->SetInputConnection(smooth->GetOutputPort());
  contour->SetValue(0, 0.5);
  contour->Update();
  std::vector<Vec<2>> points;
  for (vtkIdType i = 0; i < contour->GetOutput()->GetNumberOfPoints(); ++i) {
    const double* p = contour->GetOutput()->GetPoint(i);
    points.emplace_back(p[0] - pad + 0.5, p[1] - pad + 0.5);
  }
  return points;
}

}  // namespace shellmatch::own_code

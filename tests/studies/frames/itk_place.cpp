// itk_place FILE I J K: prints where ITK has the voxel (I, J, K), which may lie between voxels, in LPS; exits with 1
// where it does not read the file.
#include <itkImageFileReader.h>
#include <itkMetaImageIO.h>
#include <itkNiftiImageIO.h>
#include <itkNrrdImageIO.h>
#include <itkVersion.h>

#include <cstdlib>
#include <iostream>
#include <string>

int main(int n, char** words) {
  if (n == 2 && std::string(words[1]) == "--version") {
    std::cout << itk::Version::GetITKVersion() << "\n";
    return 0;
  }
  if (n != 5) return 2;
  const std::string file = words[1];
  const auto ends = [&](const std::string& ending) {
    return file.size() > ending.size() && file.substr(file.size() - ending.size()) == ending;
  };
  using Image = itk::Image<unsigned char, 3>;
  const auto reader = itk::ImageFileReader<Image>::New();
  if (ends(".nrrd")) reader->SetImageIO(itk::NrrdImageIO::New());
  else if (ends(".mha")) reader->SetImageIO(itk::MetaImageIO::New());
  else reader->SetImageIO(itk::NiftiImageIO::New());
  reader->SetFileName(file);
  try {
    reader->Update();
  } catch (const itk::ExceptionObject&) {
    return 1;
  }
  itk::ContinuousIndex<double, 3> at;
  for (unsigned k = 0; k < 3; ++k) at[k] = std::atof(words[k + 2]);
  Image::PointType x;
  reader->GetOutput()->TransformContinuousIndexToPhysicalPoint(at, x);
  std::cout.precision(12);
  std::cout << x[0] << " " << x[1] << " " << x[2] << "\n";
}

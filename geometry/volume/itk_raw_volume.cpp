#include "base/error.h"
#include "base/printable.h"
#include "geometry/volume/raw_volume.h"
#include "geometry/volume/volume_name.h"

#include <itkMetaImageIO.h>
#include <itkNiftiImageIO.h>
#include <itkNrrdImageIO.h>

#include <algorithm>
#include <cmath>
#include <ios>
#include <iostream>
#include <new>
#include <sstream>
#include <vector>

namespace shellmatch {

namespace {

using Component = itk::ImageIOBase::IOComponentEnum;

// Keeps ITK's messages off the terminal; what goes wrong comes as an exception, too.
class Silence {
 public:
  Silence() : warnings_(itk::Object::GetGlobalWarningDisplay()), before_(std::cerr.rdbuf(dropped_.rdbuf())) {
    itk::Object::SetGlobalWarningDisplay(false);
  }
  ~Silence() {
    std::cerr.rdbuf(before_);
    itk::Object::SetGlobalWarningDisplay(warnings_);
  }
  Silence(const Silence&) = delete;
  Silence& operator=(const Silence&) = delete;

 private:
  bool warnings_;
  std::ostringstream dropped_;
  std::streambuf* before_;
};

itk::ImageIOBase::Pointer image_io(const std::string& path) {
  switch (volume_format(path)) {
    case VolumeFormat::nrrd: return itk::NrrdImageIO::New().GetPointer();
    case VolumeFormat::meta_image: return itk::MetaImageIO::New().GetPointer();
    default: return itk::NiftiImageIO::New().GetPointer();
  }
}

// On one line.
std::string text_of(const itk::ExceptionObject& error) {
  std::string text = error.GetDescription();
  std::replace(text.begin(), text.end(), '\n', ' ');
  // "ITK ERROR: NiftiImageIO(0x55...): " says nothing to a user.
  if (const std::size_t begin = text.find("): "); text.find("ERROR") < begin && begin != text.npos) text.erase(0, begin + 3);
  while (text.ends_with(' ')) text.pop_back();
  return printable(text, 300);
}

template <class Body>
void read_by_itk(const std::string& path, Body&& body) {
  const Silence silence;
  try {
    body();
  } catch (const itk::MemoryAllocationError&) {
    throw std::bad_alloc();
  } catch (const itk::ExceptionObject& error) {
    throw_input_error("{}: damaged, cut off, or no volume that can be read (ITK: {}); export it again", path, text_of(error));
  }
}

std::optional<VoxelType> type_of(Component component) {
  static_assert(sizeof(long) == 8);
  switch (component) {
    case Component::UCHAR: return VoxelType::uint8;
    case Component::CHAR: return VoxelType::int8;
    case Component::USHORT: return VoxelType::uint16;
    case Component::SHORT: return VoxelType::int16;
    case Component::UINT: return VoxelType::uint32;
    case Component::INT: return VoxelType::int32;
    case Component::ULONG:
    case Component::ULONGLONG: return VoxelType::uint64;
    case Component::LONG:
    case Component::LONGLONG: return VoxelType::int64;
    case Component::FLOAT: return VoxelType::float32;
    case Component::DOUBLE: return VoxelType::float64;
    default: return std::nullopt;
  }
}

Component component_of(VoxelType type) {
  switch (type) {
    case VoxelType::uint8: return Component::UCHAR;
    case VoxelType::int8: return Component::CHAR;
    case VoxelType::uint16: return Component::USHORT;
    case VoxelType::int16: return Component::SHORT;
    case VoxelType::uint32: return Component::UINT;
    case VoxelType::int32: return Component::INT;
    case VoxelType::uint64: return Component::ULONG;
    case VoxelType::int64: return Component::LONG;
    case VoxelType::float32: return Component::FLOAT;
    default: return Component::DOUBLE;
  }
}

itk::ImageIORegion whole(const itk::ImageIOBase& io) {
  itk::ImageIORegion region(io.GetNumberOfDimensions());
  for (unsigned k = 0; k < io.GetNumberOfDimensions(); ++k) {
    region.SetIndex(k, 0);
    region.SetSize(k, io.GetDimensions(k));
  }
  return region;
}

RawHeader header_of(const itk::ImageIOBase& io) {
  RawHeader header;
  header.n_dimensions = io.GetNumberOfDimensions();
  for (unsigned k = 0; k < header.n_dimensions; ++k) {
    if (k >= 3) {
      header.is_series = header.is_series || io.GetDimensions(k) != 1;
      continue;
    }
    header.size[k] = io.GetDimensions(k);
    header.origin[k] = io.GetOrigin(k);
    const std::vector<double> direction = io.GetDirection(k);
    for (unsigned j = 0; j < 3 && j < direction.size(); ++j) header.axes[k][j] = direction[j] * io.GetSpacing(k);
  }
  header.n_components = io.GetNumberOfComponents();
  header.type = type_of(io.GetComponentType());
  header.value_bytes = header.type ? io.GetComponentSize() : 1;
  return header;
}

}  // namespace

struct RawVolumeReader::File {
  itk::ImageIOBase::Pointer io;
};

RawVolumeReader::RawVolumeReader(const std::string& path) : path_(path), file_(std::make_unique<File>(File{image_io(path)})) {
  read_by_itk(path, [&] {
    file_->io->SetFileName(path);
    file_->io->ReadImageInformation();
    header_ = header_of(*file_->io);
  });
}

RawVolumeReader::~RawVolumeReader() = default;

void RawVolumeReader::read(char* to) const {
  read_by_itk(path_, [&] {
    file_->io->SetIORegion(whole(*file_->io));
    file_->io->Read(to);
  });
}

std::string write_raw_volume(const std::string& path, const RawHeader& header, const void* values) {
  const itk::ImageIOBase::Pointer io = image_io(path);
  const Silence silence;
  try {
    io->SetNumberOfDimensions(3);
    for (unsigned k = 0; k < 3; ++k) {
      const std::array<double, 3>& axis = header.axes[k];
      const double spacing = std::sqrt(axis[0] * axis[0] + axis[1] * axis[1] + axis[2] * axis[2]);
      io->SetDimensions(k, header.size[k]);
      io->SetSpacing(k, spacing);
      io->SetOrigin(k, header.origin[k]);
      io->SetDirection(k, std::vector<double>{axis[0] / spacing, axis[1] / spacing, axis[2] / spacing});
    }
    io->SetIORegion(whole(*io));
    io->SetComponentType(component_of(header.type.value()));
    io->SetNumberOfComponents(header.n_components);
    io->SetPixelType(header.n_components == 1 ? itk::IOPixelEnum::SCALAR : itk::IOPixelEnum::VECTOR);
    io->SetUseCompression(true);
    io->SetFileName(path);
    io->Write(values);
  } catch (const itk::ExceptionObject& error) {
    return text_of(error);
  }
  return "";
}

}  // namespace shellmatch

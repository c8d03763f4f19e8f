#include "geometry/io/input_file.h"

#include "base/error.h"
#include "base/stop.h"
#include "geometry/scene/brain_surface.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string_view>
#include <system_error>
#include <utility>

namespace shellmatch {

namespace {

constexpr std::pair<std::string_view, FileFormat> endings[] = {
    {".obj", FileFormat::obj},      {".off", FileFormat::off},      {".ply", FileFormat::ply},
    {".stl", FileFormat::stl},      {".vtk", FileFormat::vtk},      {".vtp", FileFormat::vtp},
    {".gii", FileFormat::gifti},    {".glb", FileFormat::gltf},     {".gltf", FileFormat::gltf},
    {".dae", FileFormat::collada},  {".3mf", FileFormat::three_mf}, {".csv", FileFormat::table},
    {".txt", FileFormat::table},    {".xy", FileFormat::table},     {".dat", FileFormat::table},
    {".png", FileFormat::png},      {".pgm", FileFormat::pgm},      {".tif", FileFormat::tiff},
    {".tiff", FileFormat::tiff},    {".jpg", FileFormat::jpeg},     {".jpeg", FileFormat::jpeg},
    {".bmp", FileFormat::bmp},      {".xyz", FileFormat::points},   {".tps", FileFormat::tps},
    {".roi", FileFormat::roi},      {".zip", FileFormat::roi_set},  {".geojson", FileFormat::geojson},
    {".json", FileFormat::geojson}, {".svg", FileFormat::svg}};

// Of files alone: a pipe would wait.
bool begins_as_freesurfer(const std::string& path) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error)) return false;
  std::ifstream stream(path, std::ios::binary);
  std::string head(freesurfer_head, '\0');
  return stream.read(head.data(), static_cast<std::streamsize>(head.size())) &&
         is_freesurfer(head, std::filesystem::file_size(path, error));
}

}  // namespace

std::string file_extension(const std::string& path) {
  std::string extension = std::filesystem::path(path).extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  return extension;
}

FileFormat format_of(const std::string& path) {
  const std::string extension = file_extension(path);
  // Points of 3D Slicer.
  if (extension == ".json" && file_extension(path.substr(0, path.size() - 5)) == ".mrk") return FileFormat::unknown;
  for (const auto& [ending, format] : endings)
    if (ending == extension) return format;
  return begins_as_freesurfer(path) ? FileFormat::freesurfer : FileFormat::unknown;
}

int dimension_of(FileFormat format) {
  switch (format) {
    case FileFormat::obj:
    case FileFormat::off:
    case FileFormat::ply:
    case FileFormat::stl:
    case FileFormat::vtk:
    case FileFormat::vtp:
    case FileFormat::gifti:
    case FileFormat::freesurfer:
    case FileFormat::gltf:
    case FileFormat::collada:
    case FileFormat::three_mf: return 3;
    case FileFormat::table:
    case FileFormat::png:
    case FileFormat::pgm:
    case FileFormat::tiff:
    case FileFormat::jpeg:
    case FileFormat::bmp:
    case FileFormat::tps:
    case FileFormat::roi:
    case FileFormat::roi_set:
    case FileFormat::geojson:
    case FileFormat::svg: return 2;
    default: return 0;
  }
}

bool is_picture(FileFormat format) {
  return format == FileFormat::png || format == FileFormat::pgm || format == FileFormat::tiff ||
         format == FileFormat::jpeg || format == FileFormat::bmp;
}

bool has_parts(FileFormat format) { return dimension_of(format) == 2 && format != FileFormat::table; }

InputFile::InputFile(std::string path) : path_(std::move(path)), format_(format_of(path_)) {
  namespace fs = std::filesystem;
  std::error_code error;
  const fs::file_status status = fs::status(path_, error);
  if (!fs::exists(status)) {
    if (error && error != std::errc::no_such_file_or_directory && error != std::errc::not_a_directory)
      throw_input_error("{}: cannot be opened ({})", path_, error.message());
    throw_input_error("{}: no such file; check the name and the folder", path_);
  }
  if (fs::is_directory(status)) throw_input_error("{}: is a folder, not a file; name the file in it", path_);
  if (!fs::is_regular_file(status))
    throw_input_error("{}: is a pipe or a device, not a file; write its contents to a file", path_);
}

std::string InputFile::read() const {
  std::ifstream stream(path_, std::ios::binary);
  if (!stream) throw_input_error("{}: cannot be opened ({})", path_, std::strerror(errno));
  std::string bytes;
  // In pieces: the file may grow or shrink meanwhile.
  std::error_code error;
  const std::uintmax_t size = std::filesystem::file_size(path_, error), most = 1 << 20;
  std::string piece(error ? most : std::clamp<std::uintmax_t>(size + 1, 4096, most), '\0');
  Activity reading("reading", error ? 0 : size);
  while (stream.read(piece.data(), static_cast<std::streamsize>(piece.size())) || stream.gcount() > 0) {
    bytes.append(piece, 0, static_cast<std::size_t>(stream.gcount()));
    reading.done(bytes.size());
  }
  if (stream.bad()) throw_input_error("{}: cannot be read to its end ({})", path_, std::strerror(errno));
  if (bytes.empty()) throw_input_error("{}: the file is empty (0 bytes)", path_);
  return bytes;
}

PartName split_part(const std::string& source) {
  for (std::size_t colon = source.find(':'); colon != source.npos; colon = source.find(':', colon + 1)) {
    const std::string file = source.substr(0, colon);
    if (has_parts(format_of(file))) return {file, source.substr(colon + 1)};
  }
  return {source, {}};
}

}  // namespace shellmatch

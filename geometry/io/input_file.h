#pragma once
/// \file
/// A file on its way in: that it is there, what its name says of its format, and its bytes.

#include <string>

namespace shellmatch {

/// The ending of a file name in lower case with its dot, ".ply"; empty where there is none.
std::string file_extension(const std::string& path);

/// What a name stands for by its ending. The contents are asked only where the ending is unknown: surfaces of
/// FreeSurfer's have none.
enum class FileFormat {
  obj,
  off,
  ply,
  stl,
  vtk,
  vtp,  ///< meshes
  gifti,
  freesurfer,  ///< surfaces of neuroimaging
  gltf,
  collada,
  three_mf,  ///< scenes of meshes
  table,     ///< .csv, .txt, .xy, .dat: an outline in the plane, or points
  points,    ///< .xyz: points alone
  png,
  pgm,
  tiff,
  jpeg,
  bmp,  ///< masks
  tps,
  roi,
  roi_set,
  geojson,
  svg,  ///< outlines that other programs drew
  unknown
};
FileFormat format_of(const std::string& path);

/// Of the shapes in files of that format: 3 for meshes, 2 for tables, masks and drawings, 0 for what holds no shape.
int dimension_of(FileFormat format);

/// Is it a mask?
bool is_picture(FileFormat format);

/// Can a part of such a file be chosen, as in "cells.png:3" (geometry/io/input_file.h)?
bool has_parts(FileFormat format);

/// A file that exists: no folder, and no pipe or device, of which nobody knows whether it ends.
class InputFile {
 public:
  /// \throws InputError where it is missing or no file
  explicit InputFile(std::string path);

  const std::string& path() const { return path_; }
  FileFormat format() const { return format_; }
  /// All of its bytes. \throws InputError where it cannot be read or is empty
  std::string read() const;

 private:
  std::string path_;
  FileFormat format_;
};

/// The name of a part of a picture or a drawing: "cells.png:3", "cells.tif:>100", "rois.zip:NAME",
/// "cells.geojson:NAME".
struct PartName {
  std::string file;
  std::string part;  ///< empty: none is chosen
};

/// Splits a name at the first colon after the ending of a picture or a drawing; a colon elsewhere belongs to the file's
/// name.
PartName split_part(const std::string& source);

}  // namespace shellmatch

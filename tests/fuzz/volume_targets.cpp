#include "base/error.h"
#include "geometry/label/label_region.h"
#include "geometry/label/smoothed_label.h"
#include "geometry/volume/volume_file.h"
#include "geometry/volume/volume_header.h"
#include "geometry/volume/zlib_volume.h"
#include "tests/fuzz/target.h"

#include <Eigen/LU>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>

namespace shellmatch::fuzz {

namespace {

// A file with the ending that the libraries go by.
class NamedFile {
 public:
  NamedFile(std::string_view bytes, const char* ending)
      : path_(
            (std::filesystem::temp_directory_path() / fmt::format("shellmatch-fuzz-{}{}", getpid(), ending)).string()) {
    std::ofstream(path_, std::ios::binary).write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  }
  ~NamedFile() {
    std::error_code ignored;
    std::filesystem::remove(path_, ignored);
  }
  NamedFile(const NamedFile&) = delete;
  NamedFile& operator=(const NamedFile&) = delete;
  const std::string& path() const { return path_; }

 private:
  std::string path_;
};

// What the name chooses, or the words why it cannot.
void read_choice(const std::string& path, const VoxelChoice& choice) {
  try {
    const VolumePart part = read_volume_part({path, choice});
    demand(part.choice.labels.size() == 1 && part.volume.values.size() == part.volume.grid.n_voxels(),
           "a segment is one label of one layer");
  } catch (const InputError&) {  // of a layer that is not there, named twice, or not at all
  }
}

void read_as(std::string_view bytes, const char* ending) {
  const NamedFile file(bytes, ending);
  const Volume volume = canonical(read_volume_part({file.path(), {}}).volume);
  demand(volume.values.size() == volume.grid.n_voxels(), "every voxel has a value");
  for (const float v : volume.values) demand(std::isfinite(v), "values are finite");
  demand(volume.grid.origin.allFinite() && volume.grid.axes.allFinite() && volume.grid.voxel_volume() > 0,
         "voxels lie in space");
  if (volume.values.size() > 20000) return;
  const LabelRegion region = label_region(volume, {}, "input");
  const SmoothedLabel label(region);
  demand(label.level() >= 0.15 && label.level() <= 0.6, "a level is a share");
  for (const float share : region.shares) demand(share >= 0 && share < 1.001f, "shares are shares");
}

}  // namespace

void read_nifti_bytes(std::string_view bytes) { read_as(bytes, ".nii"); }
void read_compressed_nifti_bytes(std::string_view bytes) {
  for (const Deflated form : {Deflated::gzip, Deflated::zlib}) {
    const NamedFile packed(deflated(bytes, form), ".gz");
    std::string again;
    for_each_piece(packed.path(), 0, true, 0, bytes.size() + 1, [&](std::string_view piece) { again += piece; });
    demand(again == bytes, "what is packed is unpacked");
  }
  read_as(bytes, ".nii.gz");
}
void read_nrrd_bytes(std::string_view bytes) {
  read_as(bytes, ".nrrd");
  const NamedFile file(bytes, ".nrrd");
  for (const Segment& segment : read_volume_header(file.path()).segments) {
    demand(segment.label && segment.layer, "a segment has a label and a layer");
    read_choice(file.path(), {{}, 0, segment.name});
  }
  read_choice(file.path(), {{}, 0, "of no file"});
  read_choice(file.path(), {{1}, 0, {}});
}
void read_meta_image_bytes(std::string_view bytes) { read_as(bytes, ".mha"); }
void read_vti_bytes(std::string_view bytes) { read_as(bytes, ".vti"); }

}  // namespace shellmatch::fuzz

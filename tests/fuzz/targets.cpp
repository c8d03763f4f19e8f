// Calls the reader that SHELLMATCH_FUZZ_TARGET names: whatever the bytes, it returns or throws an InputError (scripts/fuzz).
#include "base/error.h"
#include "geometry/io/read_mask.h"
#include "geometry/io/read_mesh_formats.h"
#include "geometry/io/read_points.h"
#include "matching/checkpoint/checkpoints.h"
#include "matching/experiment/yaml_document.h"
#include "matching/map_file/deformation_file.h"
#include "matching/output/summary.h"
#include "matching/output/written_files.h"
#include "matching/pairs/landmark_file.h"
#include "matching/result/correspondence.h"

#include <sys/mman.h>
#include <unistd.h>
#include <zlib.h>

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <string>
#include <string_view>

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t max_size);

namespace shellmatch {
namespace {

std::string_view target_name() {
  const char* name = std::getenv("SHELLMATCH_FUZZ_TARGET");
  if (name == nullptr) std::abort();
  return name;
}

const std::string_view target = target_name();

// A file in memory, for readers that take a path.
class MemoryFile {
 public:
  explicit MemoryFile(std::string_view bytes) : fd_(memfd_create("input", 0)) {
    if (fd_ < 0 || write(fd_, bytes.data(), bytes.size()) != static_cast<ssize_t>(bytes.size())) std::abort();
  }
  ~MemoryFile() { close(fd_); }
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;
  std::string path() const { return fmt::format("/proc/self/fd/{}", fd_); }

 private:
  int fd_;
};

void demand(bool holds) {
  if (!holds) std::abort();
}

// What every reader of a mesh promises (geometry/io/read_mesh_formats.h).
template <int Dim>
void check_shape(const OriginalShape<Dim>& shape) {
  for (const Vec<Dim>& x : shape.vertices) demand(x.allFinite());
  for (const auto& polygon : shape.polygons)
    for (const Index v : polygon) demand(v >= 0 && static_cast<std::size_t>(v) < shape.vertices.size());
  for (const VertexAttribute& a : shape.attributes) demand(a.values.size() == shape.vertices.size());
}

void check_image(const GreyImage& image) {
  demand(image.values.size() == static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height));
  std::vector<std::string> notes;
  if (image.values.size() < 100000) check_shape(mask_rings(image, "input", notes));
}

// Some of the options of an experiment, of all kinds.
struct Some {
  bool flag = false;
  int number = 1;
  double value = 0.5;
  std::string text;
  std::vector<double> list;
  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    visit("flag", self.flag, {.meaning = "a flag"});
    visit("number", self.number, {.min = 0, .max = 9, .meaning = "a number"});
    visit("value", self.value, {.min = 0, .meaning = "a value"});
    visit("text", self.text, {.meaning = "a text"});
    visit("list", self.list, {.meaning = "a list"});
  }
};
struct Options {
  int version = 1;
  Some some;
  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    visit("version", self.version, {.min = 1, .meaning = "a version"});
    visit("some", self.some, {.meaning = "a section"});
  }
};

template <int Dim>
void read_map(std::string_view bytes) {
  const Deformation<Dim> map = parse_deformation<Dim>("input", std::string(bytes));
  demand(map.phi.size() == static_cast<std::size_t>(map.grid.n_nodes()));
  for (const Vec<Dim>& x : map.phi) demand(x.allFinite());
}

void read(std::string_view bytes) {
  if (target == "obj") check_shape(read_obj("input", bytes).shape);
  if (target == "off") check_shape(read_off("input", bytes).shape);
  if (target == "ply") check_shape(read_ply("input", bytes).shape);
  if (target == "stl") check_shape(read_stl("input", bytes).shape);
  if (target == "points2") check_shape(read_points<2>("input", bytes, true));
  if (target == "points3") check_shape(read_points<3>("input", bytes, false));
  if (target == "png") check_image(read_png("input", bytes));
  if (target == "pgm") check_image(read_pgm("input", bytes));
  if (target == "map") {
    if (!bytes.empty() && bytes.back() % 2 == 0) read_map<2>(bytes);
    else read_map<3>(bytes);
  }
  if (target == "yaml") {
    YamlDocument document = YamlDocument::from_text(std::string(bytes), "input");
    document.tree().flow_text();
    Options options;
    document.fill(option_tree(options));
  }
  if (target == "summary") read_summary(MemoryFile(bytes).path());
  if (target == "manifest") read_manifest(MemoryFile(bytes).path());
  if (target == "files") parse_file_list(MemoryFile(bytes).path());
  if (target == "landmarks") {
    const MemoryFile file(bytes);
    LandmarkOptions options;
    options.file = file.path();
    const std::vector<Vec<3>> vertices(9, Vec<3>(0.1, 0.2, 0.3));
    for (const Landmark<3>& landmark : read_landmarks<3>(options, vertices, vertices))
      demand(landmark.on_reference.allFinite() && landmark.on_template.allFinite() && landmark.weight > 0);
  }
  if (target == "correspondence") {
    const MemoryFile file(bytes);
    for (const auto& [index, x] : read_correspondence<3>(file.path(), 9)) demand(index >= 0 && index < 9 && x.allFinite());
  }
}

}  // namespace
}  // namespace shellmatch

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  // A copy of exactly this size: nothing beyond the end may be read.
  const std::string bytes(reinterpret_cast<const char*>(data), size);
  try {
    shellmatch::read(bytes);
  } catch (const shellmatch::InputError&) {
  }
  return 0;
}

// The checksums of PNG's chunks are set right after each change, or every change would be refused for its checksum.
extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t max_size, unsigned) {
  size = LLVMFuzzerMutate(data, size, max_size);
  if (shellmatch::target != "png") return size;
  for (std::size_t at = 8; at + 12 <= size;) {
    const std::size_t length = std::size_t{data[at]} << 24 | std::size_t{data[at + 1]} << 16 | std::size_t{data[at + 2]} << 8 | data[at + 3];
    if (length > size - at - 12) break;
    const auto crc = static_cast<std::uint32_t>(crc32(0, data + at + 4, static_cast<uInt>(length + 4)));
    for (int k = 0; k < 4; ++k) data[at + 8 + length + k] = static_cast<std::uint8_t>(crc >> (24 - 8 * k));
    at += length + 12;
  }
  return size;
}

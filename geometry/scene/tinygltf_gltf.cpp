// glTF: "glTF 2.0 Specification", Khronos 2021, chapters 3.5 to 3.7 (scenes, buffers, meshes). tinygltf reads the file,
// what its accessors name is fetched here, with every place checked against the bytes that are there.
#include "base/printable.h"
#include "geometry/scene/scene_shape.h"

#include <tiny_gltf.h>

#include <Eigen/Geometry>

#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <numeric>

namespace shellmatch {

namespace {

// Files beside the scene. tinygltf looks in the current folder, too, and takes folders and devices for files.
bool is_file_beside(const std::string& path, void* folder) {
  std::error_code error;
  return path.starts_with(*static_cast<const std::string*>(folder)) && std::filesystem::is_regular_file(path, error);
}
bool read_file_beside(std::vector<unsigned char>* bytes, std::string* error, const std::string& path, void*) {
  std::ifstream stream(path, std::ios::binary);
  bytes->assign(std::istreambuf_iterator<char>(stream), {});
  if (!stream.good()) *error = "cannot be read";
  return stream.good();
}

[[maybe_unused]] bool size_of_file_beside(std::size_t* n_bytes, std::string* error, const std::string& path, void*) {
  std::error_code code;
  *n_bytes = std::filesystem::file_size(path, code);
  if (code) *error = "cannot be read";
  return !code;
}

// tinygltf 2.9 also asks for sizes, and takes its own functions where one is missing.
template <class Callbacks>
Callbacks files_beside(std::string* folder) {
  Callbacks files{};
  files.FileExists = is_file_beside;
  files.ExpandFilePath = tinygltf::ExpandFilePath;
  files.ReadWholeFile = read_file_beside;
  files.WriteWholeFile = tinygltf::WriteWholeFile;
  if constexpr (requires { files.GetFileSizeInBytes; }) files.GetFileSizeInBytes = size_of_file_beside;
  files.user_data = folder;
  return files;
}

class GltfReader {
 public:
  GltfReader(const std::string& path, std::string_view bytes) : path_(path), shape_(path) {
    if (bytes.size() > std::numeric_limits<unsigned>::max())
      throw_input_error("{}: glTF of more than 4 GB; export a part of the scene", path);
    tinygltf::TinyGLTF loader;
    loader.SetImageLoader([](auto...) { return true; }, nullptr);  // textures are not looked at
    std::string error, warning;
    std::string folder = std::filesystem::path(path).parent_path().string();
    loader.SetFsCallbacks(files_beside<tinygltf::FsCallbacks>(&folder));
    const auto n = static_cast<unsigned>(bytes.size());
    const bool is_read =
        bytes.starts_with("glTF")
            ? loader.LoadBinaryFromMemory(&model_, &error, &warning,
                                          reinterpret_cast<const unsigned char*>(bytes.data()), n, folder)
            : loader.LoadASCIIFromString(&model_, &error, &warning, bytes.data(), n, folder);
    while (error.ends_with('\n')) error.pop_back();
    if (!is_read)
      throw_input_error("{}: cannot be read as glTF ({}); export it again as .glb", path, printable(error, 200));
    for (const std::string& name : model_.extensionsRequired)
      if (name == "KHR_draco_mesh_compression" || name == "EXT_meshopt_compression")
        throw_input_error("{}: its meshes are compressed ({}); export it without compression", path, name);
  }

  MeshFile read() && {
    for (const int root : roots()) add_node(root, {}, 0);
    return std::move(shape_).finish({1000, "metre", UpAxis::y});
  }

 private:
  template <class T>
  const T& at(const std::vector<T>& list, int i, std::string_view what) const {
    if (i < 0 || static_cast<std::size_t>(i) >= list.size())
      throw_input_error("{}: refers to {} {}, which is not in it; the file is damaged", path_, what, i);
    return list[static_cast<std::size_t>(i)];
  }

  // The nodes of the scene to show or, without scenes, those that are nobody's child.
  std::vector<int> roots() const {
    if (!model_.scenes.empty()) return at(model_.scenes, std::max(0, model_.defaultScene), "scene").nodes;
    std::vector<int> found(model_.nodes.size());
    std::iota(found.begin(), found.end(), 0);
    for (const tinygltf::Node& node : model_.nodes)
      for (const int child : node.children) std::erase(found, child);
    return found;
  }

  static Affine place_of(const tinygltf::Node& node) {
    Affine place;
    if (node.matrix.size() == 16) {
      const Eigen::Map<const Eigen::Matrix4d> m(node.matrix.data());
      place.linear = m.topLeftCorner<3, 3>();
      place.offset = m.topRightCorner<3, 1>();
      return place;
    }
    if (node.scale.size() == 3) place.linear = Eigen::Map<const Vec<3>>(node.scale.data()).asDiagonal();
    if (node.rotation.size() == 4) {
      const Eigen::Quaterniond turn(node.rotation[3], node.rotation[0], node.rotation[1], node.rotation[2]);
      if (turn.norm() > 0) place.linear = turn.normalized().toRotationMatrix() * place.linear;
    }
    if (node.translation.size() == 3) place.offset = Eigen::Map<const Vec<3>>(node.translation.data());
    return place;
  }

  void add_node(int index, const Affine& parent, int depth) {
    if (depth > deepest_node)
      throw_input_error("{}: nodes within nodes more than {} deep; flatten the scene", path_, deepest_node);
    // Children with several parents, which the specification forbids, grow as powers.
    if (++n_nodes_ > 100000) throw_input_error("{}: more than 100000 nodes; export a part of the scene", path_);
    const tinygltf::Node& node = at(model_.nodes, index, "node");
    const Affine place = parent * place_of(node);
    if (node.mesh >= 0) add_mesh(at(model_.meshes, node.mesh, "mesh"), place);
    if (node.skin >= 0) shape_.note("taken in the pose of its mesh: that of its bones is not applied");
    for (const int child : node.children) add_node(child, place, depth + 1);
  }

  void add_mesh(const tinygltf::Mesh& mesh, const Affine& place) {
    for (const tinygltf::Primitive& part : mesh.primitives) {
      const auto position = part.attributes.find("POSITION");
      if (position == part.attributes.end()) continue;
      if (part.mode >= 0 && part.mode < TINYGLTF_MODE_TRIANGLES) {
        shape_.note("its points and lines are ignored");
        continue;
      }
      if (!part.targets.empty()) shape_.note("taken without its morph targets");
      const std::vector<Vec<3>> vertices = vertices_of(at(model_.accessors, position->second, "accessor"));
      shape_.add(place, vertices, triangles_of(part, vertices.size()));
    }
  }

  // The n entries of an accessor, each of `stride` bytes of which the first `size` count.
  struct Entries {
    const unsigned char* data = nullptr;
    std::size_t n = 0, stride = 0;
    const unsigned char* operator[](std::size_t i) const { return data + i * stride; }
  };
  Entries entries(int view_index, std::size_t offset, std::size_t n, std::size_t size) const {
    const tinygltf::BufferView& view = at(model_.bufferViews, view_index, "buffer view");
    const std::vector<unsigned char>& bytes = at(model_.buffers, view.buffer, "buffer").data;
    const std::size_t stride = view.byteStride == 0 ? size : view.byteStride;
    const bool is_inside = view.byteOffset <= bytes.size() && view.byteLength <= bytes.size() - view.byteOffset &&
                           offset <= view.byteLength;
    const std::size_t room = is_inside ? view.byteLength - offset : 0;
    if (!is_inside || (n > 0 && (room < size || (n - 1) > (room - size) / stride)))
      throw_input_error("{}: {} numbers are declared, which are not there; the file is damaged or was cut off", path_,
                        n);
    return {bytes.data() + view.byteOffset + offset, n, stride};
  }

  std::size_t bytes_of(int type) const {
    const int n = tinygltf::GetComponentSizeInBytes(static_cast<unsigned>(type));
    if (n <= 0) throw_input_error("{}: numbers of an unknown type ({}); the file is damaged", path_, type);
    return static_cast<std::size_t>(n);
  }

  template <class T>
  static T load(const unsigned char* bytes) {
    T value;
    std::memcpy(&value, bytes, sizeof(T));
    return value;
  }

  // Normalized integers: section 3.6.2.2.
  double component(const unsigned char* bytes, int type, bool normalized) const {
    const auto of = [&]<class T>(T value) {
      return normalized ? std::max(-1.0, static_cast<double>(value) / std::numeric_limits<T>::max())
                        : static_cast<double>(value);
    };
    if (type == TINYGLTF_COMPONENT_TYPE_FLOAT) return load<float>(bytes);
    if (type == TINYGLTF_COMPONENT_TYPE_BYTE) return of(load<std::int8_t>(bytes));
    if (type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE) return of(load<std::uint8_t>(bytes));
    if (type == TINYGLTF_COMPONENT_TYPE_SHORT) return of(load<std::int16_t>(bytes));
    if (type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT) return of(load<std::uint16_t>(bytes));
    throw_input_error("{}: positions of an unknown type ({}); the file is damaged", path_, type);
  }

  std::size_t index_at(const unsigned char* bytes, int type) const {
    if (type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE) return load<std::uint8_t>(bytes);
    if (type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT) return load<std::uint16_t>(bytes);
    if (type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT) return load<std::uint32_t>(bytes);
    throw_input_error("{}: indices of an unknown type ({}); the file is damaged", path_, type);
  }

  std::vector<Vec<3>> vertices_of(const tinygltf::Accessor& accessor) const {
    if (accessor.type != TINYGLTF_TYPE_VEC3)
      throw_input_error("{}: positions that have not three coordinates; the file is damaged", path_);
    const std::size_t size = bytes_of(accessor.componentType);
    const auto vertex = [&](const unsigned char* bytes) {
      Vec<3> x;
      for (std::size_t k = 0; k < 3; ++k)
        x[static_cast<Eigen::Index>(k)] = component(bytes + k * size, accessor.componentType, accessor.normalized);
      return x;
    };
    std::vector<Vec<3>> vertices;
    if (accessor.bufferView >= 0) {
      const Entries all = entries(accessor.bufferView, accessor.byteOffset, accessor.count, 3 * size);
      vertices.reserve(all.n);
      for (std::size_t i = 0; i < all.n; ++i) vertices.push_back(vertex(all[i]));
    } else {
      // Zeros, of which a sparse list replaces some: bounded, since they take no bytes of the file.
      std::size_t most = 0;
      for (const tinygltf::Buffer& buffer : model_.buffers) most += buffer.data.size();
      if (accessor.count > most)
        throw_input_error("{}: {} positions are declared, which are not there; the file is damaged", path_,
                          accessor.count);
      vertices.assign(accessor.count, Vec<3>::Zero());
    }
    if (accessor.sparse.isSparse) replace(accessor, vertex, 3 * size, vertices);
    return vertices;
  }

  template <class Vertex>
  void replace(const tinygltf::Accessor& accessor, Vertex&& vertex, std::size_t size,
               std::vector<Vec<3>>& vertices) const {
    const auto& sparse = accessor.sparse;
    if (sparse.count < 0 || sparse.indices.byteOffset < 0 || sparse.values.byteOffset < 0)
      throw_input_error("{}: a sparse list with a count below 0; the file is damaged", path_);
    const auto n = static_cast<std::size_t>(sparse.count);
    const Entries places = entries(sparse.indices.bufferView, static_cast<std::size_t>(sparse.indices.byteOffset), n,
                                   bytes_of(sparse.indices.componentType));
    const Entries values =
        entries(sparse.values.bufferView, static_cast<std::size_t>(sparse.values.byteOffset), n, size);
    for (std::size_t i = 0; i < n; ++i) {
      const std::size_t place = index_at(places[i], sparse.indices.componentType);
      if (place >= vertices.size())
        throw_input_error("{}: a sparse list replaces position {} of {}; the file is damaged", path_, place,
                          vertices.size());
      vertices[place] = vertex(values[i]);
    }
  }

  std::vector<std::vector<Index>> triangles_of(const tinygltf::Primitive& part, std::size_t n_vertices) const {
    std::vector<Index> corners;
    if (part.indices >= 0) {
      const tinygltf::Accessor& accessor = at(model_.accessors, part.indices, "accessor");
      const Entries all =
          entries(accessor.bufferView, accessor.byteOffset, accessor.count, bytes_of(accessor.componentType));
      for (std::size_t i = 0; i < all.n; ++i) {
        const std::size_t v = index_at(all[i], accessor.componentType);
        corners.push_back(v < n_vertices ? static_cast<Index>(v) : no_index);
      }
    } else {
      corners.resize(n_vertices);
      std::iota(corners.begin(), corners.end(), Index{0});
    }
    std::vector<std::vector<Index>> triangles;
    const bool is_strip = part.mode == TINYGLTF_MODE_TRIANGLE_STRIP, is_fan = part.mode == TINYGLTF_MODE_TRIANGLE_FAN;
    for (std::size_t i = 2; i < corners.size(); i += is_strip || is_fan ? 1 : 3) {
      if (is_fan) triangles.push_back({corners[0], corners[i - 1], corners[i]});
      else if (is_strip && i % 2 == 1) triangles.push_back({corners[i - 1], corners[i - 2], corners[i]});
      else triangles.push_back({corners[i - 2], corners[i - 1], corners[i]});
    }
    return triangles;
  }

  const std::string& path_;
  tinygltf::Model model_;
  std::size_t n_nodes_ = 0;
  SceneShape shape_;
};

}  // namespace

MeshFile read_gltf(const std::string& path, std::string_view bytes) { return GltfReader(path, bytes).read(); }

}  // namespace shellmatch

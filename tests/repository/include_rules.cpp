#include "tests/repository/include_rules.h"

#include "tests/repository/includes.h"

#include <fmt/format.h>

#include <algorithm>

namespace shellmatch::repository {

namespace {

// A library, how its includes begin, and the files that are its adapter.
struct Adapter {
  std::string_view library;
  std::vector<std::string_view> begins;
  std::vector<std::string_view> files;
};

const std::vector<Adapter>& adapter_table() {
  static const std::vector<Adapter> table = {
      // The dual numbers and cost functions alone, without the solvers; hence before the entry for the rest of Ceres;
      // so is the checker.
      {"Ceres' dual numbers", {"ceres/jet.h"}, {"energies/*/*", "solvers/libraries/ceres_*.cpp"}},
      {"Ceres' cost functions",
       {"ceres/autodiff_cost_function.h", "ceres/cost_function.h", "ceres/loss_function.h"},
       {"energies/cost/*"}},
      {"Ceres' problems",
       {"ceres/first_order_function.h", "ceres/problem.h"},
       {"energies/assembly/ceres_problem.*", "solvers/libraries/ceres_*.cpp"}},
      {"Ceres' gradient checker",
       {"ceres/gradient_checker.h", "ceres/dynamic_numeric_diff_cost_function.h"},
       {"matching/derivative_check/ceres_checker.cpp"}},
      {"Ceres", {"ceres/", "glog/"}, {"solvers/libraries/ceres_*.cpp", "alignment/bend/ceres_*.cpp"}},
      {"the compiler's names for instructions", {"immintrin.h"}, {"base/registers.h"}},
      {"CHOLMOD", {"cholmod"}, {"solvers/metric/cholmod_*.cpp"}},
      {"CGAL", {"CGAL/"}, {"geometry/*/cgal_*.cpp", "geometry/*/cgal_*.h"}},
      {"Boost", {"boost/"}, {"grid/inverse/boost_*.cpp"}},
      {"VTK", {"vtk"}, {"*/*/vtk_*.cpp"}},
      {"ITK", {"itk"}, {}},
      {"pybind11", {"pybind11/"}, {"python/bindings/*"}},
      {"NLopt", {"nlopt"}, {"solvers/libraries/nlopt_*.cpp"}},
      {"yaml-cpp", {"yaml-cpp/"}, {"matching/experiment/yaml_*.cpp"}},
      {"nlohmann json",
       {"nlohmann/"},
       {"geometry/outline/json_*.cpp", "matching/*/*json*.cpp", "matching/*/json_*.h", "apps/studies/*/json_*.cpp",
        "apps/cohorts/*/json_*.cpp"}},
      {"Embree", {"embree"}, {"matching/render/surfaces/*.cpp"}},
      {"libpng", {"png.h"}, {"geometry/picture/png_*.cpp"}},
      {"libtiff", {"tiff"}, {"geometry/picture/tiff_*.cpp"}},
      {"libjpeg-turbo", {"turbojpeg", "jpeglib"}, {"geometry/picture/jpeg_*.cpp"}},
      {"libdeflate", {"libdeflate"}, {"matching/map_file/libdeflate_*.cpp"}},
      {"zlib", {"zlib"}, {"geometry/bytes/zlib_*.cpp", "geometry/volume/zlib_*.cpp"}},
      {"assimp", {"assimp/"}, {}},
      {"tinygltf", {"tiny_gltf.h"}, {"geometry/scene/tinygltf_*.cpp"}},
      {"pugixml", {"pugixml"}, {"geometry/scene/pugixml_*", "geometry/outline/pugixml_*"}},
      {"xxHash", {"xxhash"}, {"matching/output/xxhash_*.cpp"}},
      {"Cairo", {"cairo"}, {"matching/render/canvas/*.cpp"}},
      {"Fontconfig", {"fontconfig/"}, {"matching/render/canvas/fontconfig_*.cpp"}},
      {"libwebp", {"webp/"}, {"matching/render/canvas/webp_*.cpp"}},
      {"oneTBB", {"tbb/", "oneapi/"}, {"base/parallel.cpp"}},
      {"CLI11", {"CLI/"}, {"apps/command_line/*.cpp"}},
      {"nanoflann", {"nanoflann"}, {"grid/fits/nanoflann_*.cpp"}},
      {"fmt", {"fmt/"}, {"base/error.h", "*/*.cpp", "*/*/*.cpp", "*/*/*/*.cpp"}},
      {"Google Benchmark", {"benchmark/"}, {"tests/bench/*.cpp"}},
      {"GoogleTest", {"gtest/", "gmock/"}, {}},
      {"Spectra", {"Spectra/"}, {"alignment/spectrum/spectra_*.cpp"}},
      {"Eigen", {"Eigen/"}, {"*/*.h", "*/*.cpp", "*/*/*.h", "*/*/*.cpp", "*/*/*/*.h", "*/*/*/*.cpp"}},
      {"the operating system", {"sys/"}, {"*/*.cpp", "*/*/*.cpp", "*/*/*/*.cpp"}}};
  return table;
}

// Headers that the sources of one adapter share among themselves. They do show the library's types.
bool is_private_header(std::string_view file) {
  return matches(file, "geometry/*/cgal_*.h") || matches(file, "geometry/*/pugixml_*.h") ||
         matches(file, "matching/*/json_*.h") || matches(file, "apps/studies/*/json_*.h") ||
         matches(file, "apps/cohorts/*/json_*.h");
}

std::string file_as_header(std::string_view file) { return std::string(file.substr(0, file.rfind('.'))) + ".h"; }

}  // namespace

std::vector<Finding> check_include_direction(const SourceTree& tree) {
  std::vector<Finding> findings;
  for (const Include& include : includes_of(tree)) {
    const std::string &file = include.file, &path = include.path;
    const int line = include.line;
    const auto rule = folder_table().find(top_folder(file));
    if (!include.quoted || rule == folder_table().end()) continue;
    const std::string_view to = top_folder(path);
    if (!folder_table().contains(to)) {
      findings.push_back({file, line, fmt::format("\"{}\" is not written from the repository root", path)});
    } else if (std::find(rule->second.begin(), rule->second.end(), to) == rule->second.end()) {
      findings.push_back({file, line, fmt::format("{}/ may not include {}/ (\"{}\")", rule->first, to, path)});
    } else if (!tree.files.contains(path)) {
      findings.push_back({file, line, fmt::format("\"{}\" does not exist", path)});
    }
  }
  return findings;
}

std::vector<Finding> check_adapters(const SourceTree& tree) {
  std::vector<Finding> findings;
  for (const Include& include : includes_of(tree)) {
    const std::string &file = include.file, &path = include.path;
    const int line = include.line;
    const std::string_view folder = top_folder(file);
    if (folder == "tests" || folder == "docs/examples" || !folder_table().contains(folder)) continue;
    if (include.quoted) {
      if (is_private_header(path) && !is_private_header(file) && !is_private_header(file_as_header(file)) &&
          !matches(file, "matching/*/*json*.cpp"))
        findings.push_back(
            {file, line, fmt::format("\"{}\" shows a library's types: only its adapter may include it", path)});
      continue;
    }
    const auto adapter = std::find_if(adapter_table().begin(), adapter_table().end(), [&](const Adapter& a) {
      return std::any_of(a.begins.begin(), a.begins.end(), [&](auto b) { return path.starts_with(b); });
    });
    if (adapter != adapter_table().end()) {
      if (std::none_of(adapter->files.begin(), adapter->files.end(), [&](auto p) { return matches(file, p); }))
        findings.push_back(
            {file, line, fmt::format("<{}>: only the adapter of {} may include it", path, adapter->library)});
      continue;
    }
    // What is left has to be the standard library: in headers without a suffix, in sources also C's headers
    // and those of the operating system and the processor.
    const bool standard = path.find('/') == std::string::npos &&
                          (path.find('.') == std::string::npos || (file.ends_with(".cpp") && path.ends_with(".h")));
    if (!standard)
      findings.push_back({file, line, fmt::format("<{}>: a library without an adapter in include_rules.cpp", path)});
  }
  return findings;
}

}  // namespace shellmatch::repository

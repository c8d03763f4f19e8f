// How far a correspondence is from a known one: figures as JSON.
//
//   correspondence_error REFERENCE TEMPLATE RESULT [--vts REFERENCE.vts TEMPLATE.vts] [--euclidean] [--first-index 0|1]
//                        [--errors FILE]
//
// RESULT: a mesh (OBJ, OFF, PLY) with the vertices of the reference, in their order, moved to the template; or text
// (any other ending) with a vertex of the template, counted from --first-index (1), for each vertex of the reference;
// or the word `identity`. Line k of both .vts files is the vertex, counted from 1, that corresponds to line k of the
// other; without them vertex i of one mesh corresponds to vertex i of the other.
//
// Errors are lengths of paths along the template's edges from the vertex nearest to where a vertex ends to the one
// where it belongs, times 100 over the root of the template's area; with --euclidean distances in diagonals of the
// template's bounding box. Printed: number of points; mean, 95 % quantile, greatest error; share beyond 10 (0.1
// diagonals); points that end on another component than they belong to, which the other figures leave out. --errors
// writes all errors, one a line.

#include "tests/studies/correspondence/errors.h"
#include "base/error.h"
#include "geometry/distance/surface_distance.h"
#include "geometry/io/read_shape.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <exception>
#include <fstream>
#include <string>
#include <vector>

using namespace shellmatch;

namespace {

struct Arguments {
  std::vector<std::string> files, ids;
  std::string errors;
  bool euclidean = false;
  Index first_index = 1;
};

Arguments parse(const std::vector<std::string>& words) {
  Arguments arguments;
  for (std::size_t i = 0; i < words.size(); ++i) {
    const std::string& option = words[i];
    const auto next = [&] {
      if (i + 1 == words.size()) throw_input_error("{}: a value is missing", option);
      return words[++i];
    };
    if (option == "--vts") {
      arguments.ids = {next()};
      arguments.ids.push_back(next());
    } else if (option == "--euclidean") {
      arguments.euclidean = true;
    } else if (option == "--first-index") {
      const std::string value = next();
      if (value != "0" && value != "1") throw_input_error("--first-index {}: expected 0 or 1", value);
      arguments.first_index = value == "0" ? 0 : 1;
    } else if (option == "--errors") {
      arguments.errors = next();
    } else if (option.starts_with("--")) {
      throw_input_error("there is no option {}", option);
    } else {
      arguments.files.push_back(option);
    }
  }
  if (arguments.files.size() != 3)
    throw_input_error(
        "expected three files: REFERENCE TEMPLATE RESULT [--vts REFERENCE.vts TEMPLATE.vts] [--euclidean] "
        "[--first-index 0|1] [--errors FILE]");
  return arguments;
}

/// Vertices of a mesh with n, counted from `first` in the file.
std::vector<Index> read_indices(const std::string& path, Index first, std::size_t n) {
  std::ifstream in(path);
  if (!in) throw_input_error("{}: cannot be read", path);
  std::vector<Index> indices;
  for (std::string word; in >> word;) {
    long long index = -1;
    std::size_t end = 0;
    try {
      index = std::stoll(word, &end);
    } catch (const std::exception&) {
    }
    if (end != word.size() || index < first || index >= first + static_cast<long long>(n))
      throw_input_error("{}: entry {}: '{}' is no vertex; expected a number from {} to {}", path, indices.size() + 1,
                        word, first, first + static_cast<long long>(n) - 1);
    indices.push_back(static_cast<Index>(index) - first);
  }
  return indices;
}

bool is_mesh(const std::string& path) {
  return std::ranges::any_of(std::array{".obj", ".off", ".ply"},
                             [&](const char* ending) { return path.ends_with(ending); });
}

template <class T>
std::vector<T> at(const std::vector<T>& all, const std::vector<Index>& places) {
  std::vector<T> chosen;
  for (const Index i : places) chosen.push_back(all[i]);
  return chosen;
}

std::vector<double> errors_of(const Arguments& arguments) {
  const std::string& result = arguments.files[2];
  const Surface<3> reference = read_triangles(arguments.files[0]), target = read_triangles(arguments.files[1]);
  const std::size_t n = reference.vertices.size();
  std::vector<Index> from, belong;
  if (arguments.ids.empty()) {
    if (n != target.vertices.size())
      throw_input_error("{} has {} vertices and {} has {}: without --vts they must correspond one by one",
                        arguments.files[0], n, arguments.files[1], target.vertices.size());
    for (std::size_t v = 0; v < n; ++v) from.push_back(static_cast<Index>(v));
    belong = from;
  } else {
    from = read_indices(arguments.ids[0], 1, n);
    belong = read_indices(arguments.ids[1], 1, target.vertices.size());
    if (from.size() != belong.size())
      throw_input_error("{} has {} lines and {} has {}", arguments.ids[0], from.size(), arguments.ids[1],
                        belong.size());
  }
  if (from.empty())
    throw_input_error("{}: names no vertex", arguments.ids.empty() ? arguments.files[0] : arguments.ids[0]);

  const bool is_map = result != "identity" && !is_mesh(result);
  const std::vector<Index> map =
      is_map ? read_indices(result, arguments.first_index, target.vertices.size()) : std::vector<Index>();
  const std::vector<Vec<3>> moved = is_map                 ? at(target.vertices, map)
                                    : result == "identity" ? reference.vertices
                                                           : read_triangles(result).vertices;
  if (moved.size() != n) throw_input_error("{} is for {} vertices; the reference has {}", result, moved.size(), n);

  if (arguments.euclidean) return euclidean_errors(target.vertices, at(moved, from), belong);
  std::vector<double> errors =
      geodesic_errors(target, is_map ? at(map, from) : nearest_vertices(target.vertices, at(moved, from)), belong);
  for (double& e : errors) e *= 100;
  return errors;
}

}  // namespace

int main(int argc, char** argv) try {
  const Arguments arguments = parse({argv + 1, argv + argc});
  std::vector<double> errors = errors_of(arguments);
  if (!arguments.errors.empty()) {
    std::ofstream out(arguments.errors);
    for (const double e : errors) out << fmt::format("{}\n", e);
    if (!out.flush()) throw_environment_error("{}: cannot be written", arguments.errors);
  }
  const std::size_t n = errors.size();
  std::erase_if(errors, [](double e) { return !std::isfinite(e); });
  if (errors.empty())
    throw_input_error("{}: every point ends on another component than it belongs to", arguments.files[2]);
  const double limit = arguments.euclidean ? 0.1 : 10;
  const auto n_beyond = std::ranges::count_if(errors, [&](double e) { return e > limit; });
  const DistanceStatistics figures = statistics(errors);
  fmt::print("{{\"points\": {}, \"mean\": {}, \"p95\": {}, \"max\": {}, \"beyond\": {}, \"unreachable\": {}}}\n", n,
             figures.mean, figures.p95, figures.max, static_cast<double>(n_beyond) / static_cast<double>(errors.size()),
             n - errors.size());
  return 0;
} catch (const InputError& error) {
  fmt::print(stderr, "correspondence_error: {}\n", error.what());
  return 2;
} catch (const std::exception& error) {
  fmt::print(stderr, "correspondence_error: {}\n", error.what());
  return 1;
}

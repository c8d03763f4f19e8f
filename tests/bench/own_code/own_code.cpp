// What is written here although a library does it, held against the library: speed, memory, results and what damaged
// files do. Prints the tables of docs/decisions.md; a minute or two. Each trial is a process of its own, ours and the
// libraries' in turn; seconds are CPU seconds of one thread, medians.
//
// Usage: own_code [ROUNDS]        5 if not given

#include "base/error.h"
#include "base/replace_file.h"
#include "tests/bench/own_code/alternatives.h"
#include "tests/bench/own_code/trial.h"
#include "geometry/distance/facet_tree.h"
#include "geometry/distance/signed_distance.h"
#include "geometry/generate/generate_shape.h"
#include "geometry/mesh_text/read_mesh_formats.h"
#include "geometry/mesh_text/read_text.h"
#include "geometry/io/write_shape.h"
#include "geometry/surface/facet_point.h"
#include "grid/fields/sample.h"
#include "grid/octree/surface_cells.h"

#include <fmt/core.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <random>

namespace shellmatch::own_code {

Distance facet_tree_distance(const Surface<3>& surface) {
  const auto tree = std::make_shared<FacetTree<3>>(surface);
  return [tree, &surface](const Vec<3>& x) {
    return (closest_point_on_facet<3>(surface, tree->nearest(x), x).point - x).norm();
  };
}

namespace {

int n_rounds = 5;

double median(std::vector<double> values) {
  std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2), values.end());
  return values[values.size() / 2];
}

struct Alternative {
  const char* name;
  std::function<void(Trial&)> work;
};

// Medians over the rounds, all alternatives in turn; `found` is that of the last round.
std::vector<Trial> in_turn(const std::vector<Alternative>& all) {
  std::vector<std::vector<Trial>> trials(all.size());
  for (int round = 0; round < n_rounds; ++round)
    for (std::size_t i = 0; i < all.size(); ++i) trials[i].push_back(run_trial(all[i].work));
  std::vector<Trial> result;
  for (const auto& of_one : trials) {
    result.push_back(of_one.back());
    const auto median_of = [&](const auto& member) {
      std::vector<double> values;
      for (const Trial& t : of_one) values.push_back(member(t));
      return median(values);
    };
    for (int k = 0; k < 2; ++k) result.back().seconds[k] = median_of([k](const Trial& t) { return t.seconds[k]; });
    result.back().megabytes = median_of([](const Trial& t) { return t.megabytes; });
  }
  return result;
}

Surface<3> triangles_of(const OriginalShape<3>& original) {
  Surface<3> surface{original.vertices, {}};
  for (const auto& p : original.polygons)
    for (std::size_t k = 2; k < p.size(); ++k) surface.facets.push_back({p[0], p[k - 1], p[k]});
  return surface;
}

// The nodes of the grid that a run would have on this level, in their order.
std::vector<Vec<3>> grid_nodes(const Surface<3>& surface, int finest) {
  const SignedDistance<3> distance(surface);
  Octree<3> grid(3);
  for (int level = 3; level < finest; ++level) {
    const auto nodal = sample_nodes<3>(grid, std::cref(distance));
    grid.refine([&](Index leaf) { return meets_surface<3>(grid, nodal, std::cref(distance), leaf); });
  }
  std::vector<Vec<3>> nodes;
  for (const Index n : grid.free_nodes()) nodes.push_back(grid.node_position(n));
  return nodes;
}

void compare_distances(const Surface<3>& surface) {
  const std::vector<Vec<3>> points = grid_nodes(surface, 7);
  std::vector<double> expected;
  {
    const Distance own = facet_tree_distance(surface);
    for (const Vec<3>& x : points) expected.push_back(own(x));
  }
  const auto trial_of = [&](const std::function<Distance(const Surface<3>&)>& make) {
    return [&, make](Trial& t) {
      const double begin = cpu_seconds();
      const Distance distance = make(surface);
      distance(points[0]);  // some build their tree with the first question
      t.seconds[0] = cpu_seconds() - begin;
      std::vector<double> found;
      found.reserve(points.size());
      const double asked = cpu_seconds();
      for (const Vec<3>& x : points) found.push_back(distance(x));
      t.seconds[1] = cpu_seconds() - asked;
      for (std::size_t i = 0; i < points.size(); ++i)
        t.found[0] = std::max(t.found[0], std::abs(found[i] - expected[i]));
    };
  };
  const std::vector<Alternative> all{{"ours: `FacetTree`", trial_of(facet_tree_distance)},
                                     {"CGAL: `AABB_tree`", trial_of(cgal_distance)},
                                     {"Embree: `rtcPointQuery`", trial_of(embree_distance)}};
  const std::vector<Trial> trials = in_turn(all);
  fmt::print(
      "Closest points: {} triangles, {} nodes of a grid of level 7\n\n"
      "| | built, ms | one point, ns | ratio | MB | largest difference |\n|---|---|---|---|---|---|\n",
      surface.facets.size(), points.size());
  for (std::size_t i = 0; i < all.size(); ++i)
    fmt::print("| {} | {:.1f} | {:.0f} | {:.2f} | {:.1f} | {:.1g} |\n", all[i].name, 1e3 * trials[i].seconds[0],
               1e9 * trials[i].seconds[1] / static_cast<double>(points.size()),
               trials[i].seconds[1] / trials[0].seconds[1], trials[i].megabytes, trials[i].found[0]);
}

std::optional<OriginalShape<3>> own_ply(const std::string& path) {
  try {
    return read_ply(path, read_file_bytes(path)).shape;
  } catch (const InputError&) {
    return std::nullopt;
  }
}

std::optional<GreyImage> own_pgm(const std::string& path) {
  try {
    return read_pgm(path, read_file_bytes(path)).brightness;
  } catch (const InputError&) {
    return std::nullopt;
  }
}

bool same(const OriginalShape<3>& a, const OriginalShape<3>& b) {
  return a.vertices == b.vertices && a.polygons == b.polygons;
}
bool same(const GreyImage& a, const GreyImage& b) {
  return a.width == b.width && a.height == b.height && a.values == b.values;
}

// What comes of a file that is cut off, or of which bytes are altered.
struct Damage {
  int n_refused = 0, n_taken = 0, n_ended = 0;
  std::string text() const {
    return fmt::format("{} refused, {} read, {} ended the program", n_refused, n_taken, n_ended);
  }
};

template <class Reader>
Damage damage(const Reader& read, const std::string& folder, const std::string& whole, const std::string& name,
              bool cut) {
  Damage result;
  std::mt19937 random(11);
  for (int trial = 0; trial < 100; ++trial) {
    std::string bytes = cut ? whole.substr(0, random() % whole.size()) : whole;
    for (int k = 0; !cut && k < 1 + trial % 4; ++k)
      bytes[trial % 2 ? random() % std::min<std::size_t>(bytes.size(), 200) : random() % bytes.size()] =
          static_cast<char>(random());
    const std::string path = folder + "/" + name;
    replace_file(path, bytes);
    const Trial t = run_trial([&](Trial& found) { found.found[0] = read(path) ? 1 : 0; }, 20);
    if (!t.returned) ++result.n_ended;
    else ++(t.found[0] == 0 ? result.n_refused : result.n_taken);
  }
  return result;
}

template <class Thing>
struct FileReader {
  const char* name;
  std::function<std::optional<Thing>(const std::string&)> read;
};

template <class Thing>
void compare_readers(const std::string& title, const std::vector<FileReader<Thing>>& readers, const std::string& folder,
                     const std::string& large, const std::string& small) {
  const std::optional<Thing> expected = readers[0].read(large);
  std::vector<Alternative> all;
  for (const auto& reader : readers)
    all.push_back({reader.name, [&expected, &large, read = reader.read](Trial& t) {
                     const double begin = cpu_seconds();
                     const auto thing = read(large);
                     t.seconds[0] = cpu_seconds() - begin;
                     t.found[0] = thing && same(*thing, *expected) ? 1 : 0;
                   }});
  const std::vector<Trial> trials = in_turn(all);
  fmt::print(
      "\n{}, {:.1f} MB\n\n| | ms | ratio | MB | same result | cut off: of 100 | bytes altered: of 100 "
      "|\n|---|---|---|---|---|---|---|\n",
      title, 1e-6 * static_cast<double>(std::filesystem::file_size(large)));
  const std::string whole = read_file_bytes(small), name = "damaged" + file_extension(small);
  for (std::size_t i = 0; i < all.size(); ++i)
    fmt::print("| {} | {:.1f} | {:.2f} | {:.1f} | {} | {} | {} |\n", all[i].name, 1e3 * trials[i].seconds[0],
               trials[i].seconds[0] / trials[0].seconds[0], trials[i].megabytes, trials[i].found[0] == 1 ? "yes" : "no",
               damage(readers[i].read, folder, whole, name, true).text(),
               damage(readers[i].read, folder, whole, name, false).text());
}

// A disc with a wavy border, white on black.
GreyImage wavy_disc(int size) {
  GreyImage image{size, size, {}};
  for (int row = 0; row < size; ++row)
    for (int column = 0; column < size; ++column) {
      const double x = (column + 0.5) / size - 0.5, y = (row + 0.5) / size - 0.5;
      image.values.push_back(std::hypot(x, y) < 0.3 + 0.05 * std::sin(9 * std::atan2(y, x)) ? 1.0f : 0.0f);
    }
  return image;
}

std::string pgm_of(const GreyImage& image, const char* kind) {
  const std::string_view format = kind;
  std::string bytes =
      fmt::format("{}\n{} {}\n{}\n", format.substr(0, 2), image.width, image.height, format == "P5 16" ? 65535 : 255);
  for (const float v : image.values) {
    if (format == "P2") bytes += v > 0.5f ? "255\n" : "0\n";
    else bytes.append(format == "P5 16" ? 2 : 1, v > 0.5f ? '\xff' : '\0');
  }
  return bytes;
}

void compare_masks() {
  const GreyImage image = wavy_disc(1024);
  std::vector<std::string> notes;
  const OriginalShape<2> expected = mask_rings(image, "", notes);
  const std::vector<Alternative> all{
      {"ours: `mask_rings`, with rings and checks",
       [&](Trial& t) {
         std::vector<std::string> again;
         const double begin = cpu_seconds();
         const OriginalShape<2> shape = mask_rings(image, "", again);
         t.seconds[0] = cpu_seconds() - begin;
         t.found = {static_cast<double>(shape.vertices.size()), 0, 1, 0};
       }},
      {"VTK: `vtkImageGaussianSmooth`, `vtkMarchingSquares`, points without rings", [&](Trial& t) {
         const double begin = cpu_seconds();
         const std::vector<Vec<2>> points = vtk_mask_points(image, 1.0);
         t.seconds[0] = cpu_seconds() - begin;
         double worst = 0, n_same = 0;
         for (const Vec<2>& p : points) {
           double least = 1e9;
           for (const Vec<2>& q : expected.vertices) least = std::min(least, (p - q).norm());
           worst = std::max(worst, least);
           n_same += least == 0;
         }
         t.found = {static_cast<double>(points.size()), worst, n_same / static_cast<double>(points.size()), 0};
       }}};
  const std::vector<Trial> trials = in_turn(all);
  fmt::print(
      "\nBorder of a mask of 1024 x 1024 pixels\n\n| | ms | ratio | MB | points | equal to the bit | largest "
      "difference, pixels |\n|---|---|---|---|---|---|---|\n");
  for (std::size_t i = 0; i < all.size(); ++i)
    fmt::print("| {} | {:.1f} | {:.2f} | {:.1f} | {} | {:.0f} % | {:.1g} |\n", all[i].name, 1e3 * trials[i].seconds[0],
               trials[i].seconds[0] / trials[0].seconds[0], trials[i].megabytes, trials[i].found[0],
               100 * trials[i].found[2], trials[i].found[1]);
}

void compare_all() {
  const std::string folder =
      fmt::format("{}/shellmatch_own_code_{}", std::filesystem::temp_directory_path().string(), getpid());
  std::filesystem::create_directories(folder);
  const auto hand = std::get<OriginalShape<3>>(generate_shape("hand"));
  compare_distances(triangles_of(hand));

  write_shape(folder + "/hand.ply", hand);
  write_shape(folder + "/sphere.ply", std::get<OriginalShape<3>>(generate_shape("sphere")));
  compare_readers<OriginalShape<3>>(
      "Binary PLY", {{"ours: `read_ply`", own_ply}, {"CGAL: `read_PLY`", cgal_ply}, {"VTK: `vtkPLYReader`", vtk_ply}},
      folder, folder + "/hand.ply", folder + "/sphere.ply");
  const GreyImage large = wavy_disc(2048), small = wavy_disc(24);
  for (const char* kind : {"P5", "P5 16", "P2"}) {
    replace_file(folder + "/large.pgm", pgm_of(large, kind));
    replace_file(folder + "/small.pgm", pgm_of(small, kind));
    compare_readers<GreyImage>(fmt::format("PGM ({})", kind),
                               {{"ours: `read_pgm`", own_pgm}, {"VTK: `vtkPNMReader`", vtk_pgm}}, folder,
                               folder + "/large.pgm", folder + "/small.pgm");
  }
  compare_masks();
  std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace shellmatch::own_code

int main(int argc, char** argv) {
  using namespace shellmatch::own_code;
  if (argc > 1) n_rounds = std::atoi(argv[1]);
  if (argc > 2 || n_rounds < 1) {
    fmt::print(stderr, "usage: own_code [ROUNDS]\n");
    return 2;
  }
  compare_all();
}

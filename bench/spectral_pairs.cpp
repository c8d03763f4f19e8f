#include "alignment/functional_map/map_search.h"
#include "base/parallel.h"
#include "geometry/io/read_shape.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <cmath>
#include <fstream>
#include <map>
#include <optional>

using namespace shellmatch;

namespace {

Surface<3> read(const std::string& path) {
  const OriginalShape<3> original = read_points_or_mesh_3d(path);
  Surface<3> surface{original.vertices, {}};
  for (const auto& p : original.polygons) surface.facets.push_back({p[0], p[1], p[2]});
  return surface;
}

std::vector<Index> read_ids(const std::string& path) {
  std::ifstream in(path);
  std::vector<Index> ids;
  for (Index id; in >> id;) ids.push_back(id - 1);
  return ids;
}

double now() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

}  // namespace

int main(int argc, char** argv) {
  const Surface<3> a = read(argv[1]), b = read(argv[2]);
  const auto ids1 = read_ids(argv[3]), ids2 = read_ids(argv[4]);
  if (argc > 5) set_n_threads(std::atoi(argv[5]));
  AlignmentOptions options;
  const double t0 = now();
  std::optional<SpectralShape> s[2];
  for_both([&](int i) { s[i] = make_spectral_shape(i == 0 ? a : b, options); });
  const double t1 = now();
  const ShapePairSpectra pair = make_shape_pair(*s[0], *s[1]);
  const auto found = search_maps(pair, options);
  const double t2 = now();
  fmt::print("spectra {:.2f} s, search {:.2f} s\n", t1 - t0, t2 - t1);
  double area = 0;
  for (std::size_t f = 0; f < b.facets.size(); ++f) area += facet_measure(b, static_cast<Index>(f));
  const EdgeGraph graph(b);
  std::map<Index, std::vector<double>> distances;
  for (const auto& c : found) {
    double sum = 0; int bad = 0;
    std::vector<Index> image(a.vertices.size(), 0);
    for (std::size_t i = 0; i < c.matches.from[0].size(); ++i) image[c.matches.from[0][i]] = c.matches.to[0][i];
    for (std::size_t i = 0; i < ids1.size(); ++i) {
      const Index end = image[ids1[i]];
      auto& d = distances[end];
      if (d.empty()) d = graph.distances_from(end);
      const double e = 100 * d[ids2[i]] / std::sqrt(area);
      sum += e; bad += e > 10;
    }
    fmt::print("error {:.2f} beyond10 {:.1f}% | total {:.3f} | coarse f {:.3f} w {:.3f} o {:.3f} p {:.3f} | fine f {:.3f} w {:.3f} o {:.3f} p {:.3f}\n", sum / ids1.size(), 100.0 * bad / ids1.size(), c.total(),
      c.coarse_score.functions, c.coarse_score.signature, c.coarse_score.orientation, c.coarse_score.pose, c.score.functions, c.score.signature, c.score.orientation, c.score.pose);
  }
}

#include "matching/result/correspondence.h"

#include "base/error.h"
#include "base/printable.h"
#include "geometry/io/input_file.h"
#include "geometry/mesh_text/read_text.h"

#include <sstream>

namespace shellmatch {

template <int Dim>
Correspondence<Dim> read_correspondence(const std::string& path, std::size_t n_vertices) {
  const std::string bytes = InputFile(path).read();
  LineReader lines(path, bytes);
  Correspondence<Dim> list;
  while (lines.next()) {
    const std::string line(lines.line());
    const std::size_t number = lines.number();
    std::istringstream words(line);
    long index = 0;
    Vec<Dim> x;
    bool good = static_cast<bool>(words >> index);
    for (int k = 0; k < Dim; ++k) good = static_cast<bool>(words >> x[k]) && good;
    if (!good || !x.allFinite())
      throw_input_error("{}:{}: expected the index of a vertex and {} finite coordinates, found '{}'", path, number,
                        Dim, printable(line));
    if (index < 0 || static_cast<std::size_t>(index) >= n_vertices)
      throw_input_error("{}:{}: there is no vertex {}; the reference has {}, counted from 0", path, number, index,
                        n_vertices);
    list.emplace_back(static_cast<Index>(index), x);
  }
  if (list.empty()) throw_input_error("{}: holds no correspondence; expected lines 'index x y z'", path);
  return list;
}

template <int Dim>
double correspondence_error(const Correspondence<Dim>& truth, const std::vector<Vec<Dim>>& vertices) {
  double sum = 0;
  for (const auto& [i, x] : truth) sum += (vertices[i] - x).norm();
  return sum / static_cast<double>(truth.size());
}

SHELLMATCH_2D_3D(read_correspondence);
SHELLMATCH_2D_3D(correspondence_error);

}  // namespace shellmatch

#include "apps/cohorts/subjects/point_file.h"

#include "base/text.h"
#include "base/replace_file.h"
#include "geometry/mesh_text/read_text.h"

#include <fmt/format.h>

namespace shellmatch {

template <int Dim>
void write_named_points(const std::string& path, const std::vector<NamedPoint<Dim>>& points) {
  std::string text = fmt::format("{}\n", named_points_header<Dim>);
  for (const NamedPoint<Dim>& point : points) {
    text += csv_field(point.name);
    for (int k = 0; k < Dim; ++k) text += fmt::format(",{}", point.point[k]);
    text += "\n";
  }
  replace_file(path, text);
}

SHELLMATCH_2D_3D(write_named_points);

}  // namespace shellmatch

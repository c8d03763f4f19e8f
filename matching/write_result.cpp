#include "matching/write_result.h"

#include "base/error.h"
#include "base/stop.h"
#include "geometry/io/write_shape.h"
#include "matching/experiment/yaml_options.h"
#include "matching/pictures/grid_picture.h"
#include "matching/output/history_file.h"
#include "matching/pictures/level_picture.h"
#include "matching/map_file/map_fields.h"
#include "matching/output/summary.h"
#include "matching/output/write_file.h"
#include "matching/report/report.h"
#include "matching/render/canvas/plot.h"

#include <filesystem>
#include <fstream>
#include <iterator>
#include <new>

namespace shellmatch {

namespace {

template <int Dim>
void write_pictures(const MatchResult<Dim>& result, OutputFolder& folder, Observer& observer) {
  const MatchedSurfaces<Dim>& s = result.surfaces;
  LevelPicture<Dim> picture;
  picture.reference = &s.reference;
  picture.template_shape = &s.template_shape;
  picture.deformed = &s.deformed;
  add_distances(picture, s.distance, result.summary);
  if constexpr (Dim == 2) {
    // The grid shows how phi deforms the reference; backward it deforms the template.
    if (!result.map.is_backward) {
      picture.grid = &result.map.grid;
      picture.phi = &result.map.phi;
    }
  }
  Activity drawing("pictures", 4);
  drawing.next(3);
  draw(folder, "pictures/result.png", observer, [&](const std::string& path) { write_level_picture(picture, path); });
  drawing.next();
  if constexpr (Dim == 3)
    draw(folder, "pictures/grid.png", observer, [&](const std::string& path) {
      write_grid_picture(result.map.grid, s.reference, s.template_shape,
                         "reference (orange), template (blue), cells of the finest grid (grey)", path);
    });
  draw(folder, "pictures/energy.png", observer,
       [&](const std::string& path) { write_plot(energy_plot(result.history), path); });
}

// The vertices of a shape one ring after another.
std::vector<Index> vertices_along_rings(const OriginalShape<2>& shape) {
  std::vector<Index> order;
  for (const std::vector<Index>& ring : shape.polygons) order.insert(order.end(), ring.begin(), ring.end());
  return order;
}

OriginalShape<2> along_rings(const OriginalShape<2>& shape) {
  const std::vector<Index> order = vertices_along_rings(shape);
  const auto picked = [&]<class T>(const std::vector<T>& values) {
    std::vector<T> result;
    for (const Index v : order)
      if (!values.empty()) result.push_back(values[v]);
    return result;
  };
  OriginalShape<2> sorted{picked(shape.vertices), shape.polygons, {}, shape.details};
  for (const VertexAttribute& a : shape.attributes)
    sorted.attributes.push_back({a.name, a.type, picked(a.values), picked(a.texts)});
  Index next = 0;
  for (std::vector<Index>& ring : sorted.polygons)
    for (Index& v : ring) v = next++;
  return sorted;
}

void write_outlines(const MatchResult<2>& result, OutputFolder& folder) {
  OriginalShape<2> deformed = along_rings(result.deformed);
  const std::vector<Index> order = vertices_along_rings(result.template_shape);
  std::vector<double> line(result.template_shape.vertices.size());
  for (std::size_t k = 0; k < order.size(); ++k) line[order[k]] = static_cast<double>(k);
  for (VertexAttribute& a : deformed.attributes)
    if (a.name == "template_v0" || a.name == "template_v1")
      for (double& v : a.values) v = line[static_cast<std::size_t>(v)];
  write_outline_csv(folder.path_of("deformed.csv"), deformed);
  write_outline_csv(folder.path_of("template.csv"), along_rings(result.template_shape));
}

}  // namespace

void draw(OutputFolder& folder, const std::string& name, Observer& observer,
          const std::function<void(const std::string& path)>& write) {
  const std::string path = folder.path_of(name);
  std::string why;
  try {
    return write(path);
  } catch (const Stopped&) {
    throw;
  } catch (const std::bad_alloc&) {
    why = "not enough memory";
  } catch (const std::exception& error) {
    why = error.what();
  }
  std::error_code error;
  std::filesystem::remove(path, error);
  observer.warn(fmt::format("{} is missing: {}", name, why));
}

template <int Dim>
void write_result_files(const MatchResult<Dim>& result, const ExperimentOptions& options, OutputFolder& folder,
                        Observer& observer) {
  Activity writing("writing", options.pictures != Pictures::none ? 10 : 3);
  if (options.pictures != Pictures::none) {
    writing.next(7);
    write_pictures(result, folder, observer);
  }
  writing.next(2);
  if constexpr (Dim == 3) {
    write_ply(folder.path_of("deformed.ply"), result.deformed);
    if (const std::vector<std::string> lost = left_out("deformed.ply", result.deformed); !lost.empty())
      observer.note(fmt::format(
          "deformed.ply: without {}, which this format does not hold; shellmatch apply to the reference keeps them",
          fmt::join(lost, ", ")));
    write_ply(folder.path_of("template.ply"), result.template_shape);
    if (options.vertex_table) {
      write_points_csv(folder.path_of("deformed.csv"), result.deformed);
      write_points_csv(folder.path_of("template.csv"), result.template_shape);
    }
  } else {
    write_outlines(result, folder);
  }
  writing.next();
  write_deformation(
      folder.path_of(deformation_file_name), result.map,
      nodal_fields(result.moving_fields, result.target_fields, options),
      cell_fields(result.map.grid, result.map.phi, result.moving_fields.distance, result.summary.levels.back().sigma));
  write_history(result.history, folder.path_of("history.csv"));
  write_file(folder.path_of("config.yaml"), to_yaml(with_absolute_paths(options)));
}

template <int Dim>
void write_result_page(const MatchResult<Dim>& result, const ExperimentOptions& options, OutputFolder& folder,
                       Observer& observer) {
  if (!options.report) return;
  std::string picture;
  if (options.pictures != Pictures::none) {
    std::ifstream in(folder.path_of("pictures/result.png"), std::ios::binary);
    picture.assign(std::istreambuf_iterator<char>(in), {});
  }
  draw(folder, report_file_name, observer,
       [&](const std::string& path) { write_report(result, options, picture, path); });
}

template <int Dim>
void write_result_folder(const MatchResult<Dim>& result, const ExperimentOptions& options, const std::string& folder,
                         bool force, Observer* observer) {
  OutputFolder place(folder, force);
  Observer nobody;
  Observer& told = observer == nullptr ? nobody : *observer;
  write_result_files(result, options, place, told);
  write_result_page(result, options, place, told);
  write_summary(result.summary, place.path_of("summary.json"));
  place.commit();
}

SHELLMATCH_2D_3D(write_result_folder);
SHELLMATCH_2D_3D(write_result_page);
SHELLMATCH_2D_3D(write_result_files);

}  // namespace shellmatch

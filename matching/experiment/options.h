#pragma once
/// \file
/// The options of an experiment: everything on which a run depends.

#include "base/options.h"
#include "energies/energy_options.h"
#include "geometry/repair/repair.h"
#include "grid/options.h"
#include "matching/experiment/align_options.h"
#include "matching/experiment/level_overrides.h"
#include "matching/experiment/level_solver.h"
#include "matching/experiment/pair_options.h"

#include <algorithm>
#include <string>
#include <vector>

namespace shellmatch {

struct CheckGradientOptions {
  int every = 0;
  int directions = 1;
  static void describe(auto& self, auto& visit) {
    visit("every", self.every,
          {.unit = "iterations",
           .min = 0,
           .meaning = "check every term's gradient at the start of each minimisation and at every n-th iteration, and "
                      "report it in the summary; 0: never"});
  }
};

enum class Profile { standard, paper };
template <>
struct EnumNames<Profile> {
  static constexpr std::pair<Profile, std::string_view> names[] = {{Profile::standard, "default"},
                                                                   {Profile::paper, "paper"}};
};

enum class PlacementKind { fit, as_is };
template <>
struct EnumNames<PlacementKind> {
  static constexpr std::pair<PlacementKind, std::string_view> names[] = {{PlacementKind::fit, "fit"},
                                                                         {PlacementKind::as_is, "as-is"}};
};

template <>
struct EnumNames<Closing> {
  static constexpr std::pair<Closing, std::string_view> names[] = {{Closing::automatic, "auto"},
                                                                   {Closing::never, "never"}};
};

/// The frame of shapes out of volumes.
enum class SpaceKind { automatic, ras, lps };
template <>
struct EnumNames<SpaceKind> {
  static constexpr std::pair<SpaceKind, std::string_view> names[] = {
      {SpaceKind::automatic, "auto"}, {SpaceKind::ras, "ras"}, {SpaceKind::lps, "lps"}};
};

/// Which pictures a run draws. On small grids drawing takes longer than the matching.
enum class Pictures { all, result, none };
template <>
struct EnumNames<Pictures> {
  static constexpr std::pair<Pictures, std::string_view> names[] = {
      {Pictures::all, "all"}, {Pictures::result, "result"}, {Pictures::none, "none"}};
};

/// Which cells of phi's grid the cascade refines.
enum class RefineWhere { reference, both };
template <>
struct EnumNames<RefineWhere> {
  static constexpr std::pair<RefineWhere, std::string_view> names[] = {{RefineWhere::reference, "reference"},
                                                                       {RefineWhere::both, "both"}};
};

/// What happens to parts of a surface that lie inside the body it encloses (geometry/distance/buried_parts.h).
enum class Burial { left_out, kept };
template <>
struct EnumNames<Burial> {
  static constexpr std::pair<Burial, std::string_view> names[] = {{Burial::left_out, "leave-out"},
                                                                  {Burial::kept, "keep"}};
};

/// The files of the shapes, and their placement in the unit domain.
struct InputOptions {
  std::string reference, template_file, correspondence, unit;
  PlacementKind placement = PlacementKind::fit;
  double margin = 0.15;
  Closing close = Closing::automatic;
  Burial buried = Burial::left_out;
  SpaceKind space = SpaceKind::automatic;
  static void describe(auto& self, auto& visit) {
    visit("reference", self.reference, {.meaning = "file of the shape that is deformed; relative to the YAML file"});
    visit("template", self.template_file, {.meaning = "file of the shape it is to match; relative to the YAML file"});
    visit("correspondence", self.correspondence,
          {.meaning = "file with lines 'index x y z', the true places of vertices of the reference, from which the "
                      "summary states the error; known by itself for two built-in shapes that correspond"});
    visit("unit", self.unit,
          {.meaning = "unit of both shapes' coordinates in messages and pictures, such as mm; empty: that of a volume "
                      "whose file names it"});
    visit("placement", self.placement,
          {.meaning =
               "fit: one common similarity moves both shapes into the unit domain; as-is: they are there already"});
    visit("close", self.close,
          {.meaning = "meshes that are not closed: auto fills holes that make up at most 45 % of the area, wraps what "
                      "else has gaps or inner walls, and gives the added surface no weight (docs/closing.md); never "
                      "refuses them, as --strict does"});
    visit("buried", self.buried,
          {.meaning = "parts of a mesh inside other parts of it: leave-out gives them no weight, as no map without "
                      "folds reaches all of them; keep matches them like all others (docs/closing.md)"});
    visit("space", self.space,
          {.meaning = "frame of volumes, and of meshes that name none: ras or lps; auto: that of the other shape, if "
                      "it is a mesh that names one; else for meshes that in which points of 3D Slicer lie on them "
                      "(docs/landmarks.md), for volumes ras (docs/volumes.md)"});
  }
};

/// The frame that the user wants for shapes that name none; unsaid where they decide.
inline Space wanted_space(const InputOptions& input) {
  return input.space == SpaceKind::automatic ? Space::unsaid : input.space == SpaceKind::lps ? Space::lps : Space::ras;
}

/// The multilevel scheme, from coarse to fine (paper, algorithm 1 and section 6).
struct CascadeOptions {
  int min_level = 3, max_level = 7;
  double nu = 0.0002, nu_factor = 0.2;
  int nu_substeps = 3;
  double negligible_start_rise = 0.4, negligible_rise = 0.01;
  double intermediate_decrease = 1e-3, substep_decrease = 0.01;
  double volume = 0.2, volume_factor = 1;
  double sigma_cells = 2;
  double coarse_sigma_cells = 4;
  RefineWhere refine = RefineWhere::reference;
  static void describe(auto& self, auto& visit) {
    visit("min_level", self.min_level,
          {.unit = "level",
           .min = 1,
           .max = 12,
           .meaning = "level of the uniform grid that the cascade starts from; cells have side 2^-level"});
    visit("max_level", self.max_level,
          {.unit = "level",
           .min = 1,
           .max = finest_level,
           .meaning = "level of the finest cells of the grid of phi; see cascade.refine"});
    visit("nu", self.nu,
          {.unit = "length^2/energy", .min = 0, .min_excluded = true, .meaning = "nu of the match term at min_level"});
    visit("nu_factor", self.nu_factor,
          {.min = 0, .max = 1, .min_excluded = true, .meaning = "factor on nu from one level to the next"});
    visit("nu_substeps", self.nu_substeps,
          {.unit = "minimisations",
           .min = 1,
           .max = 20,
           .meaning = "steps of equal ratio in which nu is lowered within a level, as long as they gain something; 1 "
                      "is the paper's"});
    visit("volume", self.volume, {.min = 0, .meaning = "c_vol, weight of the volume term, at min_level"});
    visit("volume_factor", self.volume_factor,
          {.min = 0, .max = 1, .min_excluded = true, .meaning = "factor on c_vol from one level to the next"});
    visit("sigma_cells", self.sigma_cells,
          {.unit = "finest cells", .min = 1, .max = 16, .meaning = "half width sigma of the band on the finest level"});
    visit("coarse_sigma_cells", self.coarse_sigma_cells,
          {.unit = "finest cells",
           .min = 1,
           .max = 16,
           .meaning = "half width sigma of the band on coarser levels: wider than a thin limb, so that it pulls at the "
                      "tip; surfaces with pairs have 1 instead"});
    visit("refine", self.refine,
          {.meaning = "the grid of phi is refined where it meets the reference, or either shape, as in the paper; with "
                      "coefficients.interpolation = multilinear always both"});
  }
};

/// An earlier result with which a run begins.
struct StartOptions {
  std::string map;
  int level = 0;
  std::vector<std::string> images;
  static void describe(auto& self, auto& visit) {
    visit("map", self.map,
          {.meaning = "output folder (or deformation.vtu) of an earlier run of nearly the same shapes in the same "
                      "places, whose pose and map replace the alignment and the coarse levels; if the shapes lie "
                      "elsewhere the run begins without it, and says so. Such a run keeps no checkpoints; relative to "
                      "the YAML file"});
    visit(
        "level", self.level,
        {.unit = "level",
         .min = 0,
         .max = finest_level,
         .meaning =
             "first level that is minimised with start.map; 0: that after its finest one, at most cascade.max_level"});
    visit("images", self.images,
          {.meaning =
               "output folders of earlier runs that have deformed the same reference onto other shapes: with "
               "align.mode auto poses of surfaces are predicted from these, and pairs are searched only if the pose is "
               "unclear or leaves a part far away. Such a run keeps no checkpoints; relative to the YAML file"});
  }
};

/// Checkpoints of finished levels, from which a stopped run is resumed.
struct ResumeOptions {
  bool enabled = true;
  double min_seconds = 10;
  static void describe(auto& self, auto& visit) {
    visit("enabled", self.enabled,
          {.meaning = "keep the alignment and the last finished level in NAME.unfinished beside the output folder NAME "
                      "until the run is done, so that the same command resumes a run that was stopped"});
    visit("min_seconds", self.min_seconds,
          {.unit = "seconds",
           .min = 0,
           .meaning = "least time between the levels that are kept, and from the start to the first; an alignment that "
                      "is stopped is kept after a tenth of it"});
  }
};

/// All options of an experiment, as one YAML document.
struct ExperimentOptions {
  Profile profile = Profile::standard;
  InputOptions input;
  StartOptions start;
  CascadeOptions cascade;
  EnergyOptions energy;
  CoefficientOptions coefficients;
  LevelwiseSolverOptions solver;
  AlignOptions align;
  LandmarkOptions landmarks;
  CoverageOptions coverage;
  CheckGradientOptions check_gradient;
  Pictures pictures = Pictures::result;
  bool report = true, vertex_table = false;
  ResumeOptions resume;
  int threads = 0;
  static void describe(auto& self, auto& visit) {
    visit("profile", self.profile,
          {.meaning = "set of defaults: default is the best we know, paper keeps the paper's discrete choices "
                      "(docs/profiles.md)"});
    visit("input", self.input, {.meaning = "the two shapes"});
    visit("start", self.start, {.meaning = "beginning with an earlier result"});
    visit("cascade", self.cascade, {.meaning = "coarse to fine"});
    visit("energy", self.energy, {.meaning = "weights and material"});
    visit("coefficients", self.coefficients, {.meaning = "normals and curvatures on the grid"});
    visit("solver", self.solver, {.meaning = "the minimiser"});
    visit("align", self.align, {.meaning = "pose and pairs of points, found before the cascade"});
    visit("landmarks", self.landmarks, {.meaning = "points that are known to correspond"});
    visit("coverage", self.coverage, {.meaning = "two-sided match"});
    visit("pictures", self.pictures, {.meaning = "pictures of the end (result), of each level as well (all), or none"});
    visit("report", self.report,
          {.meaning = "write report.html, a page that shows the result without a network (docs/report.md)"});
    visit("vertex_table", self.vertex_table,
          {.meaning = "for meshes also write deformed.csv and template.csv, with the columns of deformed.ply and "
                      "template.ply (docs/output.md); for contours they are always written"});
    visit("resume", self.resume, {.meaning = "going on after a stop; changes no result"});
    visit("check_gradient", self.check_gradient, {.meaning = "derivatives checked on the way"});
    visit("threads", self.threads,
          {.unit = "threads",
           .min = 0,
           .max = 1024,
           .meaning = "0 uses all of the machine; the result does not depend on it"});
  }
};

/// Whether the grid of phi is refined at the template, too.
inline bool refines_at_template(const ExperimentOptions& options) {
  return options.cascade.refine == RefineWhere::both ||
         options.coefficients.interpolation == FieldInterpolation::multilinear;
}

/// Whether coverage acts on a level: on the finest ones, but not on cascade.min_level, whose minimisation begins with
/// the identity. Its closest points are no correspondences yet.
inline bool covers(const ExperimentOptions& options, int level) {
  return level > std::max(options.cascade.min_level, options.cascade.max_level - options.coverage.levels);
}
/// Whether it acts on any.
inline bool has_coverage(const ExperimentOptions& options) { return covers(options, options.cascade.max_level); }

/// The default options of a profile.
ExperimentOptions profile_defaults(Profile profile);

}  // namespace shellmatch

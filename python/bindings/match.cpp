// The function `match`, and the class Match that it returns.

#include "base/error.h"
#include "base/parallel.h"
#include "matching/experiment/generated_source.h"
#include "matching/experiment/yaml_options.h"
#include "matching/match_shapes.h"
#include "matching/output/summary.h"
#include "matching/write_result.h"
#include "python/bindings/arrays.h"
#include "python/bindings/bindings.h"
#include "python/bindings/computation.h"
#include "python/bindings/inputs.h"
#include "python/bindings/map.h"
#include "python/bindings/observer.h"

#include <pybind11/stl.h>

#include <memory>
#include <utility>

namespace shellmatch::python {

namespace {

/// A result with the options that led to it, and what the run has said.
struct Match {
  std::shared_ptr<const AnyMatchResult> result;
  ExperimentOptions options;
  std::vector<std::string> notes, warnings;
};

// As run_matching() has it, for shapes that are files or built-in ones.
template <int Dim>
Correspondence<Dim> truth_of(const InputOptions& input, std::size_t n_vertices) {
  if (input.correspondence.empty()) return generated_correspondence<Dim>(input.reference, input.template_file);
  return read_correspondence<Dim>(input.correspondence, n_vertices);
}

AnyMatchResult run(std::array<ShapeInput, 2> shapes, const ExperimentOptions& options, const GivenLandmarks& given,
                   Observer& observer) {
  set_n_threads(options.threads);
  observer.stage("reading");
  AnyShapePair any = open_shape_pair(std::move(shapes), options.input, options.landmarks, observer);
  return std::visit(
      [&]<int Dim>(ShapePair<Dim>& pair) -> AnyMatchResult {
        const std::vector<Landmark<Dim>> landmarks = landmarks_of(given, options, pair, observer);
        const Correspondence<Dim> truth = truth_of<Dim>(options.input, pair.reference.original.vertices.size());
        return match_shapes(std::move(pair), options, observer, landmarks, truth);
      },
      any);
}

Match match(const ShapeInput& reference, const ShapeInput& template_shape, const OptionTexts& texts,
            const std::string& config, const py::object& landmarks, const py::object& progress) {
  if (is_called_back()) throw_input_error("a matching cannot begin within the progress function of another one");
  const GivenLandmarks given = landmarks_from(landmarks);
  PythonObserver observer(progress);
  Match made;
  made.result = compute_matching([&] {
    std::array<ShapeInput, 2> shapes{reference, template_shape};
    made.options = options_of(config, texts, shapes);
    return std::make_shared<const AnyMatchResult>(run(std::move(shapes), made.options, given, observer));
  });
  made.notes = std::move(observer.notes);
  made.warnings = std::move(observer.warnings);
  return made;
}

template <int Dim>
py::dict attributes_of(const OriginalShape<Dim>& shape) {
  py::dict attributes;
  for (const VertexAttribute& a : shape.attributes)
    if (a.type != "text")
      attributes[text_of(a.name)] =
          array_of(std::vector<double>(a.values), {static_cast<py::ssize_t>(a.values.size())});
  return attributes;
}

// Positions that stay where they are: the array keeps the Match, which nothing changes.
py::array_t<double> vertices_of(const py::object& self) {
  const Match& match = self.cast<const Match&>();
  return std::visit(
      [&]<int Dim>(const MatchResult<Dim>& result) {
        const std::vector<Vec<Dim>>& vertices = result.deformed.vertices;
        static_assert(sizeof(Vec<Dim>) == Dim * sizeof(double));
        const double* first = vertices.empty() ? nullptr : vertices.front().data();
        return view_of(first, {std::ssize(vertices), Dim}, self);
      },
      *match.result);
}

Map map_of(const Match& match) {
  return std::visit(
      [&]<int Dim>(const MatchResult<Dim>& result) {
        return Map(std::shared_ptr<const Deformation<Dim>>(match.result, &result.map));
      },
      *match.result);
}

py::list history_of(const Match& match) {
  const History& history = std::visit([](const auto& r) -> const History& { return r.history; }, *match.result);
  py::list rows;
  for (const HistoryRow& row : history.rows) {
    py::dict terms, entry;
    for (std::size_t t = 0; t < row.record.terms.size() && t < history.term_names.size(); ++t)
      terms[py::str(history.term_names[t])] = row.record.terms[t];
    entry["level"] = row.level;
    entry["substep"] = row.substep;
    entry["nu"] = row.nu;
    entry["iteration"] = row.record.iteration;
    entry["energy"] = row.record.value;
    entry["terms"] = terms;
    entry["gradient_norm"] = row.record.l2_gradient_norm;
    entry["gradient_evaluations"] = row.record.gradient_evaluations;
    entry["seconds"] = row.record.seconds;
    entry["solver"] = row.record.solver;
    rows.append(entry);
  }
  return rows;
}

// Returns what is missing from the folder.
py::list save(const Match& match, const std::string& folder, bool force) {
  if (folder.empty()) throw_input_error("the name of the output folder is empty");
  PythonObserver observer{py::none()};
  compute([&] {
    std::visit([&](const auto& result) { write_result_folder(result, match.options, folder, force, &observer); },
               *match.result);
  });
  return texts_of(observer.warnings);
}

}  // namespace

void bind_match(py::module_& module) {
  py::class_<Match>(module, "Match", "The result of match(); shellmatch.Result shows it.")
      .def_property_readonly("vertices", vertices_of)
      .def_property_readonly(
          "attributes",
          [](const Match& m) { return std::visit([](const auto& r) { return attributes_of(r.deformed); }, *m.result); })
      .def_property_readonly("template_attributes",
                             [](const Match& m) {
                               return std::visit([](const auto& r) { return attributes_of(r.template_shape); },
                                                 *m.result);
                             })
      .def_property_readonly("map", map_of)
      .def_property_readonly("summary_json",
                             [](const Match& m) { return text_of(summary_json(summary_of(*m.result))); })
      .def_property_readonly("history", history_of)
      .def_property_readonly("options_yaml", [](const Match& m) { return text_of(to_yaml(m.options)); })
      .def_property_readonly("notes", [](const Match& m) { return texts_of(m.notes); })
      .def_property_readonly("warnings", [](const Match& m) { return texts_of(m.warnings); })
      .def("save", save, py::arg("folder"), py::arg("force"));
  module.def("match", match, py::arg("reference"), py::arg("template_shape"), py::arg("options"), py::arg("config"),
             py::arg("landmarks"), py::arg("progress"));
  module.def("check_all_but_template", check_all_but_template, py::arg("reference"), py::arg("options"),
             py::arg("config"), py::arg("landmarks"));
}

}  // namespace shellmatch::python

// The class Problem: the energy of one level as functions of arrays.

#include "base/error.h"
#include "base/parallel.h"
#include "matching/cascade/size_estimate.h"
#include "python/bindings/any_level.h"
#include "python/bindings/arrays.h"
#include "python/bindings/bindings.h"
#include "python/bindings/computation.h"

#include <pybind11/stl.h>

#include <cmath>
#include <limits>
#include <memory>
#include <utility>

namespace shellmatch::python {

namespace {

/// Evaluations change the level's state: only one at a time, also where one calls back.
class Problem {
 public:
  Problem(const ShapeInput& reference, const ShapeInput& template_shape, std::optional<int> number, bool from_coarser,
          const OptionTexts& texts, const std::string& config, const py::object& landmarks,
          const py::object& progress) {
    if (is_called_back()) throw_input_error("a Problem cannot be made within a progress function");
    const GivenLandmarks given = landmarks_from(landmarks);
    PythonObserver observer(progress);
    level_ = compute_matching([&] {
      std::array<ShapeInput, 2> shapes{reference, template_shape};
      const ExperimentOptions options = options_of(config, texts, shapes);
      const int level = number.value_or(options.cascade.max_level);
      if (level < options.cascade.min_level || level > options.cascade.max_level)
        throw_input_error("level {}: the cascade has the levels {} to {} (levels)", level, options.cascade.min_level,
                          options.cascade.max_level);
      set_n_threads(options.threads);
      AnyShapePair any = open_shape_pair(std::move(shapes), options.input, options.landmarks, observer);
      return std::visit(
          [&]<int Dim>(ShapePair<Dim>& pair) -> std::unique_ptr<AnyLevel> {
            std::vector<Landmark<Dim>> points = landmarks_of(given, options, pair, observer);
            return make_level<Dim>(std::move(pair), std::move(points), options, level, from_coarser, observer);
          },
          any);
    });
    notes = std::move(observer.notes);
    x0 = compute([&] { return level_->start(); });
    mass = compute([&] { return level_->mass(); });
  }

  /// body(level), with no other evaluation meanwhile.
  auto use(auto&& body) {
    return compute_matching([&] {
      if (is_used_)
        throw_input_error(
            "this Problem is being minimised; its functions cannot be called from that progress function");
      is_used_ = true;
      struct Release {
        bool& flag;
        ~Release() { flag = false; }
      } release{is_used_};
      return body(*level_);
    });
  }

  std::vector<double> unknowns(const Doubles& x, const char* name) const {
    if (x.ndim() != 1 || static_cast<std::size_t>(x.size()) != x0.size())
      throw_input_error("{}: expected a vector of {} numbers, as Problem.x0 is", name, x0.size());
    std::vector<double> values(x.data(), x.data() + x.size());
    for (std::size_t i = 0; i < values.size(); ++i)
      if (!std::isfinite(values[i])) throw_input_error("{}: entry {} is not finite", name, i);
    return values;
  }

  const AnyLevel& level() const { return *level_; }
  std::vector<double> x0, mass;
  std::vector<std::string> notes;

 private:
  std::unique_ptr<AnyLevel> level_;
  bool is_used_ = false;
};

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

double energy(Problem& problem, const Doubles& given) {
  const std::vector<double> x = problem.unknowns(given, "x");
  return problem.use([&](AnyLevel& level) {
    double value = 0;
    return level.evaluate(x, value, {}) ? value : infinity;
  });
}

py::tuple energy_and_gradient(Problem& problem, const Doubles& given) {
  const std::vector<double> x = problem.unknowns(given, "x");
  std::vector<double> gradient(x.size());
  const double value = problem.use([&](AnyLevel& level) {
    double e = 0;
    if (level.evaluate(x, e, gradient)) return e;
    std::fill(gradient.begin(), gradient.end(), nan);
    return infinity;
  });
  const auto n = static_cast<py::ssize_t>(gradient.size());
  return py::make_tuple(value, array_of(std::move(gradient), {n}));
}

py::dict terms(Problem& problem, const Doubles& given) {
  const std::vector<double> x = problem.unknowns(given, "x");
  std::vector<std::string> names;
  std::vector<double> values;
  problem.use([&](AnyLevel& level) {
    double value = 0;
    const bool finite = level.evaluate(x, value, {});
    names = level.term_names();
    values = finite ? level.term_values() : std::vector<double>(names.size(), nan);
  });
  py::dict result;
  for (std::size_t t = 0; t < names.size() && t < values.size(); ++t) result[py::str(names[t])] = values[t];
  return result;
}

py::array_t<double> model_times(Problem& problem, const Doubles& at, const Doubles& direction) {
  const std::vector<double> x = problem.unknowns(at, "x"), v = problem.unknowns(direction, "v");
  std::vector<double> product = problem.use([&](AnyLevel& level) { return level.model_times(x, v); });
  const auto n = static_cast<py::ssize_t>(product.size());
  return array_of(std::move(product), {n});
}

py::dict minimise(Problem& problem, const Doubles& start, const OptionTexts& texts, const py::object& progress) {
  std::vector<double> x = problem.unknowns(start, "x0");
  PythonObserver observer(progress);
  Minimum minimum = problem.use([&](AnyLevel& level) { return level.minimise(std::move(x), texts, observer); });
  const MinimizerSummary& s = minimum.summary;
  py::list history;
  for (const IterationRecord& r : minimum.records) {
    py::dict row;
    row["iteration"] = r.iteration;
    row["energy"] = r.value;
    row["gradient_norm"] = r.l2_gradient_norm;
    row["value_evaluations"] = r.value_evaluations;
    row["gradient_evaluations"] = r.gradient_evaluations;
    row["seconds"] = r.seconds;
    row["solver"] = r.solver;
    history.append(row);
  }
  py::dict result;
  const auto n = static_cast<py::ssize_t>(minimum.x.size());
  result["x"] = array_of(std::move(minimum.x), {n});
  result["energy"] = s.final_value;
  result["solver"] = s.solver;
  result["reason"] = std::string(enum_name(s.reason));
  result["message"] = text_of(s.message);
  result["iterations"] = s.iterations;
  result["value_evaluations"] = s.value_evaluations;
  result["gradient_evaluations"] = s.gradient_evaluations;
  result["seconds"] = s.seconds;
  result["notes"] = texts_of(observer.notes);
  result["history"] = history;
  return result;
}

py::dict sizes(const Problem& problem) {
  py::dict levels;
  for (const LevelSize& s : problem.level().sizes()) {
    py::dict size;
    size["nodes"] = s.n_nodes;
    size["free_nodes"] = s.n_free_nodes;
    size["cells"] = s.n_cells;
    levels[py::int_(s.level)] = size;
  }
  return levels;
}

// A vector of the problem's, read only: nothing changes it after the construction.
template <std::vector<double> Problem::*member>
py::array_t<double> view(const py::object& self) {
  const std::vector<double>& values = self.cast<const Problem&>().*member;
  return view_of(values.data(), {std::ssize(values)}, self);
}

}  // namespace

void bind_problem(py::module_& module) {
  py::class_<Problem>(module, "Problem", "One level of the cascade of a pair; shellmatch.Problem shows it.")
      .def(py::init<const ShapeInput&, const ShapeInput&, std::optional<int>, bool, const OptionTexts&,
                    const std::string&, const py::object&, const py::object&>(),
           py::arg("reference"), py::arg("template_shape"), py::arg("level"), py::arg("from_coarser"),
           py::arg("options"), py::arg("config"), py::arg("landmarks"), py::arg("progress"))
      .def_property_readonly("level", [](const Problem& p) { return p.level().number(); })
      .def_property_readonly("sizes", sizes)
      .def_property_readonly("notes", [](const Problem& p) { return texts_of(p.notes); })
      .def_property_readonly("x0", view<&Problem::x0>)
      .def_property_readonly("mass", view<&Problem::mass>)
      .def("energy", energy, py::arg("x"))
      .def("energy_and_gradient", energy_and_gradient, py::arg("x"))
      .def("terms", terms, py::arg("x"))
      .def("model_times", model_times, py::arg("x"), py::arg("v"))
      .def(
          "map",
          [](Problem& p, const Doubles& given) {
            const std::vector<double> x = p.unknowns(given, "x");
            return p.use([&](AnyLevel& level) { return level.map(x); });
          },
          py::arg("x"))
      .def("minimize", minimise, py::arg("x0"), py::arg("options"), py::arg("progress"));
}

}  // namespace shellmatch::python

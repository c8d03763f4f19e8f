#pragma once
/// \file
/// A level of a pair of either dimension, behind the class Problem.

#include "matching/pair_level.h"
#include "python/bindings/inputs.h"
#include "python/bindings/map.h"
#include "python/bindings/observer.h"

#include <memory>
#include <span>
#include <string>
#include <vector>

namespace shellmatch::python {

/// What minimise() returns.
struct Minimum {
  std::vector<double> x;
  MinimizerSummary summary;
  std::vector<IterationRecord> records;
};

/// \pre of all but sizes() and number(): within compute() (computation.h). \throws InputError where the energy cannot
/// be evaluated
class AnyLevel {
 public:
  virtual ~AnyLevel() = default;
  virtual std::vector<double> start() = 0;
  virtual std::vector<double> mass() = 0;
  virtual bool evaluate(const std::vector<double>& x, double& value, std::span<double> gradient) = 0;
  virtual std::vector<std::string> term_names() = 0;
  virtual std::vector<double> term_values() = 0;
  virtual std::vector<double> model_times(const std::vector<double>& x, const std::vector<double>& v) = 0;
  virtual Map map(const std::vector<double>& x) = 0;
  virtual Minimum minimise(std::vector<double> x, const OptionTexts& texts, PythonObserver& observer) = 0;
  virtual const std::vector<LevelSize>& sizes() const = 0;
  virtual int number() const = 0;
};

/// \param from_coarser whether start() is the result of the cascade on the level before
template <int Dim>
std::unique_ptr<AnyLevel> make_level(ShapePair<Dim> shapes, std::vector<Landmark<Dim>> landmarks,
                                     const ExperimentOptions& options, int level, bool from_coarser,
                                     Observer& observer);

}  // namespace shellmatch::python

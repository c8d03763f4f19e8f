#pragma once
/// \file
/// The plots of a study.

#include "render/canvas/plot.h"
#include "studies/report/study_table.h"

#include <string>
#include <vector>

namespace shellmatch {

/// A plot and the name of its file without the ending.
struct StudyPlot {
  std::string name;
  Plot plot;
};

/// Gaps at and below it are drawn on this line: the best run's last gap is 0, which no logarithm shows.
inline constexpr double least_gap_shown = 1e-5;

/// For each instance the relative gap along the last minimisation, against evaluations and against seconds of
/// the whole cascade. First repeats only.
std::vector<StudyPlot> gap_plots(const StudyTable& table);

/// Performance profiles, for evaluations and seconds to each gap of study_gaps. A problem of the profile is
/// an instance, a solver is a method; repeats enter by their median.
std::vector<StudyPlot> profile_plots(const StudyTable& table);

/// Final gap and mean distance (the mean of both directions, in diagonals of the template's box) by method, a
/// colour for each instance.
std::vector<StudyPlot> final_plots(const StudyTable& table);

/// Names in the order of their first appearance.
std::vector<std::string> instances_of(const StudyTable& table);
std::vector<std::string> methods_of(const StudyTable& table);

/// The middle one of an odd number of values, the mean of the two middle ones of an even number; infinity
/// counts. \pre not empty
double median(std::vector<double> values);

}  // namespace shellmatch

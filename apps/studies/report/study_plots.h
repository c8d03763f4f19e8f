#pragma once
/// \file
/// The plots of a study.

#include "matching/render/canvas/plot.h"
#include "apps/studies/report/study_table.h"

#include <string>
#include <vector>

namespace shellmatch {

/// A plot and its file name without extension.
struct StudyPlot {
  std::string name;
  Plot plot;
};

/// Smaller gaps are drawn at this value: the smallest gap is 0, which a logarithmic axis cannot show.
inline constexpr double least_gap_shown = 1e-5;

/// For each instance the relative gap over evaluations and over seconds of the whole cascade, during the last
/// minimisation. First repeats only.
std::vector<StudyPlot> gap_plots(const StudyTable& table);

/// Performance profiles by evaluations and by seconds, for each gap of study_gaps. The problems are instances, the
/// solvers methods; repeats enter by their median.
std::vector<StudyPlot> profile_plots(const StudyTable& table);

/// Final gap and mean distance (mean of both directions, in diagonals of the template's bounding box) by method, with
/// one colour for each instance.
std::vector<StudyPlot> final_plots(const StudyTable& table);

/// The names in the order of their first occurrence.
std::vector<std::string> instances_of(const StudyTable& table);
std::vector<std::string> methods_of(const StudyTable& table);

/// The median; the mean of the two middle values of an even number. Values may be infinite. \pre not empty
double median(std::vector<double> values);

}  // namespace shellmatch

// Draws a line plot for the scripts. Usage: plot_series FILE.svg|FILE.png < PLOT.json
//
// The keys of PLOT.json are the members of Plot and of its Series (matching/render/canvas/plot.h); what is left out has
// its default.

#include "base/error.h"
#include "matching/render/canvas/plot.h"

#include <nlohmann/json.hpp>

#include <cstdio>
#include <exception>
#include <iostream>

namespace shellmatch {

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE_WITH_DEFAULT(Series, name, x, y, dashed, points, line, point_radius, color, dashes)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE_WITH_DEFAULT(Plot, title, x_label, y_label, log_x, log_y, series, rows, marks, width,
                                                height)

namespace {

Plot read_plot(std::istream& in) {
  const auto json = nlohmann::json::parse(in);
  const Plot plot = json.get<Plot>();
  // Unknown keys are refused, because a misspelt key would otherwise be ignored.
  const auto check = [](const nlohmann::json& given, const nlohmann::json& known) {
    for (const auto& [key, value] : given.items())
      if (!known.contains(key)) throw_input_error("there is no '{}' in a plot", key);
  };
  check(json, plot);
  if (json.contains("series"))
    for (const auto& series : json["series"]) check(series, Series());
  for (const Series& s : plot.series)
    if (s.x.size() != s.y.size()) throw_input_error("series '{}' has {} x and {} y", s.name, s.x.size(), s.y.size());
  return plot;
}

}  // namespace
}  // namespace shellmatch

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fputs("usage: plot_series FILE.svg|FILE.png < PLOT.json\n", stderr);
    return 2;
  }
  try {
    write_plot(shellmatch::read_plot(std::cin), argv[1]);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "plot_series: %s\n", error.what());
    return 1;
  }
}

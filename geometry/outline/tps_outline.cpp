// Outlines of TPS files: closed ones, and curves that make up closed ones.

#include "base/error.h"
#include "base/printable.h"
#include "geometry/outline/drawing.h"
#include "geometry/outline/tps_file.h"

#include <algorithm>
#include <map>
#include <utility>

namespace shellmatch {

namespace {

// Open curves that begin where others end make up longer ones.
class CurveChains {
 public:
  explicit CurveChains(const std::vector<TpsCurve>& curves) {
    for (const TpsCurve& curve : curves) {
      if (curve.points.empty()) continue;
      if (curve.is_closed || curve.points.front() == curve.points.back())
        paths_.push_back(path_through(curve.points, true));
      else
        ends_.push_back({&curve, at_end_.emplace(key(curve.points.front()), ends_.size()),
                         at_end_.emplace(key(curve.points.back()), ends_.size())});
    }
    for (Ends& first : ends_) {
      if (is_used(first)) continue;
      std::vector<Vec<2>> chain = use(first);
      extend(chain);
      std::ranges::reverse(chain);
      extend(chain);
      paths_.push_back(path_through(chain, false));
    }
  }

  std::vector<DrawnPath> take() { return std::move(paths_); }
  std::size_t n_joined() const { return n_joined_; }

 private:
  using Key = std::pair<double, double>;
  using Places = std::multimap<Key, std::size_t>;
  struct Ends {
    const TpsCurve* curve;
    Places::iterator front, back;
  };

  static Key key(const Vec<2>& x) { return {x.x(), x.y()}; }
  bool is_used(const Ends& ends) const { return ends.front == ends.back; }
  const std::vector<Vec<2>>& use(Ends& ends) {
    at_end_.erase(ends.front);
    at_end_.erase(ends.back);
    ends.front = ends.back = at_end_.end();
    return ends.curve->points;
  }
  void extend(std::vector<Vec<2>>& chain) {
    while (chain.front() != chain.back()) {
      const auto next = at_end_.find(key(chain.back()));
      if (next == at_end_.end()) return;
      std::vector<Vec<2>> points = use(ends_[next->second]);
      if (points.front() != chain.back()) std::ranges::reverse(points);
      chain.insert(chain.end(), points.begin() + 1, points.end());
      ++n_joined_;
    }
  }

  Places at_end_;
  std::vector<Ends> ends_;
  std::vector<DrawnPath> paths_;
  std::size_t n_joined_ = 0;
};

}  // namespace

Drawing read_tps_outline(const std::string& path, std::string_view bytes, const std::string& part) {
  const std::vector<TpsSpecimen> specimens = parse_tps(path, bytes);
  const TpsSpecimen& specimen = chosen_specimen(specimens, path, part);
  if (specimen.curves.empty())
    throw_input_error("{}: {}landmarks, but neither CURVES= nor OUTLINES=: no outline; landmarks are for --landmarks",
                      path, part.empty() ? "" : printable(part, 60) + " has ");
  Drawing drawing;
  drawing.scale = specimen.factor();
  DrawnArea area;
  CurveChains chains(specimen.curves);
  if (!part.empty()) area.names.push_back(part);
  area.paths = chains.take();
  drawing.areas.push_back(std::move(area));
  if (const std::size_t n = chains.n_joined(); n > 0)
    drawing.notes.push_back(fmt::format("{} curves joined where they meet", n + 1));
  if (std::string note = scale_note(specimens, specimen); !note.empty()) drawing.notes.push_back(std::move(note));
  return drawing;
}

}  // namespace shellmatch

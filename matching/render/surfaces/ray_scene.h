#pragma once
/// \file
/// Ray casting against triangle surfaces: first hit and visibility.

#include "matching/render/surfaces/camera.h"

#include <memory>
#include <optional>
#include <span>

namespace shellmatch {

/// Intersection of a ray with a facet. The point is (1 - u - v) a + u b + v c with the facet's vertices a, b,
/// c.
struct RayHit {
  int surface;  ///< position among the scene's surfaces
  Index facet;
  double u, v;
  double distance;  ///< along the ray
};

/// Triangle surfaces in a ray casting structure. Immutable and safe for parallel use; results do not depend
/// on the number of threads.
class RayScene {
 public:
  /// Copies the surfaces. There may be no triangles.
  explicit RayScene(std::span<const Surface<3>* const> surfaces);
  ~RayScene();
  RayScene(RayScene&&) noexcept;
  RayScene& operator=(RayScene&&) noexcept;

  std::optional<RayHit> first_hit(const Ray& ray) const;
  /// True if the ray meets a facet at a distance between `near` and `far`.
  bool is_blocked(const Ray& ray, double near, double far) const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace shellmatch

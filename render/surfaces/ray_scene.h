#pragma once
/// \file
/// Which facet does a ray meet first? The only questions that pictures ask of the ray caster.

#include "render/surfaces/camera.h"

#include <memory>
#include <optional>
#include <span>

namespace shellmatch {

/// Where a ray meets a surface. The point is (1 - u - v) a + u b + v c with a, b, c the facet's vertices.
struct RayHit {
  int surface;  ///< position among the scene's surfaces
  Index facet;
  double u, v;
  double distance;  ///< along the ray
};

/// Triangle surfaces prepared for ray casting. Immutable; questions may be asked in parallel, and the answers
/// do not depend on the number of threads.
class RayScene {
 public:
  /// Keeps no reference to the surfaces. May hold no triangle at all.
  explicit RayScene(std::span<const Surface<3>* const> surfaces);
  ~RayScene();
  RayScene(RayScene&&) noexcept;
  RayScene& operator=(RayScene&&) noexcept;

  std::optional<RayHit> first_hit(const Ray& ray) const;
  /// Is anything met between `near` and `far` along the ray?
  bool is_blocked(const Ray& ray, double near, double far) const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace shellmatch

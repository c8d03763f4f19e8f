#include "base/error.h"
#include "matching/render/surfaces/ray_scene.h"

#if __has_include(<embree4/rtcore.h>)
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

#include <algorithm>
#include <limits>

namespace shellmatch {

struct RayScene::State {
  RTCDevice device = nullptr;
  RTCScene scene = nullptr;
  // Embree computes in single precision, so the scene is first mapped to [-1, 1]^3.
  Vec<3> centre = Vec<3>::Zero();
  double scale = 1;

  State() = default;
  State(const State&) = delete;
  State& operator=(const State&) = delete;
  ~State() {
    if (scene) rtcReleaseScene(scene);
    if (device) rtcReleaseDevice(device);
  }

  RTCRay single(const Ray& ray, double near, double far) const {
    const Vec<3> o = scale * (ray.origin - centre);
    RTCRay r{};
    r.org_x = static_cast<float>(o.x());
    r.org_y = static_cast<float>(o.y());
    r.org_z = static_cast<float>(o.z());
    r.dir_x = static_cast<float>(ray.direction.x());
    r.dir_y = static_cast<float>(ray.direction.y());
    r.dir_z = static_cast<float>(ray.direction.z());
    r.tnear = static_cast<float>(scale * near);
    r.tfar = static_cast<float>(std::min(scale * far, double{std::numeric_limits<float>::max()}));
    r.mask = 0xffffffffu;
    return r;
  }
};

namespace {

[[noreturn]] void throw_embree_error(RTCError error) {
  if (error == RTC_ERROR_OUT_OF_MEMORY) throw MemoryError("not enough memory to draw a picture of surfaces");
  throw_environment_error("the ray caster cannot work on this machine (Embree error {})", static_cast<int>(error));
}

// Embree 3 takes a context where Embree 4 has optional arguments.
#if RTC_VERSION_MAJOR >= 4
void intersect(RTCScene scene, RTCRayHit& query) { rtcIntersect1(scene, &query); }
void occlude(RTCScene scene, RTCRay& query) { rtcOccluded1(scene, &query); }
#else
void intersect(RTCScene scene, RTCRayHit& query) {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  rtcIntersect1(scene, &context, &query);
}
void occlude(RTCScene scene, RTCRay& query) {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  rtcOccluded1(scene, &context, &query);
}
#endif

}  // namespace

RayScene::RayScene(std::span<const Surface<3>* const> surfaces) : state_(std::make_unique<State>()) {
  State& s = *state_;
  Box<3> box;
  for (const Surface<3>* surface : surfaces)
    for (const Vec<3>& v : surface->vertices) box.add(v);
  if (box.diagonal() > 0 && box.diagonal() < std::numeric_limits<double>::infinity()) {
    s.centre = 0.5 * (box.min + box.max);
    s.scale = 2 / box.diagonal();
  }
  s.device = rtcNewDevice(nullptr);
  if (!s.device) throw_embree_error(rtcGetDeviceError(nullptr));
  s.scene = rtcNewScene(s.device);
  if (!s.scene) throw_embree_error(rtcGetDeviceError(s.device));
  rtcSetSceneFlags(s.scene, RTC_SCENE_FLAG_ROBUST);
  for (std::size_t i = 0; i < surfaces.size(); ++i) {
    const Surface<3>& surface = *surfaces[i];
    if (surface.facets.empty()) continue;
    RTCGeometry geometry = rtcNewGeometry(s.device, RTC_GEOMETRY_TYPE_TRIANGLE);
    auto* points = static_cast<float*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                                               3 * sizeof(float), surface.vertices.size()));
    auto* corners = static_cast<unsigned*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                                                   3 * sizeof(unsigned), surface.facets.size()));
    if (!points || !corners)
      throw MemoryError(fmt::format("not enough memory to draw a picture of {} triangles", surface.facets.size()));
    for (const Vec<3>& v : surface.vertices)
      for (int k = 0; k < 3; ++k) *points++ = static_cast<float>(s.scale * (v[k] - s.centre[k]));
    for (const auto& facet : surface.facets)
      for (const Index v : facet) *corners++ = static_cast<unsigned>(v);
    rtcCommitGeometry(geometry);
    rtcAttachGeometryByID(s.scene, geometry, static_cast<unsigned>(i));
    rtcReleaseGeometry(geometry);
  }
  rtcCommitScene(s.scene);
  if (const RTCError error = rtcGetDeviceError(s.device); error != RTC_ERROR_NONE) throw_embree_error(error);
}
RayScene::~RayScene() = default;
RayScene::RayScene(RayScene&&) noexcept = default;
RayScene& RayScene::operator=(RayScene&&) noexcept = default;

std::optional<RayHit> RayScene::first_hit(const Ray& ray) const {
  RTCRayHit query{};
  query.ray = state_->single(ray, 0, std::numeric_limits<double>::infinity());
  query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  query.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
  intersect(state_->scene, query);
  if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) return std::nullopt;
  return RayHit{static_cast<int>(query.hit.geomID), static_cast<Index>(query.hit.primID), query.hit.u, query.hit.v,
                query.ray.tfar / state_->scale};
}

bool RayScene::is_blocked(const Ray& ray, double near, double far) const {
  RTCRay query = state_->single(ray, near, far);
  occlude(state_->scene, query);
  return query.tfar < 0;
}

}  // namespace shellmatch

#include "tests/bench/own_code/alternatives.h"
#include "geometry/surface/facet_point.h"

#if __has_include(<embree4/rtcore.h>)
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

#include <limits>

namespace shellmatch::own_code {

namespace {

struct Scene {
  RTCDevice device = rtcNewDevice("threads=1");
  RTCScene scene = rtcNewScene(device);
  const Surface<3>* surface = nullptr;

  Scene() = default;
  Scene(const Scene&) = delete;
  Scene& operator=(const Scene&) = delete;
  ~Scene() {
    rtcReleaseScene(scene);
    rtcReleaseDevice(device);
  }
};

struct Nearest {
  const Surface<3>* surface;
  Vec<3> point;
  double distance;
};

// Boxes are of single precision: the radius within which Embree goes on is rounded up by more than their error.
bool visit(RTCPointQueryFunctionArguments* arguments) {
  auto& nearest = *static_cast<Nearest*>(arguments->userPtr);
  const auto facet = static_cast<Index>(arguments->primID);
  const double distance =
      (closest_point_on_facet<3>(*nearest.surface, facet, nearest.point).point - nearest.point).norm();
  if (!(distance < nearest.distance)) return false;
  nearest.distance = distance;
  arguments->query->radius = static_cast<float>(distance * (1 + 1e-6) + 1e-6);
  return true;
}

}  // namespace

Distance embree_distance(const Surface<3>& surface) {
  const auto s = std::make_shared<Scene>();
  s->surface = &surface;
  rtcSetSceneFlags(s->scene, RTC_SCENE_FLAG_ROBUST);
  rtcSetSceneBuildQuality(s->scene, RTC_BUILD_QUALITY_HIGH);
  const RTCGeometry geometry = rtcNewGeometry(s->device, RTC_GEOMETRY_TYPE_TRIANGLE);
  auto* vertices = static_cast<float*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                                               3 * sizeof(float), surface.vertices.size()));
  for (const Vec<3>& v : surface.vertices)
    for (int k = 0; k < 3; ++k) *vertices++ = static_cast<float>(v[k]);
  auto* corners = static_cast<unsigned*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                                                 3 * sizeof(unsigned), surface.facets.size()));
  for (const auto& f : surface.facets)
    for (const Index v : f) *corners++ = static_cast<unsigned>(v);
  rtcSetGeometryPointQueryFunction(geometry, visit);
  rtcCommitGeometry(geometry);
  rtcAttachGeometry(s->scene, geometry);
  rtcReleaseGeometry(geometry);
  rtcCommitScene(s->scene);
  return [s](const Vec<3>& x) {
    RTCPointQuery query{};
    query.x = static_cast<float>(x.x());
    query.y = static_cast<float>(x.y());
    query.z = static_cast<float>(x.z());
    query.radius = std::numeric_limits<float>::infinity();
    RTCPointQueryContext context;
    rtcInitPointQueryContext(&context);
    Nearest nearest{s->surface, x, std::numeric_limits<double>::infinity()};
    rtcPointQuery(s->scene, &query, &context, nullptr, &nearest);
    return nearest.distance;
  };
}

}  // namespace shellmatch::own_code

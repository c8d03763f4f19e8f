#!/bin/sh
# Coin 4.0.0 (Debian 12): after SbViewVolume::transform() by a matrix that scales by s, the volume is wrong: a perspective one from 1 to 10, scaled
# by 2, goes from 2 to 10 and not to 20, and points come out twice as far from the centre of the screen; a parallel one goes to 38.
# SbDPViewVolume::transform() sets the near distance, depth and corners anew, and rightly, but multiplies projDir by the matrix and leaves it at
# length s, where all else takes a unit vector: getPlaneRectangle(), whose corners make the far plane, divides by its part along the rays or
# multiplies by it; getMatrices() has it for an axis of the camera, so that depths are divided by s; getSightPoint(d) is s d away. So boxes and points
# that are in the volume fail intersect(), and others pass. SoCamera makes such volumes from the scale of the groups above it, for SoViewVolumeElement
# and SoCullElement. Picking through that camera in a scene is right. Turning, shifting and s = 1 do not show it. Nothing is said.
set -eu
version=4.0.0+ds-3
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
apt-get download -qq "libcoin-dev=$version" "libcoin80c=$version" libexpat1 libglx0 libopengl0 libglvnd0 libx11-6 libxcb1 libxau6 libxdmcp6 libbsd0 libmd0 \
  2> /dev/null
for package in *.deb; do dpkg -x "$package" root; done
lib=$(dirname "$(find root -name 'libCoin.so')")
cat > scaled.cpp <<'C'
#include <Inventor/C/basic.h>
#include <Inventor/SbMatrix.h>
#include <Inventor/SbPlane.h>
#include <Inventor/SbRotation.h>
#include <Inventor/SbViewVolume.h>
#include <Inventor/SoDB.h>
#include <Inventor/SoPickedPoint.h>
#include <Inventor/actions/SoRayPickAction.h>
#include <Inventor/nodes/SoOrthographicCamera.h>
#include <Inventor/nodes/SoPerspectiveCamera.h>
#include <Inventor/nodes/SoScale.h>
#include <Inventor/nodes/SoSeparator.h>
#include <Inventor/nodes/SoSphere.h>
#include <Inventor/nodes/SoTranslation.h>
#include <cmath>
#include <cstdio>
#include <initializer_list>
static bool same(double a, double b) { return std::abs(a - b) < 1e-4 * (1 + std::abs(b)); }
// Whether the same camera, below a scale in a scene, sees a small ball at this depth.
static bool picked(bool parallel, float s, float depth) {
  SoSeparator* scene = new SoSeparator;
  scene->ref();
  SoScale* scale = new SoScale;
  scale->scaleFactor.setValue(s, s, s);
  SoCamera* camera = parallel ? (SoCamera*)new SoOrthographicCamera : (SoCamera*)new SoPerspectiveCamera;
  camera->position.setValue(0, 0, 0);
  camera->nearDistance = 1;
  camera->farDistance = 10;
  camera->viewportMapping = SoCamera::LEAVE_ALONE;
  SoScale* back = new SoScale;
  back->scaleFactor.setValue(1 / s, 1 / s, 1 / s);
  SoTranslation* place = new SoTranslation;
  place->translation.setValue(0, 0, -depth);
  SoSphere* ball = new SoSphere;
  ball->radius = .01f;
  for (SoNode* node : std::initializer_list<SoNode*>{scale, camera, back, place, ball}) scene->addChild(node);
  SoRayPickAction action(SbViewportRegion(100, 100));
  action.setNormalizedPoint(SbVec2f(.5f, .5f));
  action.apply(scene);
  const bool seen = action.getPickedPoint() != nullptr;
  scene->unref();
  return seen;
}
int main() {
  SoDB::init();
  std::printf("Coin %s\n", COIN_VERSION);
  bool as_described = true;
  for (int parallel = 0; parallel < 2; ++parallel)
    for (float s : {1.f, 2.f, .5f, 1.2f}) {
      SbViewVolume view;
      if (parallel) view.ortho(-1, 1, -1, 1, 1, 10);
      else view.perspective(M_PI / 2, 1, 1, 10);
      SbMatrix matrix;
      matrix.setScale(s);
      view.transform(matrix);
      SbPlane planes[6];
      view.getViewVolumePlanes(planes);
      const double far_plane = std::abs(planes[5].getDistanceFromOrigin());
      const double near_plane = std::abs(planes[4].getDistanceFromOrigin());
      const double expected = parallel ? s + 9 * s * s : 10;
      // The end of the view, and a point that is to be seen at 0.625 of the screen, or at 0.75 for the parallel view.
      SbVec3f end, place;
      view.getMatrix().multVecMatrix(SbVec3f(0, 0, -10 * s), end);
      view.projectToScreen(SbVec3f(s / (parallel ? 2 : 1), 0, -4 * s), place);
      const double end_expected = parallel ? (20 - 11 * s) / (9 * s) : 11 / 9. - 2 * s / 9;
      std::printf("%s view from 1 to 10, times %g: near %g, depth %g, planes at %g and %g; depth of the end on the screen %.4f, point at %.4f for %.4f\n",
                  parallel ? "parallel" : "perspective", s, view.getNearDist(), view.getDepth(), near_plane, far_plane, end[2], place[0], parallel ? .75 : .625);
      std::printf("  direction of length %g, point at 3 is at %g\n", view.getProjectionDirection().length(), -view.getSightPoint(3)[2]);
      int points = 0, wrong = 0, wrong_boxes = 0, right_in_scene = 0, outside = 0;
      for (int i = 0; i < 100; ++i) {
        const float depth = .3f + .5f * i;
        const bool within = depth > s && depth < 10 * s;
        ++points;
        wrong += view.intersect(SbVec3f(0, 0, -depth)) != within;
        wrong_boxes += view.intersect(SbBox3f(-.01f, -.01f, -depth - .01f, .01f, .01f, -depth + .01f)) != within;
        outside += depth > s && (depth < expected) != (depth < 10 * s);
        right_in_scene += picked(parallel, s, depth) == within;
      }
      std::printf("  of %d depths up to 50: wrong for points %d, for boxes %d; picked rightly in a scene %d\n", points, wrong, wrong_boxes, right_in_scene);
      // Wrong: the far plane, the depths of the matrix and with them the places on the screen. Right: distances, near plane, picking, and all without a scale.
      as_described = as_described && same(view.getProjectionDirection().length(), s) && same(-view.getSightPoint(3)[2], 3 * s) && same(far_plane, expected) &&
                     wrong == outside && wrong_boxes == outside && (s == 1) == (wrong == 0) && same(end[2], end_expected) &&
                     same(place[0], parallel ? .75 : .5 + s / 8);
      as_described = as_described && same(view.getNearDist(), s) && same(view.getDepth(), 9 * s) && same(near_plane, s) && right_in_scene == points;
    }
  return as_described ? 0 : 1;
}
C
g++ -O1 -w -Iroot/usr/include scaled.cpp -o scaled -L"$lib" -Wl,-rpath-link,"$lib" -lCoin
LD_LIBRARY_PATH=$lib ./scaled

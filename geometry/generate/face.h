#pragma once
/// \file
/// A head with a simple face. It looks along +z; y points up.

#include "base/options.h"
#include "geometry/generate/body.h"

namespace shellmatch {

struct FaceOptions {
  double smile = 0;
  double nose = 1;
  double brow = 1;
  double jaw = 1;
  double width = 1;
  double ears = 1;
  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    visit("smile", self.smile,
          {.min = 0, .max = 1, .meaning = "lift and width of the corners of the mouth, and cheeks"});
    visit("nose", self.nose, {.min = 0.6, .max = 1.5, .meaning = "factor on the size of the nose"});
    visit("brow", self.brow, {.min = 0.5, .max = 1.4, .meaning = "factor on the thickness of the brows"});
    visit("jaw", self.jaw, {.min = 0.8, .max = 1.2, .meaning = "factor on the width of the jaw"});
    visit("width", self.width, {.min = 0.85, .max = 1.15, .meaning = "factor on the width of the skull"});
    visit("ears", self.ears, {.min = 0.7, .max = 1.3, .meaning = "factor on the size of the ears"});
  }
};

/// Rest shape: the posed shape itself (the pose is the identity): faces do not correspond point by point.
Body<3> face_body(const FaceOptions& options, double edge_length);

}  // namespace shellmatch

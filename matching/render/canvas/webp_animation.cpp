#include "base/error.h"
#include "matching/render/canvas/animation.h"

#include <webp/encode.h>
#include <webp/mux.h>

#include <algorithm>
#include <cmath>
#include <new>

namespace shellmatch {

struct Animation::State {
  WebPConfig config;
  WebPAnimEncoder* encoder = nullptr;
  int width = 0, height = 0;
  double seconds = 0;  // from the begin to the end of the last picture
  int end = 0;         // the same, in milliseconds

  State() = default;
  State(const State&) = delete;
  State& operator=(const State&) = delete;
  ~State() { WebPAnimEncoderDelete(encoder); }
};

namespace {

constexpr const char* same_library = "libwebp must be the one whose headers were compiled";

struct OwnPicture {
  WebPPicture picture;
  OwnPicture() { SHELLMATCH_CHECK(WebPPictureInit(&picture), same_library); }
  OwnPicture(const OwnPicture&) = delete;
  OwnPicture& operator=(const OwnPicture&) = delete;
  ~OwnPicture() { WebPPictureFree(&picture); }
};

struct OwnData {
  WebPData data;
  OwnData() { WebPDataInit(&data); }
  OwnData(const OwnData&) = delete;
  OwnData& operator=(const OwnData&) = delete;
  ~OwnData() { WebPDataClear(&data); }
};

// The library tells its reason in words that end in the number of a WebPEncodingError, where it is one.
[[noreturn]] void fail_to_encode(WebPAnimEncoder* encoder) {
  const std::string reason = WebPAnimEncoderGetError(encoder);
  const bool is_too_large = std::strstr(reason.c_str(), "WebPEncodingError: ") != nullptr &&
                            !reason.ends_with(": 1.") && !reason.ends_with(": 2.");
  if (is_too_large) throw_input_error("the animation cannot be encoded ({}); fewer or smaller pictures can", reason);
  throw std::bad_alloc();
}

}  // namespace

Animation::Animation(int quality) : state_(std::make_unique<State>()) {
  WebPConfig& config = state_->config;
  SHELLMATCH_CHECK(quality >= 1 && quality <= 100, "the quality must be within its range");
  SHELLMATCH_CHECK(WebPConfigInit(&config), same_library);
  config.quality = static_cast<float>(quality);
  config.use_sharp_yuv = 1;  // colours are kept at half of the resolution: edges of checks and letters stay clear
  if (quality == 100) {
    config.lossless = 1;
    config.quality = 75;
  }  // which then is the effort
}
Animation::~Animation() = default;
Animation::Animation(Animation&&) noexcept = default;
Animation& Animation::operator=(Animation&&) noexcept = default;

void Animation::add(const Image& picture, double seconds) {
  State& s = *state_;
  if (std::max(picture.width, picture.height) > largest_side)
    throw_input_error("an animation of {} x {} pixels: the format ends at {} a side; choose smaller pictures",
                      picture.width, picture.height, largest_side);
  if (s.encoder == nullptr) {
    WebPAnimEncoderOptions options;
    SHELLMATCH_CHECK(WebPAnimEncoderOptionsInit(&options), same_library);
    // Pictures that are coded as differences keep, of the one before, what is similar: remains of it stay visible as
    // blocks. Each by itself is hardly longer.
    if (!s.config.lossless) {
      options.kmax = 1;
      options.kmin = 0;
    }
    s.width = picture.width;
    s.height = picture.height;
    s.encoder = WebPAnimEncoderNew(s.width, s.height, &options);
    if (s.encoder == nullptr) throw std::bad_alloc();
  }
  SHELLMATCH_CHECK(picture.width == s.width && picture.height == s.height,
                   "pictures of an animation must have one size");
  OwnPicture frame;
  frame.picture.use_argb = 1;
  frame.picture.width = s.width;
  frame.picture.height = s.height;
  if (!WebPPictureImportRGB(&frame.picture, picture.pixels.data(), 3 * s.width)) throw std::bad_alloc();
  if (!WebPAnimEncoderAdd(s.encoder, &frame.picture, s.end, &s.config)) fail_to_encode(s.encoder);
  s.seconds += seconds;
  s.end = std::max(s.end + 1, static_cast<int>(std::lround(1000 * s.seconds)));
}

std::string Animation::bytes() {
  State& s = *state_;
  SHELLMATCH_CHECK(s.encoder != nullptr, "an animation needs a picture");
  OwnData file;
  if (!WebPAnimEncoderAdd(s.encoder, nullptr, s.end, nullptr) || !WebPAnimEncoderAssemble(s.encoder, &file.data))
    fail_to_encode(s.encoder);
  return {reinterpret_cast<const char*>(file.data.bytes), file.data.size};
}

}  // namespace shellmatch

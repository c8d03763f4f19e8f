#include "tests/matching/render/decoded_animation.h"

#include <webp/demux.h>

#include <cstdint>

namespace shellmatch::testing {

DecodedAnimation decoded_animation(const std::string& bytes) {
  DecodedAnimation result;
  const WebPData data{reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()};
  WebPAnimDecoder* decoder = WebPAnimDecoderNew(&data, nullptr);
  WebPAnimInfo info;
  if (decoder == nullptr || !WebPAnimDecoderGetInfo(decoder, &info)) return result;
  result.n_loops = static_cast<int>(info.loop_count);
  const int width = static_cast<int>(info.canvas_width), height = static_cast<int>(info.canvas_height);
  std::uint8_t* pixels = nullptr;
  int end = 0;
  while (WebPAnimDecoderHasMoreFrames(decoder) && WebPAnimDecoderGetNext(decoder, &pixels, &end)) {
    Image picture(width, height);
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x)
        for (int k = 0; k < 3; ++k) picture.at(x, y)[k] = pixels[4 * (static_cast<std::size_t>(y) * width + x) + k];
    result.pictures.push_back(std::move(picture));
    result.ends.push_back(end);
  }
  WebPAnimDecoderDelete(decoder);
  return result;
}

}  // namespace shellmatch::testing

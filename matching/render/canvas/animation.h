#pragma once
/// \file
/// An animation as one file that browsers show: animated WebP. The adapter of libwebp is its implementation.

#include "matching/render/canvas/image.h"

#include <memory>
#include <string>

namespace shellmatch {

/// Pictures one after the other, repeated for ever. The same pictures give the same bytes.
class Animation {
 public:
  static constexpr int largest_side = 16383;  ///< of a picture in pixels, by the format

  /// \param quality  1 to 100: the larger, the nearer to the pictures and the longer the file; 100 keeps every pixel as
  /// it is
  explicit Animation(int quality);
  ~Animation();
  Animation(Animation&&) noexcept;
  Animation& operator=(Animation&&) noexcept;

  /// The next picture, which stays for these seconds (kept in milliseconds, at least one). One that equals the picture
  /// before prolongs it. \pre all pictures have one size \throws InputError where a side is longer than largest_side
  void add(const Image& picture, double seconds);

  /// The bytes of the file. Nothing can be added after that. \pre a picture was added
  std::string bytes();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace shellmatch

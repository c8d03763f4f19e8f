#include "matching/report/page.h"

#include "base/error.h"
#include "matching/render/surfaces/camera.h"

namespace shellmatch {

std::string filled_page(std::string_view page, std::string_view data, std::string_view arrays) {
  static constexpr std::string_view data_mark = "<!-- data -->", arrays_mark = "<!-- arrays -->";
  const std::size_t at_data = page.find(data_mark), at_arrays = page.find(arrays_mark);
  SHELLMATCH_CHECK(at_data < at_arrays && at_arrays != std::string_view::npos, "a page has places for its data");
  std::string filled;
  filled.reserve(page.size() + data.size() + arrays.size());
  filled += page.substr(0, at_data);
  filled += data;
  filled += page.substr(at_data + data_mark.size(), at_arrays - at_data - data_mark.size());
  filled += arrays;
  filled += page.substr(at_arrays + arrays_mark.size());
  return filled;
}

PageView page_view(std::span<const Surface<3>* const> surfaces) {
  const Camera camera = fit_camera(surfaces, 1);
  const auto array_of = [](const Vec<3>& x) { return std::array{x[0], x[1], x[2]}; };
  return {array_of(camera.target), array_of(camera.up), array_of(camera.backward), camera.half_height};
}

}  // namespace shellmatch

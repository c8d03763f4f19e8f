#include "matching/report/filled_page.h"

#include "base/error.h"

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

}  // namespace shellmatch

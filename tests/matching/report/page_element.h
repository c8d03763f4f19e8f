#pragma once
/// \file
/// What a report holds as data, for tests.

#include <string>

namespace shellmatch::testing {

/// The text of the `script` with this id in report.html.
inline std::string page_element(const std::string& page, const std::string& id) {
  const std::size_t begin = page.find('>', page.find("id=\"" + id + "\"")) + 1;
  return page.substr(begin, page.find("</script>", begin) - begin);
}

}  // namespace shellmatch::testing

#include "matching/generated_source.h"

#include "geometry/generate_shape.h"

namespace shellmatch {

namespace {

const std::string prefix = "generate:";

}  // namespace

bool is_generated_source(const std::string& source) { return source.starts_with(prefix); }

std::pair<std::string, std::string> split_variant(const std::string& text) {
  const std::size_t slash = text.find('/');
  return slash == std::string::npos ? std::pair(text, std::string())
                                    : std::pair(text.substr(0, slash), text.substr(slash + 1));
}

std::variant<OriginalShape<2>, OriginalShape<3>> generated_original(const std::string& source) {
  const auto [name, variant] = split_variant(source.substr(prefix.size()));
  return generate_shape(name, variant);
}

std::optional<AnyExactShape> generated_formula(const std::string& source) {
  const auto [name, variant] = split_variant(source.substr(prefix.size()));
  return exact_shape(name, variant);
}

}  // namespace shellmatch

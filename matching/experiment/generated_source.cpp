#include "matching/experiment/generated_source.h"

#include "geometry/generate/generate_shape.h"

namespace shellmatch {

namespace {

const std::string scheme = "generate:";

}  // namespace

bool is_generated_source(const std::string& source) { return source.starts_with(scheme); }

std::pair<std::string, std::string> split_variant(const std::string& text) {
  const std::size_t slash = text.find('/');
  return slash == std::string::npos ? std::pair(text, std::string())
                                    : std::pair(text.substr(0, slash), text.substr(slash + 1));
}

void check_generated_source(const std::string& source) {
  const auto [name, variant] = split_variant(source.substr(scheme.size()));
  constexpr double coarse = 0.05;  // upper bound of the edge lengths, for speed
  generate_shape(name, variant, coarse);
}

std::variant<OriginalShape<2>, OriginalShape<3>> generated_original(const std::string& source) {
  const auto [name, variant] = split_variant(source.substr(scheme.size()));
  return generate_shape(name, variant);
}

std::optional<AnyExactShape> generated_formula(const std::string& source) {
  const auto [name, variant] = split_variant(source.substr(scheme.size()));
  return exact_shape(name, variant);
}

template <int Dim>
std::vector<std::pair<Index, Vec<Dim>>> generated_correspondence(const std::string& reference,
                                                                 const std::string& template_shape) {
  std::vector<std::pair<Index, Vec<Dim>>> pairs;
  if (!is_generated_source(reference) || !is_generated_source(template_shape)) return pairs;
  const auto [name, from] = split_variant(reference.substr(scheme.size()));
  const auto [other, to] = split_variant(template_shape.substr(scheme.size()));
  if (name != other) return pairs;
  const AnyKnownPositions known = known_positions(name, from, to);
  for (const auto& [vertex, position] : std::get<KnownPositions<Dim>>(known)) pairs.emplace_back(vertex, position);
  return pairs;
}

SHELLMATCH_2D_3D(generated_correspondence);

}  // namespace shellmatch

#include "energies/node_matrix.h"

#include "base/error.h"
#include "base/parallel.h"

#include <algorithm>
#include <cstring>

namespace shellmatch {

namespace {

constexpr std::size_t rows_per_chunk = 1024;

// One column of a block: Dim entries, and what follows them where that makes a whole register.
template <int Dim>
struct BlockColumn;
template <>
struct BlockColumn<2> {
  static constexpr int width = 2;
  typedef float Floats __attribute__((vector_size(8)));
  typedef double Doubles __attribute__((vector_size(16)));
};
template <>
struct BlockColumn<3> {
  static constexpr int width = 4;
  typedef float Floats __attribute__((vector_size(16)));
  typedef double Doubles __attribute__((vector_size(32)));
};

// A block and what follows it, and where its transpose finds its entries.
typedef float WideBlock __attribute__((vector_size(64)));
typedef int WideIndex __attribute__((vector_size(64)));
template <int Dim>
constexpr WideIndex transposed = Dim == 2 ? WideIndex{0, 2, 1, 3} : WideIndex{0, 3, 6, 1, 4, 7, 2, 5, 8};

template <int Dim>
typename BlockColumn<Dim>::Doubles read_column(const float* from) {
  typename BlockColumn<Dim>::Floats f;
  std::memcpy(&f, from, sizeof f);
  return __builtin_convertvector(f, typename BlockColumn<Dim>::Doubles);
}

}  // namespace

template <int Dim>
NodeMatrix<Dim>::NodeMatrix(const Unknowns<Dim>& unknowns) : unknowns_(&unknowns) {
  const std::size_t n = unknowns.nodes().size();
  std::vector<std::vector<Index>> of_chunk(n_chunks(n, rows_per_chunk));
  first_.assign(n + 1, 0);
  parallel_chunks(n, rows_per_chunk, [&](const Chunk& chunk) {
    std::vector<Index>& found = of_chunk[chunk.index];
    static thread_local std::vector<char> is_found;  // by column, for the row at work; all false between rows
    is_found.resize(std::max(is_found.size(), n), 0);
    std::vector<Index> row;
    for (std::size_t i = chunk.begin; i < chunk.end; ++i) {
      row.clear();
      for (const auto& place : unknowns.places_of(i))
        for (const Index node :
             unknowns.elements()[static_cast<std::size_t>(place.element_corner) / n_corners<Dim>].nodes)
          for (const auto& carrier : unknowns.carriers_of(node)) {
            if (is_found[carrier.unknown]) continue;
            is_found[carrier.unknown] = 1;
            row.push_back(carrier.unknown);
          }
      for (const Index column : row) is_found[column] = 0;
      std::sort(row.begin(), row.end());
      first_[i + 1] = row.size();
      found.insert(found.end(), row.begin(), row.end());
    }
  });
  for (std::size_t i = 0; i < n; ++i) first_[i + 1] += first_[i];
  columns_.reserve(first_.back());
  for (const auto& found : of_chunk) columns_.insert(columns_.end(), found.begin(), found.end());
}

template <int Dim>
void NodeMatrix<Dim>::assemble(const ElementMatrices<Dim>& elements) {
  const std::size_t n_values = columns_.size() * block_size + BlockColumn<Dim>::width;
  if (!values_) {
    values_ = std::make_unique_for_overwrite<float[]>(n_values);  // its pages are the threads' to touch first
    std::fill_n(values_.get() + columns_.size() * block_size, BlockColumn<Dim>::width, 0.0f);
  }
  const std::size_t n = unknowns_->nodes().size();
  parallel_chunks(n, rows_per_chunk, [&](const Chunk& chunk) {
    static thread_local std::vector<Index> place;  // of a column within the row at work
    place.resize(std::max(place.size(), n));
    std::vector<WideBlock> row;
    for (std::size_t i = chunk.begin; i < chunk.end; ++i) {
      const std::size_t n_blocks = first_[i + 1] - first_[i];
      for (std::size_t j = 0; j < n_blocks; ++j) place[columns_[first_[i] + j]] = static_cast<Index>(j);
      row.assign(n_blocks, WideBlock{});
      for (const auto& at : unknowns_->places_of(i)) {
        const auto e = static_cast<std::size_t>(at.element_corner) / n_corners<Dim>;
        const int c = static_cast<int>(at.element_corner % n_corners<Dim>);
        const auto& matrix = elements[e];
        for (int d = 0; d < n_corners<Dim>; ++d) {
          WideBlock block;
          std::memcpy(&block, matrix.data() + ElementMatrices<Dim>::block(std::min(c, d), std::max(c, d)),
                      sizeof block);
          if (c > d) block = __builtin_shuffle(block, transposed<Dim>);
          for (const auto& carrier : unknowns_->carriers_of(unknowns_->elements()[e].nodes[d]))
            row[place[carrier.unknown]] += at.weight * carrier.weight * block;
        }
      }
      float* to = values_.get() + first_[i] * block_size;
      for (const WideBlock& block : row) {
        std::memcpy(to, &block, block_size * sizeof(float));
        to += block_size;
      }
    }
  });
}

template <int Dim>
std::size_t NodeMatrix<Dim>::place_of(Index row, Index column) const {
  const auto begin = columns_.begin() + static_cast<std::ptrdiff_t>(first_[row]);
  const auto end = columns_.begin() + static_cast<std::ptrdiff_t>(first_[row + 1]);
  const auto found = std::lower_bound(begin, end, column);
  SHELLMATCH_CHECK(found != end && *found == column, "unknowns that share no element");
  return static_cast<std::size_t>(found - columns_.begin());
}

template <int Dim>
void NodeMatrix<Dim>::add_isotropic(std::size_t e, double factor,
                                    const std::array<std::array<double, n_corners<Dim>>, n_corners<Dim>>& k) {
  const auto& nodes = unknowns_->elements()[e].nodes;
  for (int c = 0; c < n_corners<Dim>; ++c)
    for (const auto& row : unknowns_->carriers_of(nodes[c]))
      for (int d = 0; d < n_corners<Dim>; ++d)
        for (const auto& column : unknowns_->carriers_of(nodes[d])) {
          float* block = values_.get() + place_of(row.unknown, column.unknown) * block_size;
          const double x = factor * static_cast<double>(row.weight * column.weight) * k[c][d];
          for (int a = 0; a < Dim; ++a) block[a * Dim + a] += static_cast<float>(x);
        }
}

template <int Dim>
void NodeMatrix<Dim>::multiply(std::span<const double> x, std::span<double> y) const {
  parallel_chunks(unknowns_->nodes().size(), rows_per_chunk, [&](const Chunk& chunk) {
    for (std::size_t i = chunk.begin; i < chunk.end; ++i) {
      // A sum for each component of x: none waits for the one before.
      std::array<typename BlockColumn<Dim>::Doubles, Dim> sums{};
      const float* value = values_.get() + first_[i] * block_size;
      for (std::size_t j = first_[i]; j < first_[i + 1]; ++j, value += block_size) {
        const double* from = x.data() + static_cast<std::size_t>(columns_[j]) * Dim;
        for (int k = 0; k < Dim; ++k) sums[k] += read_column<Dim>(value + k * Dim) * from[k];
      }
      for (int k = 1; k < Dim; ++k) sums[0] += sums[k];
      for (int k = 0; k < Dim; ++k) y[i * Dim + k] = sums[0][k];
    }
  });
}

template <int Dim>
Mat<Dim> NodeMatrix<Dim>::diagonal(std::size_t i) const {
  const float* block = values_.get() + place_of(static_cast<Index>(i), static_cast<Index>(i)) * block_size;
  Mat<Dim> m;
  for (int l = 0; l < Dim; ++l)
    for (int k = 0; k < Dim; ++k) m(k, l) = static_cast<double>(block[l * Dim + k]);
  return m;
}

template class NodeMatrix<2>;
template class NodeMatrix<3>;

}  // namespace shellmatch

#include "energies/sparse/node_matrix.h"

#include "base/error.h"
#include "base/parallel.h"
#include "energies/sparse/node_blocks.h"

#include <algorithm>
#include <cstring>

namespace shellmatch {

namespace {

// So many blocks before its turn comes, what is read and written for a block is asked for: it takes as long as a few
// rows to come from memory.
constexpr std::ptrdiff_t n_ahead = 64;

std::size_t rows_per_slab(std::size_t n_rows) { return std::clamp<std::size_t>(n_rows / 64, 64, 512); }

}  // namespace

template <int Dim>
NodeMatrix<Dim>::NodeMatrix(const Unknowns<Dim>& unknowns)
    : unknowns_(&unknowns), rows_per_slab_(rows_per_slab(unknowns.nodes().size())) {
  const std::size_t n = unknowns.nodes().size(), n_slabs = n_chunks(n, rows_per_slab_);
  std::vector<std::vector<Index>> of_slab(n_slabs), reached(n_slabs);
  first_.assign(n + 1, 0);
  parallel_chunks(n, rows_per_slab_, [&](const Chunk& slab) {
    std::vector<Index>& found = of_slab[slab.index];
    static thread_local std::vector<char> is_found;  // by column, for the row at work; all false between rows
    is_found.resize(std::max(is_found.size(), n), 0);
    for (std::size_t i = slab.begin; i < slab.end; ++i) {
      const std::size_t begin = found.size();
      for (const auto& place : unknowns.places_of(i))
        for (const Index node :
             unknowns.elements()[static_cast<std::size_t>(place.element_corner) / n_corners<Dim>].nodes)
          for (const auto& carrier : unknowns.carriers_of(node)) {
            if (static_cast<std::size_t>(carrier.unknown) < i || is_found[carrier.unknown]) continue;
            is_found[carrier.unknown] = 1;
            found.push_back(carrier.unknown);
          }
      const auto row = found.begin() + static_cast<std::ptrdiff_t>(begin);
      for (auto column = row; column != found.end(); ++column) is_found[*column] = 0;
      std::sort(row, found.end());
      first_[i + 1] = found.size() - begin;
    }
    for (const Index column : found) {
      if (is_found[column]) continue;
      is_found[column] = 1;
      reached[slab.index].push_back(column);
    }
    for (const Index column : reached[slab.index]) is_found[column] = 0;
  });
  for (std::size_t i = 0; i < n; ++i) first_[i + 1] += first_[i];
  columns_.reserve(first_.back() + n_ahead);
  for (auto& found : of_slab) {
    columns_.insert(columns_.end(), found.begin(), found.end());
    found = {};
  }
  schedule_ = ColouredSchedule(n_slabs, n, [&](std::size_t s) -> std::span<const Index> { return reached[s]; });
  columns_.resize(first_.back() + n_ahead);
  std::fill(columns_.end() - n_ahead, columns_.end(), 0);
  find_places();
  values_.resize(first_.back() * block_size + BlockColumn<Dim>::width);
  std::fill(values_.end() - BlockColumn<Dim>::width, values_.end(), 0.0f);
}

template <int Dim>
void NodeMatrix<Dim>::find_places() {
  const std::size_t n = unknowns_->elements().size();
  first_place_.assign(n + 1, 0);
  parallel_for(n, [&](std::size_t e) {
    const auto m = static_cast<std::size_t>(carriers_of(*unknowns_, e).n);
    first_place_[e + 1] = m * (m + 1) / 2;
  });
  for (std::size_t e = 0; e < n; ++e) first_place_[e + 1] += first_place_[e];
  places_.resize(first_place_.back());
  parallel_for(n, [&](std::size_t e) {
    const auto carriers = carriers_of(*unknowns_, e);
    std::uint8_t* place = places_.data() + first_place_[e];
    for (int i = 0; i < carriers.n; ++i)
      for (int j = i; j < carriers.n; ++j) {
        const auto [row, column] = std::minmax(carriers.unknown[i], carriers.unknown[j]);
        const auto begin = columns_.begin() + static_cast<std::ptrdiff_t>(first_[row]);
        const auto end = columns_.begin() + static_cast<std::ptrdiff_t>(first_[row + 1]);
        const auto found = std::lower_bound(begin, end, column);
        // On a balanced tree all that shares an element with a node lies within the cells around it: 125 nodes.
        SHELLMATCH_CHECK(found != end && *found == column && found - begin < 256, "a row's columns");
        *place++ = static_cast<std::uint8_t>(found - begin);
      }
  });
}

template <int Dim>
void NodeMatrix<Dim>::add(const CellBlocks<Dim>& cell_blocks, const Chunk& cells, const ElementMatrices<Dim>& of_block) {
  const auto rows = cell_blocks.rows(cells.index);
  static thread_local std::vector<float*> values_of;  // by row of the block
  values_of.clear();
  for (const auto& row : rows) {
    float* begin = values_.data() + first_[row.unknown] * block_size;
    if (row.is_first) std::fill(begin, values_.data() + first_[row.unknown + 1] * block_size, 0.0F);
    values_of.push_back(begin);
  }
  const std::uint8_t* place = places_.data() + first_place_[cells.begin];
  const auto put = [&](std::size_t a, std::size_t b, const WideBlock& block) {  // rows ascend with their unknowns
    add_block<Dim>(turned_if<Dim>(a > b, block), values_of[std::min(a, b)] + *place++ * block_size);
  };
  for (std::size_t e = cells.begin; e < cells.end; ++e) {
    const auto& row_of = cell_blocks.rows_of_corners(e);
    const float* matrix = of_block[e - cells.begin].data();
    if (std::ranges::all_of(row_of, [&](std::size_t row) { return row < rows.size(); })) {  // nothing hangs
      for (int c = 0; c < n_corners<Dim>; ++c)
        for (int d = c; d < n_corners<Dim>; ++d, matrix += block_size) {
          WideBlock block;
          std::memcpy(&block, matrix, sizeof block);
          put(row_of[c], row_of[d], block);
        }
      continue;
    }
    Carriers<Dim, std::uint16_t> carriers;
    for (int c = 0; c < n_corners<Dim>; ++c) {
      if (row_of[c] < rows.size()) carriers.add(row_of[c], c, 1.0F);
      else
        for (const auto& share : cell_blocks.shares_of(cells.index, row_of[c] - rows.size()))
          carriers.add(share.row, c, share.weight);
    }
    const Condensed<Dim, std::uint16_t> condensed(carriers, matrix);
    for (int i = 0; i < carriers.n; ++i)
      for (int j = i; j < carriers.n; ++j) put(carriers.unknown[i], carriers.unknown[j], condensed.block(i, j));
  }
}

template <int Dim>
void NodeMatrix<Dim>::add_isotropic(std::size_t e, double factor,
                                    const std::array<std::array<double, n_corners<Dim>>, n_corners<Dim>>& k) {
  const auto carriers = carriers_of(*unknowns_, e);
  const std::uint8_t* place = places_.data() + first_place_[e];
  for (int i = 0; i < carriers.n; ++i)
    for (int j = i; j < carriers.n; ++j) {
      double sum = 0;
      for (const auto& a : carriers.corners_of(i))
        for (const auto& b : carriers.corners_of(j)) sum += static_cast<double>(a.weight * b.weight) * k[a.corner][b.corner];
      const auto row = static_cast<std::size_t>(std::min(carriers.unknown[i], carriers.unknown[j]));
      float* block = values_.data() + (first_[row] + *place++) * block_size;
      for (int l = 0; l < Dim; ++l) block[l * Dim + l] += static_cast<float>(factor * sum);
    }
}

template <int Dim>
void NodeMatrix<Dim>::add_product(std::size_t begin, std::size_t end, std::span<const double> x,
                                  std::span<double> y) const {
  using Column = BlockColumn<Dim>;
  using Doubles = typename Column::Doubles;
  const float* value = values_.data() + first_[begin] * block_size;
  for (std::size_t i = begin; i < end; ++i) {
    Doubles here{};  // an entry that fills up the register is 0
    for (int k = 0; k < Dim; ++k) here[k] = x[i * Dim + k];
    // A sum for each component of x: none waits for the one before.
    std::array<Doubles, Dim> sums;
    for (int k = 0; k < Dim; ++k) sums[k] = Column::read(value + k * Dim) * here[k];
    value += block_size;
    for (std::size_t j = first_[i] + 1; j < first_[i + 1]; ++j, value += block_size) {
      const double* there = x.data() + static_cast<std::size_t>(columns_[j]) * Dim;
      double* mirrored = y.data() + static_cast<std::size_t>(columns_[j]) * Dim;
      const auto later = static_cast<std::size_t>(columns_[j + n_ahead]) * Dim;
      __builtin_prefetch(x.data() + later);
      __builtin_prefetch(y.data() + later, 1);
      std::array<Doubles, Dim> products;
      for (int k = 0; k < Dim; ++k) {
        const Doubles column = Column::read(value + k * Dim);
        sums[k] += column * there[k];
        products[k] = column * here;
      }
      Column::add(Column::sums_of(products), mirrored);
    }
    for (int k = 1; k < Dim; ++k) sums[0] += sums[k];
    Column::add(sums[0], y.data() + i * Dim);
  }
}

template <int Dim>
void NodeMatrix<Dim>::multiply(std::span<const double> x, std::span<double> y) const {
  parallel_for(y.size(), [&](std::size_t i) { y[i] = 0; }, 1 << 16);
  const std::size_t n = first_.size() - 1;
  schedule_.run([&](std::size_t s) { add_product(s * rows_per_slab_, std::min(n, (s + 1) * rows_per_slab_), x, y); });
}

template <int Dim>
Mat<Dim> NodeMatrix<Dim>::diagonal(std::size_t i) const {
  const float* block = values_.data() + first_[i] * block_size;
  Mat<Dim> m;
  for (int l = 0; l < Dim; ++l)
    for (int k = 0; k < Dim; ++k) m(k, l) = static_cast<double>(block[l * Dim + k]);
  return m;
}

template class NodeMatrix<2>;
template class NodeMatrix<3>;

}  // namespace shellmatch

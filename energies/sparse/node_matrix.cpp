#include "energies/sparse/node_matrix.h"

#include "base/error.h"
#include "base/parallel.h"
#include "energies/sparse/condensed_matrix.h"

#include <algorithm>
#include <cstring>
#include <utility>

namespace shellmatch {

namespace {

// A product prefetches the entries of x and y that it needs this many blocks later: memory latency is as long as the
// product of a few rows.
constexpr std::ptrdiff_t prefetch_distance = 64;

// As cells_per_block().
std::size_t rows_per_slab(std::size_t n_rows) { return std::clamp<std::size_t>(n_rows / 256, 32, 512); }

/// The elements that depend on each unknown node, ascending.
struct ElementsOfUnknowns {
  std::vector<std::size_t> begin;  ///< elements of unknown node i: [begin[i], begin[i + 1])
  std::vector<Index> elements;

  template <int Dim>
  explicit ElementsOfUnknowns(const Unknowns<Dim>& unknowns) : begin(unknowns.nodes().size() + 1, 0) {
    std::vector<Index> last(unknowns.nodes().size());  // element that was visited for an unknown
    const auto for_each_pair = [&](auto&& visit) {
      std::fill(last.begin(), last.end(), Index{-1});
      for (Index e = 0; e < static_cast<Index>(unknowns.elements().size()); ++e)
        for (const Index node : unknowns.elements()[e].nodes)
          for (const ConstraintEntry& entry : unknowns.constraint_entries(node))
            if (std::exchange(last[entry.unknown], e) != e) visit(entry.unknown, e);
    };
    for_each_pair([&](Index unknown, Index) { ++begin[unknown + 1]; });
    for (std::size_t i = 1; i < begin.size(); ++i) begin[i] += begin[i - 1];
    elements.resize(begin.back());
    std::vector<std::size_t> next(begin.begin(), begin.end() - 1);
    for_each_pair([&](Index unknown, Index e) { elements[next[unknown]++] = e; });
  }
  std::span<const Index> operator[](std::size_t i) const {
    return {elements.data() + begin[i], begin[i + 1] - begin[i]};
  }
};

}  // namespace

template <int Dim>
NodeMatrix<Dim>::NodeMatrix(const Unknowns<Dim>& unknowns)
    : unknowns_(&unknowns), rows_per_slab_(rows_per_slab(unknowns.nodes().size())) {
  find_pattern();
  find_block_offsets();
  values_.resize(n_blocks() * block_size + BlockColumn<Dim>::width);
  std::fill(values_.end() - BlockColumn<Dim>::width, values_.end(), 0.0f);
}

template <int Dim>
void NodeMatrix<Dim>::find_pattern() {
  const std::size_t n = unknowns_->nodes().size(), n_slabs = n_chunks(n, rows_per_slab_);
  const ElementsOfUnknowns elements_of(*unknowns_);
  std::vector<std::vector<Index>> columns_of(n_slabs);   // row after row
  std::vector<std::vector<Index>> distinct_of(n_slabs);  // each column once
  row_begin_.assign(n + 1, 0);
  parallel_chunks(n, rows_per_slab_, [&](const Chunk& slab) {
    std::vector<Index>& columns = columns_of[slab.index];
    static thread_local std::vector<char> is_found;  // by column, for the current row; all false between rows
    is_found.resize(std::max(is_found.size(), n), 0);
    for (std::size_t i = slab.begin; i < slab.end; ++i) {
      const std::size_t begin = columns.size();
      for (const Index e : elements_of[i])
        for (const Index node : unknowns_->elements()[e].nodes)
          for (const ConstraintEntry& entry : unknowns_->constraint_entries(node)) {
            if (static_cast<std::size_t>(entry.unknown) < i || is_found[entry.unknown]) continue;
            is_found[entry.unknown] = 1;
            columns.push_back(entry.unknown);
          }
      const auto row = columns.begin() + static_cast<std::ptrdiff_t>(begin);
      for (auto column = row; column != columns.end(); ++column) is_found[*column] = 0;
      std::sort(row, columns.end());
      row_begin_[i + 1] = columns.size() - begin;
    }
    for (const Index column : columns)
      if (!std::exchange(is_found[column], 1)) distinct_of[slab.index].push_back(column);
    for (const Index column : distinct_of[slab.index]) is_found[column] = 0;
  });
  for (std::size_t i = 0; i < n; ++i) row_begin_[i + 1] += row_begin_[i];
  columns_.reserve(n_blocks() + prefetch_distance);
  for (auto& columns : columns_of) {
    columns_.insert(columns_.end(), columns.begin(), columns.end());
    columns = {};
  }
  columns_.resize(n_blocks() + prefetch_distance);
  std::fill(columns_.end() - prefetch_distance, columns_.end(), 0);
  schedule_ = ColouredSchedule(n_slabs, n, [&](std::size_t s) -> std::span<const Index> { return distinct_of[s]; });
}

template <int Dim>
void NodeMatrix<Dim>::find_block_offsets() {
  const std::size_t n = unknowns_->elements().size();
  offsets_begin_.assign(n + 1, 0);
  parallel_for(n, [&](std::size_t e) {
    const auto m = static_cast<std::size_t>(element_unknowns(*unknowns_, e).size());
    offsets_begin_[e + 1] = m * (m + 1) / 2;
  });
  for (std::size_t e = 0; e < n; ++e) offsets_begin_[e + 1] += offsets_begin_[e];
  block_offsets_.resize(offsets_begin_.back());
  parallel_for(n, [&](std::size_t e) {
    const auto unknowns = element_unknowns(*unknowns_, e);
    std::uint8_t* offset = block_offsets_.data() + offsets_begin_[e];
    for (int i = 0; i < unknowns.size(); ++i)
      for (int j = i; j < unknowns.size(); ++j) {
        const auto [row, column] = std::minmax({unknowns[i], unknowns[j]});
        const auto begin = columns_.begin() + static_cast<std::ptrdiff_t>(row_begin_[row]);
        const auto end = columns_.begin() + static_cast<std::ptrdiff_t>(row_begin_[row + 1]);
        const auto found = std::lower_bound(begin, end, column);
        // At most 125 columns: on a balanced tree the unknowns that share an element with a node are nodes of the cells
        // around it.
        SHELLMATCH_CHECK(found != end && *found == column && found - begin < 256, "a row's columns");
        *offset++ = static_cast<std::uint8_t>(found - begin);
      }
  });
}

template <int Dim>
void NodeMatrix<Dim>::add(const CellBlocks<Dim>& cell_blocks, const Chunk& cells,
                          const ElementMatrices<Dim>& of_block) {
  const auto local_unknowns = cell_blocks.local_unknowns(cells.index);
  static thread_local std::vector<float*> row_values;  // by local index of the row's unknown
  row_values.clear();
  for (const auto& local : local_unknowns) {
    float* begin = values_.data() + row_begin_[local.unknown] * block_size;
    if (local.is_first) std::fill(begin, values_.data() + row_begin_[local.unknown + 1] * block_size, 0.0F);
    row_values.push_back(begin);
  }
  const std::uint8_t* offset = block_offsets_.data() + offsets_begin_[cells.begin];
  const auto add_to = [&](std::size_t i, std::size_t j, const WideBlock& block) {  // local indices ascend with unknowns
    add_block<Dim>(transposed_if<Dim>(i > j, block), row_values[std::min(i, j)] + *offset++ * block_size);
  };
  for (std::size_t e = cells.begin; e < cells.end; ++e) {
    const auto& index_of = cell_blocks.local_indices(e);  // by corner
    const float* matrix = of_block[e - cells.begin].data();
    if (std::ranges::all_of(index_of, [&](std::size_t i) { return i < local_unknowns.size(); })) {  // C is the identity
      for (int c = 0; c < n_corners<Dim>; ++c)
        for (int d = c; d < n_corners<Dim>; ++d, matrix += block_size) {
          WideBlock block;
          std::memcpy(&block, matrix, sizeof block);
          add_to(index_of[c], index_of[d], block);
        }
      continue;
    }
    ElementUnknowns<Dim, std::uint16_t> unknowns;
    for (int c = 0; c < n_corners<Dim>; ++c) {
      if (index_of[c] < local_unknowns.size()) unknowns.add(index_of[c], c, 1.0F);
      else
        for (const auto& entry : cell_blocks.local_entries(cells.index, index_of[c] - local_unknowns.size()))
          unknowns.add(entry.local_index, c, entry.weight);
    }
    const CondensedMatrix<Dim, std::uint16_t> condensed(unknowns, matrix);
    for (int i = 0; i < unknowns.size(); ++i)
      for (int j = i; j < unknowns.size(); ++j) add_to(unknowns[i], unknowns[j], condensed.block(i, j));
  }
}

template <int Dim>
void NodeMatrix<Dim>::add_product(std::size_t begin, std::size_t end, std::span<const double> x,
                                  std::span<double> y) const {
  using Column = BlockColumn<Dim>;
  using Doubles = typename Column::Doubles;
  const float* value = values_.data() + row_begin_[begin] * block_size;
  for (std::size_t i = begin; i < end; ++i) {
    Doubles x_row{};  // zero in the padding
    for (int k = 0; k < Dim; ++k) x_row[k] = x[i * Dim + k];
    // One accumulator for each component of x, so that the additions do not depend on each other.
    std::array<Doubles, Dim> sums;
    for (int k = 0; k < Dim; ++k) sums[k] = Column::read(value + k * Dim) * x_row[k];
    value += block_size;
    for (std::size_t j = row_begin_[i] + 1; j < row_begin_[i + 1]; ++j, value += block_size) {
      const double* x_column = x.data() + static_cast<std::size_t>(columns_[j]) * Dim;
      double* y_column = y.data() + static_cast<std::size_t>(columns_[j]) * Dim;
      const auto later = static_cast<std::size_t>(columns_[j + prefetch_distance]) * Dim;
      __builtin_prefetch(x.data() + later);
      __builtin_prefetch(y.data() + later, 1);
      std::array<Doubles, Dim> products;
      for (int k = 0; k < Dim; ++k) {
        const Doubles column = Column::read(value + k * Dim);
        sums[k] += column * x_column[k];
        products[k] = column * x_row;
      }
      Column::add(Column::sums_of(products), y_column);
    }
    for (int k = 1; k < Dim; ++k) sums[0] += sums[k];
    Column::add(sums[0], y.data() + i * Dim);
  }
}

template <int Dim>
void NodeMatrix<Dim>::multiply(std::span<const double> x, std::span<double> y) const {
  parallel_for(
      y.size(), [&](std::size_t i) { y[i] = 0; }, 1 << 16);
  const std::size_t n = row_begin_.size() - 1;
  schedule_.run([&](std::size_t s) { add_product(s * rows_per_slab_, std::min(n, (s + 1) * rows_per_slab_), x, y); });
}

template <int Dim>
Mat<Dim> NodeMatrix<Dim>::diagonal(std::size_t i) const {
  const float* block = values_.data() + row_begin_[i] * block_size;
  Mat<Dim> m;
  for (int l = 0; l < Dim; ++l)
    for (int k = 0; k < Dim; ++k) m(k, l) = static_cast<double>(block[l * Dim + k]);
  return m;
}

template class NodeMatrix<2>;
template class NodeMatrix<3>;

}  // namespace shellmatch

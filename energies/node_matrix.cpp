#include "energies/node_matrix.h"

#include "base/error.h"
#include "base/parallel.h"

#include <algorithm>
#include <cstring>

namespace shellmatch {

namespace {

// One column of a block: Dim entries, and what follows them where that makes a whole register.
template <int Dim>
struct BlockColumn;
template <>
struct BlockColumn<2> {
  static constexpr int width = 2;
  typedef double Doubles __attribute__((vector_size(16)));
  static Doubles read(const float* from) { return Doubles{from[0], from[1]}; }
  static void add(const Doubles& x, double* to) {
    for (int k = 0; k < 2; ++k) to[k] += x[k];
  }
  // Entry k of the result is the sum of the entries of t[k].
  static Doubles sums_of(const std::array<Doubles, 2>& t) {
    return __builtin_shufflevector(t[0], t[1], 0, 2) + __builtin_shufflevector(t[0], t[1], 1, 3);
  }
};
template <>
struct BlockColumn<3> {
  static constexpr int width = 4;
  typedef double Doubles __attribute__((vector_size(32)));
  static Doubles read(const float* from) { return Doubles{from[0], from[1], from[2], from[3]}; }
  static void add(const Doubles& x, double* to) {
    typedef double Pair __attribute__((vector_size(16), aligned(8)));
    *reinterpret_cast<Pair*>(to) += Pair{x[0], x[1]};
    to[2] += x[2];
  }
  static Doubles sums_of(const std::array<Doubles, 3>& t) {
    const Doubles a = __builtin_shufflevector(t[0], t[1], 0, 4, 2, 6) + __builtin_shufflevector(t[0], t[1], 1, 5, 3, 7);
    const Doubles b = __builtin_shufflevector(t[2], t[2], 0, 0, 2, 2) + __builtin_shufflevector(t[2], t[2], 1, 1, 3, 3);
    return __builtin_shufflevector(a, b, 0, 1, 4, 5) + __builtin_shufflevector(a, b, 2, 3, 6, 7);
  }
};

// So many blocks before its turn comes, what is read and written for a block is asked for: it takes as long as a few
// rows to come from memory.
constexpr std::ptrdiff_t n_ahead = 64;

std::size_t rows_per_slab(std::size_t n_rows) { return std::clamp<std::size_t>(n_rows / 64, 64, 512); }

// A block and what follows it, and where its transpose finds its entries.
typedef float WideBlock __attribute__((vector_size(64)));
typedef int WideIndex __attribute__((vector_size(64)));
template <int Dim>
constexpr WideIndex transposed = Dim == 2 ? WideIndex{0, 2, 1, 3} : WideIndex{0, 3, 6, 1, 4, 7, 2, 5, 8};

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
  waves_ = Waves(n_slabs, n, [&](std::size_t s) -> std::span<const Index> { return reached[s]; });
  columns_.resize(first_.back() + n_ahead);
  std::fill(columns_.end() - n_ahead, columns_.end(), 0);
  values_.resize(first_.back() * block_size + BlockColumn<Dim>::width);
  std::fill(values_.end() - BlockColumn<Dim>::width, values_.end(), 0.0f);
}

template <int Dim>
void NodeMatrix<Dim>::add(const Patches<Dim>& patches, const Chunk& patch, const ElementMatrices<Dim>& of_patch) {
  const auto rows = patches.rows(patch.index);
  static thread_local std::vector<Index> row_of;  // by unknown: its row in the patch, anything if it has none there
  row_of.resize(std::max(row_of.size(), unknowns_->nodes().size()));
  for (std::size_t r = 0; r < rows.size(); ++r) row_of[rows[r].unknown] = static_cast<Index>(r);
  static thread_local std::vector<std::uint32_t> place;  // by row: of its column within the row at work
  place.resize(std::max(place.size(), rows.size()));
  static thread_local std::vector<WideBlock> sum;
  for (std::size_t r = 0; r < rows.size(); ++r) {
    const auto& row = rows[r];
    const auto i = static_cast<std::size_t>(row.unknown);
    const std::size_t n_blocks = first_[i + 1] - first_[i];
    for (std::size_t j = 0; j < n_blocks; ++j) {
      const Index column = columns_[first_[i] + j];
      const auto in_patch = static_cast<std::size_t>(row_of[column]);
      if (in_patch < rows.size() && rows[in_patch].unknown == column) place[in_patch] = static_cast<std::uint32_t>(j);
    }
    sum.assign(n_blocks, WideBlock{});
    for (const auto& at : patches.places_of(row)) {
      const auto e = static_cast<std::size_t>(at.element_corner) / n_corners<Dim>;
      const int c = static_cast<int>(at.element_corner % n_corners<Dim>);
      const auto& matrix = of_patch[e - patch.begin];
      const auto& columns = patches.rows_of_corners(e);
      const auto block_with = [&](int d) {
        WideBlock block;
        std::memcpy(&block, matrix.data() + ElementMatrices<Dim>::block(std::min(c, d), std::max(c, d)), sizeof block);
        return c > d ? __builtin_shuffle(block, transposed<Dim>) : block;
      };
      for (int d = 0; d < n_corners<Dim>; ++d) {
        const std::size_t column = columns[d];
        if (column < rows.size()) {
          // Rows ascend with their unknowns: those before this one are left of the diagonal.
          if (column >= r) sum[place[column]] += at.weight * block_with(d);
          continue;
        }
        for (const auto& share : patches.shares_of(patch.index, column - rows.size()))
          if (share.row >= r) sum[place[share.row]] += at.weight * share.weight * block_with(d);
      }
    }
    float* to = values_.data() + first_[i] * block_size;
    for (WideBlock& block : sum) {
      if (!row.is_first) {
        WideBlock before{};
        std::memcpy(&before, to, block_size * sizeof(float));
        block += before;
      }
      std::memcpy(to, &block, block_size * sizeof(float));
      to += block_size;
    }
  }
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
          if (column.unknown < row.unknown) continue;
          float* block = values_.data() + place_of(row.unknown, column.unknown) * block_size;
          const double x = factor * static_cast<double>(row.weight * column.weight) * k[c][d];
          for (int a = 0; a < Dim; ++a) block[a * Dim + a] += static_cast<float>(x);
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
  waves_.run([&](std::size_t s) { add_product(s * rows_per_slab_, std::min(n, (s + 1) * rows_per_slab_), x, y); });
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

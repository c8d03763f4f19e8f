// What an octree takes, counted where memory is allocated.

#include "grid/octree/octree.h"
#include "tests/grid/test_grids.h"

#include <gtest/gtest.h>
#include <malloc.h>

#include <atomic>
#include <cstdlib>
#include <new>

namespace {

std::atomic<std::size_t> allocated_bytes{0};

void release(void* p) noexcept {
  allocated_bytes -= malloc_usable_size(p);
  std::free(p);
}

}  // namespace

void* operator new(std::size_t size) {
  void* p = std::malloc(size);
  if (p == nullptr) throw std::bad_alloc();
  allocated_bytes += malloc_usable_size(p);
  return p;
}
void operator delete(void* p) noexcept { release(p); }
void operator delete(void* p, std::size_t) noexcept { release(p); }

namespace shellmatch {
namespace {

template <int Dim>
void expect_memory(int finest_level, double bytes_per_node) {
  const std::size_t before = allocated_bytes;
  const auto grid = test::sphere_grid<Dim>(3, finest_level, 0.3, Vec<Dim>::Constant(0.51));
  const auto taken = static_cast<double>(allocated_bytes - before);
  EXPECT_NEAR(static_cast<double>(grid.memory_bytes()), taken, 0.001 * taken + 200);
  EXPECT_LT(static_cast<double>(grid.memory_bytes()), bytes_per_node * grid.n_nodes()) << grid.n_nodes() << " nodes";
}

// The bounds are 10 % above what is stored and include the table, of a megabyte.
TEST(OctreeMemory, IsAsStatedAndBoundedByNode) {
  expect_memory<2>(14, 50);
  expect_memory<3>(8, 58);
}

}  // namespace
}  // namespace shellmatch

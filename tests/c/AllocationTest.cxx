#include "Calls.h"

#include <atomic>
#include <cstdlib>
#include <new>

/**
 * @file
 * Every allocation of the library fails once. The program's operator new is the library's, too.
 */
namespace
{

std::atomic<long> allocationsLeft{-1}; // before one fails; less than 0 for never
std::atomic<long> blocks{0};           // that were allocated and not given back

void* allocate(std::size_t size)
{
  if (allocationsLeft >= 0 && allocationsLeft-- == 0)
  {
    throw std::bad_alloc();
  }
  void* const memory = std::malloc(size > 0 ? size : 1);
  if (!memory)
  {
    throw std::bad_alloc();
  }
  ++blocks;
  return memory;
}

void release(void* memory) noexcept
{
  if (memory)
  {
    --blocks;
    std::free(memory);
  }
}

} // namespace

void* operator new(std::size_t size)
{
  return allocate(size);
}

void* operator new[](std::size_t size)
{
  return allocate(size);
}

void* operator new(std::size_t size, const std::nothrow_t&) noexcept
{
  try
  {
    return allocate(size);
  }
  catch (const std::bad_alloc&)
  {
    return nullptr;
  }
}

void operator delete(void* memory) noexcept
{
  release(memory);
}

void operator delete[](void* memory) noexcept
{
  release(memory);
}

void operator delete(void* memory, std::size_t) noexcept
{
  release(memory);
}

void operator delete[](void* memory, std::size_t) noexcept
{
  release(memory);
}

namespace
{

using namespace calls;

/// Makes `work` fail at one allocation after the other, until it passes; at most 300 of them.
/// `work` returns the status, and gives back what it has made.
template <class Work> void expectNoMemoryEverywhere(const Work& work)
{
  ASSERT_EQ(work(), WINDING_OK); // what is made once for all calls is made
  const long before = blocks;
  long count = 0;
  allocationsLeft = 1L << 40;
  ASSERT_EQ(work(), WINDING_OK);
  count = (1L << 40) - allocationsLeft;
  ASSERT_GT(count, 0);
  EXPECT_EQ(blocks, before);
  for (long i = 0; i < count; i += count / 300 + 1)
  {
    allocationsLeft = i;
    const winding_status status = work();
    const bool hasFailed = allocationsLeft < 0;
    allocationsLeft = -1;
    EXPECT_TRUE(status == (hasFailed ? WINDING_NO_MEMORY : WINDING_OK) || status == WINDING_OK)
      << i << " of " << count << ": " << status;
    EXPECT_EQ(blocks, before) << i << " of " << count;
  }
}

} // namespace

TEST(Allocations, ThatFailEndCallsWithoutALeak)
{
  const shapes::Mesh mesh = shapes::icosphere(2);
  const winding_polygons polygons = polygonsOf(mesh);
  const winding_array points = arrayOf(mesh.points);
  const winding_grid grid = gridAround({-1, -1, -1}, {1, 1, 1}, 8);
  auto run = with(winding_run_init);
  run.number_of_threads = 1;
  const Field field = fieldOf(mesh);
  std::vector<float> floats(3 * sizeOf(grid));
  std::vector<std::uint16_t> labels(sizeOf(grid));
  auto values = with(winding_values_init);
  values.winding = floats.data();
  expectNoMemoryEverywhere(
    [&]
    {
      winding_field* made = nullptr;
      const winding_status status = winding_faces(points, &polygons, nullptr, &run, &made, nullptr);
      EXPECT_EQ(made == nullptr, status != WINDING_OK);
      winding_field_free(made);
      return status;
    });
  expectNoMemoryEverywhere(
    [&] {
      return winding_evaluate_grid(field.get(), &grid, nullptr, nullptr, &values, &run, nullptr);
    });
  expectNoMemoryEverywhere(
    [&]
    {
      winding_mesh* made = nullptr;
      const winding_status status =
        winding_level_surface(field.get(), &grid, nullptr, nullptr, &run, &made, nullptr);
      EXPECT_EQ(made == nullptr, status != WINDING_OK);
      winding_mesh_free(made);
      return status;
    });
  expectNoMemoryEverywhere(
    [&]
    {
      const winding_field* fields[] = {field.get()};
      auto arrays = with(winding_labels_init);
      arrays.labels = labels.data();
      return winding_label(
        fields, nullptr, 1, &grid, nullptr, nullptr, nullptr, &arrays, &run, nullptr);
    });
  expectNoMemoryEverywhere(
    [&]
    {
      return winding_estimate_normals(
        points, nullptr, &run, floats.data(), nullptr, nullptr, nullptr);
    });
}

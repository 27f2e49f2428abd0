// SPDX-License-Identifier: GPL-3.0-or-later
// A step of the point driver allocates nothing, for any law that ships.
#include <catch2/catch.hpp>
#include <cstdlib>

#include "tests/lab/materials/each_law.hpp"

#if defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define TRIAX_SANITIZER_ALLOCATES
#endif
#endif
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define TRIAX_SANITIZER_ALLOCATES
#endif

#if defined(TRIAX_SANITIZER_ALLOCATES) || !defined(__GLIBC__)
constexpr bool kCounts = false;  // the allocator is not ours to replace there
static long allocations = 0;
#else
constexpr bool kCounts = true;
static thread_local long allocations = 0;
extern "C" {
void* __libc_malloc(std::size_t);
void* __libc_calloc(std::size_t, std::size_t);
void* __libc_realloc(void*, std::size_t);
void* __libc_memalign(std::size_t, std::size_t);
void* malloc(std::size_t n) { return ++allocations, __libc_malloc(n); }
void* calloc(std::size_t n, std::size_t m) { return ++allocations, __libc_calloc(n, m); }
void* realloc(void* p, std::size_t n) { return ++allocations, __libc_realloc(p, n); }
void* aligned_alloc(std::size_t a, std::size_t n) { return ++allocations, __libc_memalign(a, n); }
}
#endif

using namespace triax;

namespace {

template <class Space>
void check_steps(const sim::Law<Space>& law) {
  int followed = 0;
  using Control = sim::MixedControl<Space>;
  const auto start = lab::test::isotropic_state(law);
  // Well short of where a law ends: a step that is refused writes a message, which may allocate.
  for (const Control& control : {Control::strain_path(2e-5), Control::drained_compression(2e-5)}) {
    const sim::PointTolerance tolerance{.relative = 1e-6};
    sim::PointDriver<Space> driver(law, start, control, tolerance);
    if (law.refusal(start, driver.rate(start))) continue;  // NorSand's sets are for one drainage
    ++followed;
    auto state = start;
    const long before = allocations;
    int steps = 0;
    for (; steps < 100; ++steps) {
      auto step = driver.advance(state);
      if (step.outcome != sim::StepOutcome::accepted) break;
      state = step.state;
    }
    CHECK(allocations == before);
    CHECK(steps == 100);
  }
  CHECK(followed > 0);
}

}  // namespace

TEST_CASE("an accepted step allocates nothing, whatever the law and the space") {
  const long before = allocations;
  std::free(std::malloc(100));
  if (kCounts) REQUIRE(allocations > before);  // the counter counts
  for (const auto& set : lab::shipped_materials()) {
    INFO(set.name);
    if (set.material.axisymmetric && !set.material.axisymmetric->finite())
      check_steps(*set.material.axisymmetric);
    if (set.material.tensor && !set.material.tensor->finite()) check_steps(*set.material.tensor);
  }
}

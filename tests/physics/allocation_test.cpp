#include <atomic>
#include <cstdlib>
#include <gtest/gtest.h>
#include <new>

#include "physics/motion/integrators.h"
#include "tests/physics/scenes.h"

namespace {
std::atomic<long> allocations{0};
}  // namespace

// Every allocation of this program is counted; Eigen's own go through malloc, which its macro below reports.
void* operator new(std::size_t size) {
  ++allocations;
  if (void* p = std::malloc(size == 0 ? 1 : size)) return p;
  throw std::bad_alloc();
}
void operator delete(void* p) noexcept { std::free(p); }
void operator delete(void* p, std::size_t) noexcept { std::free(p); }

namespace carom {
namespace {

TEST(Allocation, NoneInAWarmStep) {
  for (const IntegratorChoice& integrator : kIntegrators) {
    for (const auto& impacts : kImpacts) {
      std::vector<Body> bodies = test::room(1.0, 0.5);
      for (int i = 0; i < 16; ++i) {
        std::string name(1, static_cast<char>('a' + i));
        bodies.push_back(test::disc(name, {-0.75 + 0.5 * (i % 4), -0.75 + 0.5 * (i / 4)}, {1.0 - 0.1 * i, 0.1 * i * i - 8.0}));
      }
      Scene s = test::scene(std::move(bodies), 1.0, 0.1);
      s.forces.quadratic_drag = 1e-6;
      s.method = {integrator.id, impacts.id, ContactsId::kImpulse, 0.01};
      Simulation run(s);
      for (int i = 0; i < 5000; ++i) run.step();
      const long before = allocations;
      const std::int64_t impacts_before = run.impact_count();
      for (int i = 0; i < 1000; ++i) run.step();
      EXPECT_EQ(allocations - before, 0) << integrator.name << ", " << impacts.name;
      EXPECT_GT(run.impact_count() - impacts_before, 100);
    }
  }
}

}  // namespace
}  // namespace carom

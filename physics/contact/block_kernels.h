#pragma once

#include <array>
#include <cstdint>
#include <span>

namespace carom {

// The contacts of a large island in blocks of eight that share no movable body, so that the eight can be
// solved at once. The law is that of ContactRow, with one array per quantity.

inline constexpr int kLanes = 8;
template <class T>
using Lanes = std::array<T, kLanes>;

// Bodies of infinite mass may be in several lanes: nothing changes them. An empty lane has a body of its own,
// at rest, on both sides, masses of 1 and otherwise zeros, and never changes.
struct alignas(64) ContactBlock {
  Lanes<std::uint32_t> a{}, b{};  // offsets of the bodies' velocities: 4 × body
  Lanes<double> nx{}, ny{};
  Lanes<double> arm_na{}, arm_nb{}, arm_ta{}, arm_tb{};    // r×n and r×t, m
  Lanes<double> inverse_mass_a{}, inverse_mass_b{};        // 1/kg; 0 for infinite mass
  Lanes<double> inverse_inertia_a{}, inverse_inertia_b{};  // 1/(kg m²)
  Lanes<double> mass_n{}, mass_t{}, mass_r{};              // kg, kg, kg m²
  Lanes<double> target{}, slip_target{};                   // m/s
  Lanes<double> normal{};                                  // N s
  Lanes<double> friction{}, tangential{};                  // dimensionless, N s
  Lanes<double> rolling{}, moment{};                       // m, N m s
};

struct alignas(32) BodyVelocity {
  double x = 0.0, y = 0.0;  // m/s
  double spin = 0.0;        // rad/s
  double unused = 0.0;
};

// The impulses of a block after the last step of a solve, and their change in that step.
struct alignas(64) BlockMomentum {
  Lanes<double> last_normal{}, last_tangential{}, last_moment{};
  Lanes<double> step_normal{}, step_tangential{}, step_moment{};
  Lanes<double> weight_n{}, weight_t{}, weight_r{};  // 1/mass_n and so on
};

// About the change of all impulses since the last step, in J: its square, and its product with that step,
// both weighted by the inverse masses of the contacts.
struct BlockChange {
  double squared = 0.0;
  double along = 0.0;
};

// The laws that the blocks need; each includes those before it.
enum class BlockLaw : std::uint8_t { kNormal, kFriction, kRolling };

// The same arithmetic for each instruction set, without fused operations, so all give the same bytes.
// `velocity` points at the first of four numbers per body, aligned like BodyVelocity.
struct BlockKernels {
  const char* name;
  bool (*runs_here)();
  // One sweep of projected Gauss-Seidel, like sweep() in contact_rows.h.
  void (*sweep)(std::span<ContactBlock> blocks, double* velocity, BlockLaw law, bool backwards);
  // Adds the effect of the impulses to the velocities.
  void (*apply)(std::span<const ContactBlock> blocks, double* velocity);
  // Like residual() in contact_rows.h.
  double (*residual)(std::span<const ContactBlock> blocks, const double* velocity);
  BlockChange (*change)(std::span<const ContactBlock> blocks, std::span<const BlockMomentum> momenta);
  // Adds `share` of the last step to the impulses; the whole change since that step becomes the last step.
  void (*carry)(std::span<ContactBlock> blocks, std::span<BlockMomentum> momenta, double share);
};

// All instruction sets of this build, the widest first; the last one runs everywhere.
[[nodiscard]] std::span<const BlockKernels> all_block_kernels();
// The first that runs on this machine.
[[nodiscard]] const BlockKernels& block_kernels();

}  // namespace carom

#pragma once

#include <array>
#include <cstdint>
#include <span>

namespace carom {

// The contacts of a crowd (a large island) in blocks of eight that share no movable body, so that the eight can
// be solved at once: the law of ContactRow, quantity by quantity.

inline constexpr int kLanes = 8;
template <class T>
using Lanes = std::array<T, kLanes>;

// Immovable bodies may stand in several lanes: nothing changes them. A lane without a contact has on both
// sides a body at rest that is no other's, masses of 1 and otherwise zeros, and stays as it is.
struct alignas(64) ContactBlock {
  Lanes<std::uint32_t> a{}, b{};  // where the bodies' velocities start: 4 × body
  Lanes<double> nx{}, ny{};
  Lanes<double> arm_na{}, arm_nb{}, arm_ta{}, arm_tb{};    // r×n and r×t, m
  Lanes<double> inverse_mass_a{}, inverse_mass_b{};        // 1/kg; 0 for immovable bodies
  Lanes<double> inverse_inertia_a{}, inverse_inertia_b{};  // 1/(kg m²)
  Lanes<double> mass_n{}, mass_t{}, mass_r{};              // kg, kg, kg m²
  Lanes<double> target{};                                  // m/s
  Lanes<double> normal{};                                  // N s
  Lanes<double> friction{}, tangential{};                  // dimensionless, N s
  Lanes<double> rolling{}, moment{};                       // m, N m s
};

struct alignas(32) BodyVelocity {
  double x = 0.0, y = 0.0;  // m/s
  double spin = 0.0;        // rad/s
  double unused = 0.0;
};

// What the impulses of a block were after the last step of a solve, and that step.
struct alignas(64) BlockMomentum {
  Lanes<double> last_normal{}, last_tangential{}, last_moment{};
  Lanes<double> step_normal{}, step_tangential{}, step_moment{};
  Lanes<double> weight_n{}, weight_t{}, weight_r{};  // 1/mass_n and so on
};

// Of the change that a sweep made to all impulses since the last step, in J: its square, and its product with
// that step, both weighted by the inverse masses of the contacts.
struct BlockChange {
  double squared = 0.0;
  double along = 0.0;
};

// Which laws the blocks need: what a law less leaves out is nothing then.
enum class BlockLaw : std::uint8_t { kNormal, kFriction, kRolling };

// The same arithmetic for each set of instructions, none of it fused: every one gives the same bytes.
// `velocity` points at the first of four numbers a body, aligned as BodyVelocity.
struct BlockKernels {
  const char* name;
  bool (*runs_here)();
  // One sweep of projected Gauss-Seidel, as sweep() of rows.
  void (*sweep)(std::span<ContactBlock> blocks, double* velocity, BlockLaw law, bool backwards);
  // Adds what the impulses give to the velocities.
  void (*apply)(std::span<const ContactBlock> blocks, double* velocity);
  // As residual() of rows.
  double (*residual)(std::span<const ContactBlock> blocks, const double* velocity);
  BlockChange (*change)(std::span<const ContactBlock> blocks, std::span<const BlockMomentum> momenta);
  // Goes on by `share` of the last step; what has changed since then is the last step now.
  void (*carry)(std::span<ContactBlock> blocks, std::span<BlockMomentum> momenta, double share);
};

// Every set of instructions that is built in; the widest comes first, and the last one runs everywhere.
[[nodiscard]] std::span<const BlockKernels> all_block_kernels();
// The first that runs on this machine.
[[nodiscard]] const BlockKernels& block_kernels();

}  // namespace carom

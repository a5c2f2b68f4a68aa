#include "physics/contact/block_kernels.h"

#include <algorithm>
#include <cstddef>

// GCC takes vectors filled lane by lane for uninitialised.
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#endif

// The inlined functions are compiled once per instruction set; no vectors are passed between the versions.
#define CAROM_INLINE inline __attribute__((always_inline))

namespace carom {

namespace {

using Pack = double __attribute__((vector_size(8 * kLanes), may_alias));
using Quad = double __attribute__((vector_size(32), may_alias));

CAROM_INLINE const Pack& pack(const Lanes<double>& lanes) { return *reinterpret_cast<const Pack*>(&lanes); }
CAROM_INLINE Pack& pack(Lanes<double>& lanes) { return *reinterpret_cast<Pack*>(&lanes); }

struct Velocities {
  Pack x, y, spin;
};

// Four numbers per body.
CAROM_INLINE void load_two(const double* from, std::uint32_t first, std::uint32_t second, Pack& both) {
  const Quad low = *reinterpret_cast<const Quad*>(from + first);
  const Quad high = *reinterpret_cast<const Quad*>(from + second);
  both = __builtin_shufflevector(low, high, 0, 1, 2, 3, 4, 5, 6, 7);
}

CAROM_INLINE void store_two(const Pack& both, std::uint32_t first, std::uint32_t second, double* to) {
  *reinterpret_cast<Quad*>(to + first) = __builtin_shufflevector(both, both, 0, 1, 2, 3);
  *reinterpret_cast<Quad*>(to + second) = __builtin_shufflevector(both, both, 4, 5, 6, 7);
}

// A transposition with few shuffles.
CAROM_INLINE void gather(const double* from, const Lanes<std::uint32_t>& at, Velocities& v) {
  Pack r02, r13, r46, r57;
  load_two(from, at[0], at[2], r02);
  load_two(from, at[1], at[3], r13);
  load_two(from, at[4], at[6], r46);
  load_two(from, at[5], at[7], r57);
  const Pack low_xs = __builtin_shufflevector(r02, r13, 0, 8, 2, 10, 4, 12, 6, 14);
  const Pack low_y = __builtin_shufflevector(r02, r13, 1, 9, 3, 11, 5, 13, 7, 15);
  const Pack high_xs = __builtin_shufflevector(r46, r57, 0, 8, 2, 10, 4, 12, 6, 14);
  const Pack high_y = __builtin_shufflevector(r46, r57, 1, 9, 3, 11, 5, 13, 7, 15);
  v.x = __builtin_shufflevector(low_xs, high_xs, 0, 1, 4, 5, 8, 9, 12, 13);
  v.y = __builtin_shufflevector(low_y, high_y, 0, 1, 4, 5, 8, 9, 12, 13);
  v.spin = __builtin_shufflevector(low_xs, high_xs, 2, 3, 6, 7, 10, 11, 14, 15);
}

CAROM_INLINE void scatter(const Velocities& v, const Lanes<std::uint32_t>& at, double* to) {
  const Pack zero{};
  const Pack low_xs = __builtin_shufflevector(v.x, v.spin, 0, 1, 8, 9, 2, 3, 10, 11);
  const Pack low_y = __builtin_shufflevector(v.y, zero, 0, 1, 8, 9, 2, 3, 10, 11);
  const Pack high_xs = __builtin_shufflevector(v.x, v.spin, 4, 5, 12, 13, 6, 7, 14, 15);
  const Pack high_y = __builtin_shufflevector(v.y, zero, 4, 5, 12, 13, 6, 7, 14, 15);
  store_two(__builtin_shufflevector(low_xs, low_y, 0, 8, 2, 10, 4, 12, 6, 14), at[0], at[2], to);
  store_two(__builtin_shufflevector(low_xs, low_y, 1, 9, 3, 11, 5, 13, 7, 15), at[1], at[3], to);
  store_two(__builtin_shufflevector(high_xs, high_y, 0, 8, 2, 10, 4, 12, 6, 14), at[4], at[6], to);
  store_two(__builtin_shufflevector(high_xs, high_y, 1, 9, 3, 11, 5, 13, 7, 15), at[5], at[7], to);
}

CAROM_INLINE void clamp(Pack& value, const Pack& limit) {
  const Pack low = -limit;
  value = value < low ? low : value;
  value = limit < value ? limit : value;
}

// Velocity of B relative to A at the contacts.
CAROM_INLINE void relative(const ContactBlock& k, const Velocities& a, const Velocities& b, Pack& u_n,
                           Pack& u_t) {
  const Pack dx = b.x - a.x;
  const Pack dy = b.y - a.y;
  u_n = pack(k.nx) * dx + pack(k.ny) * dy + (pack(k.arm_nb) * b.spin - pack(k.arm_na) * a.spin);
  u_t = pack(k.nx) * dy - pack(k.ny) * dx + (pack(k.arm_tb) * b.spin - pack(k.arm_ta) * a.spin);
}

template <BlockLaw kLaw>
CAROM_INLINE void solve_block(ContactBlock& k, double* velocity) {
  constexpr bool kRubs = kLaw != BlockLaw::kNormal;
  const Pack zero{};
  Velocities a{}, b{};
  gather(velocity, k.a, a);
  gather(velocity, k.b, b);
  Pack u_n, u_t;
  relative(k, a, b, u_n, u_t);
  Pack normal = pack(k.normal) - (u_n - pack(k.target)) * pack(k.mass_n);
  normal = zero < normal ? normal : zero;
  const Pack dn = normal - pack(k.normal);
  pack(k.normal) = normal;
  Pack jx = pack(k.nx) * dn;
  Pack jy = pack(k.ny) * dn;
  Pack turn_a = pack(k.arm_na) * dn;
  Pack turn_b = pack(k.arm_nb) * dn;
  if constexpr (kRubs) {
    // u_t after the normal impulse.
    const Pack k_nt = pack(k.inverse_inertia_a) * pack(k.arm_na) * pack(k.arm_ta) +
                      pack(k.inverse_inertia_b) * pack(k.arm_nb) * pack(k.arm_tb);
    Pack tangential = pack(k.tangential) - (u_t - pack(k.slip_target) + k_nt * dn) * pack(k.mass_t);
    clamp(tangential, pack(k.friction) * normal);
    const Pack dt = tangential - pack(k.tangential);
    pack(k.tangential) = tangential;
    jx = jx - pack(k.ny) * dt;
    jy = jy + pack(k.nx) * dt;
    turn_a = turn_a + pack(k.arm_ta) * dt;
    turn_b = turn_b + pack(k.arm_tb) * dt;
  }
  a.x -= pack(k.inverse_mass_a) * jx;
  a.y -= pack(k.inverse_mass_a) * jy;
  a.spin -= pack(k.inverse_inertia_a) * turn_a;
  b.x += pack(k.inverse_mass_b) * jx;
  b.y += pack(k.inverse_mass_b) * jy;
  b.spin += pack(k.inverse_inertia_b) * turn_b;
  if constexpr (kLaw == BlockLaw::kRolling) {
    Pack moment = pack(k.moment) - (b.spin - a.spin) * pack(k.mass_r);
    clamp(moment, pack(k.rolling) * normal);
    const Pack dm = moment - pack(k.moment);
    pack(k.moment) = moment;
    a.spin -= pack(k.inverse_inertia_a) * dm;
    b.spin += pack(k.inverse_inertia_b) * dm;
  }
  scatter(a, k.a, velocity);
  scatter(b, k.b, velocity);
}

template <BlockLaw kLaw>
CAROM_INLINE void sweep_as(std::span<ContactBlock> blocks, double* velocity, bool backwards) {
  ContactBlock* const first = blocks.data();
  const std::size_t count = blocks.size();
  for (std::size_t i = 0; i < count; ++i) solve_block<kLaw>(first[backwards ? count - 1 - i : i], velocity);
}

CAROM_INLINE void sweep_blocks(std::span<ContactBlock> blocks, double* velocity, BlockLaw law, bool backwards) {
  if (law == BlockLaw::kNormal) sweep_as<BlockLaw::kNormal>(blocks, velocity, backwards);
  if (law == BlockLaw::kFriction) sweep_as<BlockLaw::kFriction>(blocks, velocity, backwards);
  if (law == BlockLaw::kRolling) sweep_as<BlockLaw::kRolling>(blocks, velocity, backwards);
}

CAROM_INLINE void apply_blocks(std::span<const ContactBlock> blocks, double* velocity) {
  for (const ContactBlock& k : blocks) {
    Velocities a{}, b{};
    gather(velocity, k.a, a);
    gather(velocity, k.b, b);
    const Pack jx = pack(k.nx) * pack(k.normal) - pack(k.ny) * pack(k.tangential);
    const Pack jy = pack(k.ny) * pack(k.normal) + pack(k.nx) * pack(k.tangential);
    a.x -= pack(k.inverse_mass_a) * jx;
    a.y -= pack(k.inverse_mass_a) * jy;
    a.spin -= pack(k.inverse_inertia_a) *
              (pack(k.arm_na) * pack(k.normal) + pack(k.arm_ta) * pack(k.tangential) + pack(k.moment));
    b.x += pack(k.inverse_mass_b) * jx;
    b.y += pack(k.inverse_mass_b) * jy;
    b.spin += pack(k.inverse_inertia_b) *
              (pack(k.arm_nb) * pack(k.normal) + pack(k.arm_tb) * pack(k.tangential) + pack(k.moment));
    scatter(a, k.a, velocity);
    scatter(b, k.b, velocity);
  }
}

CAROM_INLINE void magnitude(Pack& x) { x = x < 0.0 ? -x : x; }

// The velocity if the clamp does not act, else how far the impulse is from the limit, as a velocity.
CAROM_INLINE void miss(const Pack& impulse, const Pack& velocity, const Pack& mass, const Pack& limit,
                       Pack& result) {
  const Pack asked = impulse - velocity * mass;
  Pack size = asked;
  magnitude(size);
  Pack beyond = ((asked < 0.0 ? -limit : limit) - impulse) / mass;
  result = size <= limit ? velocity : beyond;
  magnitude(result);
}

CAROM_INLINE double residual_of_blocks(std::span<const ContactBlock> blocks, const double* velocity) {
  Pack largest{};
  for (const ContactBlock& k : blocks) {
    Velocities a{}, b{};
    gather(velocity, k.a, a);
    gather(velocity, k.b, b);
    Pack u_n, u_t;
    relative(k, a, b, u_n, u_t);
    Pack beyond = u_n - pack(k.target);
    const Pack asked = pack(k.normal) - beyond * pack(k.mass_n);
    magnitude(beyond);
    Pack worst = asked > 0.0 ? beyond : pack(k.normal) / pack(k.mass_n);
    Pack other;
    miss(pack(k.tangential), u_t - pack(k.slip_target), pack(k.mass_t), pack(k.friction) * pack(k.normal),
         other);
    worst = worst < other ? other : worst;
    miss(pack(k.moment), b.spin - a.spin, pack(k.mass_r), pack(k.rolling) * pack(k.normal), other);
    other = pack(k.rolling) > 0.0 ? pack(k.rolling) * other : Pack{};
    worst = worst < other ? other : worst;
    // Keeps a NaN, which comes from invalid input.
    largest = worst <= largest ? largest : worst;
  }
  double most = 0.0;
  for (std::size_t k = 0; k < kLanes; ++k) {
    if (!(largest[k] <= most)) most = largest[k];
  }
  return most;
}

CAROM_INLINE double sum_of(const Pack& lanes) {
  double sum = 0.0;
  for (std::size_t k = 0; k < kLanes; ++k) sum += lanes[k];
  return sum;
}

CAROM_INLINE void add_change(const Lanes<double>& now, const Lanes<double>& last, const Lanes<double>& step,
                             const Lanes<double>& weight, Pack& squared, Pack& along) {
  const Pack change = pack(now) - pack(last);
  const Pack weighted = pack(weight) * change;
  squared += weighted * change;
  along += weighted * pack(step);
}

CAROM_INLINE BlockChange change_of_blocks(std::span<const ContactBlock> blocks,
                                          std::span<const BlockMomentum> momenta) {
  Pack squared{};
  Pack along{};
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    const ContactBlock& k = blocks[i];
    const BlockMomentum& m = momenta[i];
    add_change(k.normal, m.last_normal, m.step_normal, m.weight_n, squared, along);
    add_change(k.tangential, m.last_tangential, m.step_tangential, m.weight_t, squared, along);
    add_change(k.moment, m.last_moment, m.step_moment, m.weight_r, squared, along);
  }
  return {sum_of(squared), sum_of(along)};
}

CAROM_INLINE void carry_on(Lanes<double>& now, Lanes<double>& last, Lanes<double>& step, double share) {
  pack(now) += share * pack(step);
  pack(step) = pack(now) - pack(last);
  pack(last) = pack(now);
}

CAROM_INLINE void carry_blocks(std::span<ContactBlock> blocks, std::span<BlockMomentum> momenta, double share) {
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    ContactBlock& k = blocks[i];
    BlockMomentum& m = momenta[i];
    carry_on(k.normal, m.last_normal, m.step_normal, share);
    carry_on(k.tangential, m.last_tangential, m.step_tangential, share);
    carry_on(k.moment, m.last_moment, m.step_moment, share);
  }
}

#define CAROM_KERNELS(suffix, attributes)                                                             \
  attributes void sweep_##suffix(std::span<ContactBlock> blocks, double* velocity, BlockLaw law,      \
                                 bool backwards) {                                                    \
    sweep_blocks(blocks, velocity, law, backwards);                                                   \
  }                                                                                                   \
  attributes void apply_##suffix(std::span<const ContactBlock> blocks, double* velocity) {            \
    apply_blocks(blocks, velocity);                                                                   \
  }                                                                                                   \
  attributes double residual_##suffix(std::span<const ContactBlock> blocks, const double* velocity) { \
    return residual_of_blocks(blocks, velocity);                                                      \
  }                                                                                                   \
  attributes BlockChange change_##suffix(std::span<const ContactBlock> blocks,                        \
                                         std::span<const BlockMomentum> momenta) {                    \
    return change_of_blocks(blocks, momenta);                                                         \
  }                                                                                                   \
  attributes void carry_##suffix(std::span<ContactBlock> blocks, std::span<BlockMomentum> momenta,    \
                                 double share) {                                                      \
    carry_blocks(blocks, momenta, share);                                                             \
  }

CAROM_KERNELS(plain, )
#if defined(__x86_64__)
CAROM_KERNELS(avx2, __attribute__((target("avx2"))))
CAROM_KERNELS(avx512, __attribute__((target("avx512f"))))
#endif

#define CAROM_SET(name, runs_here, suffix) \
  { name, runs_here, sweep_##suffix, apply_##suffix, residual_##suffix, change_##suffix, carry_##suffix }

constexpr BlockKernels kKernels[] = {
#if defined(__x86_64__)
    CAROM_SET(
        "AVX-512", [] { return __builtin_cpu_supports("avx512f") != 0; }, avx512),
    CAROM_SET(
        "AVX2", [] { return __builtin_cpu_supports("avx2") != 0; }, avx2),
#endif
    CAROM_SET(
        "plain", [] { return true; }, plain),
};

}  // namespace

std::span<const BlockKernels> all_block_kernels() { return kKernels; }

const BlockKernels& block_kernels() {
  return *std::find_if(std::begin(kKernels), std::end(kKernels),
                       [](const BlockKernels& k) { return k.runs_here(); });
}

}  // namespace carom

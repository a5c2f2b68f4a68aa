#include "physics/contact/contact_blocks.h"

#include <algorithm>
#include <bit>

namespace carom {

namespace {

// The number of open blocks; each has one bit of a mask.
constexpr int kOpen = 64;

}  // namespace

void clear_blocks(int bodies, ContactBlocks& large) {
  large.contacts.clear();
  large.blocks.clear();
  large.bodies.clear();
  large.in_blocks.assign(static_cast<std::size_t>(bodies), 0);
  large.velocity.assign(static_cast<std::size_t>(bodies) + 1, {});
}

void add_blocks(const std::vector<BodyIndex>& a, const std::vector<BodyIndex>& b,
                const Eigen::VectorXd& inverse_mass, const Eigen::VectorXd& inverse_inertia,
                std::span<const int> order, ContactBlocks& large) {
  const std::size_t first = large.contacts.size();
  large.open_with.assign(large.in_blocks.size(), 0);
  large.filled.clear();
  // Block k has bit k % kOpen of the masks.
  std::uint64_t with_room = 0;
  const auto close = [&](int block) {
    const std::uint64_t bit = std::uint64_t{1} << (block % kOpen);
    with_room &= ~bit;
    for (int lane = 0; lane < large.filled[block]; ++lane) {
      const int c = large.contacts[first + block][lane];
      large.open_with[a[c]] &= ~bit;
      large.open_with[b[c]] &= ~bit;
    }
  };
  for (const int c : order) {
    int block = static_cast<int>(large.filled.size());
    const int oldest = std::max(block - kOpen, 0);
    // Bits from the oldest block on. Only blocks after the last one with either body fit, which keeps the
    // order.
    const std::uint64_t in = std::rotr(large.open_with[a[c]] | large.open_with[b[c]], oldest % kOpen);
    const int after = kOpen - std::countl_zero(in);
    const std::uint64_t later = after < kOpen ? ~std::uint64_t{0} << after : 0;
    const std::uint64_t fits = std::rotr(with_room, oldest % kOpen) & later;
    if (fits != 0) {
      block = oldest + std::countr_zero(fits);
    } else {
      if (block >= kOpen) close(block - kOpen);
      large.filled.push_back(0);
      Lanes<int> none;
      none.fill(-1);
      large.contacts.push_back(none);
      with_room |= std::uint64_t{1} << (block % kOpen);
    }
    const int lane = large.filled[block]++;
    large.contacts[first + block][lane] = c;
    const std::uint64_t bit = std::uint64_t{1} << (block % kOpen);
    if (lane == kLanes - 1) with_room &= ~bit;
    for (const BodyIndex i : {a[c], b[c]}) {
      if (!(inverse_mass[i] > 0.0 || inverse_inertia[i] > 0.0)) continue;
      large.open_with[i] |= bit;
      if (large.in_blocks[i] == 0) large.bodies.push_back(i);
      large.in_blocks[i] = 1;
    }
  }
  const ContactBlock empty = [&] {
    const auto body = static_cast<std::uint32_t>(4 * large.in_blocks.size());
    ContactBlock block;
    block.a.fill(body);
    block.b.fill(body);
    for (auto* masses : {&block.mass_n, &block.mass_t, &block.mass_r}) masses->fill(1.0);
    return block;
  }();
  large.blocks.resize(large.contacts.size(), empty);
}

ContactRow row_of(const ContactBlock& k, std::size_t i) {
  ContactRow row;
  row.a = BodyIndex{static_cast<int>(k.a[i] / 4)};
  row.b = BodyIndex{static_cast<int>(k.b[i] / 4)};
  row.nx = k.nx[i], row.ny = k.ny[i];
  row.arm_na = k.arm_na[i], row.arm_nb = k.arm_nb[i];
  row.arm_ta = k.arm_ta[i], row.arm_tb = k.arm_tb[i];
  row.mass_n = k.mass_n[i], row.mass_t = k.mass_t[i], row.mass_r = k.mass_r[i];
  row.target = k.target[i], row.slip_target = k.slip_target[i];
  row.friction = k.friction[i];
  row.rolling = k.rolling[i];
  row.normal = k.normal[i], row.tangential = k.tangential[i], row.moment = k.moment[i];
  return row;
}

void set_geometry(const ContactRow& row, const SolverBody& a, const SolverBody& b, std::size_t i,
                  ContactBlock& k) {
  k.a[i] = static_cast<std::uint32_t>(4 * row.a);
  k.b[i] = static_cast<std::uint32_t>(4 * row.b);
  k.nx[i] = row.nx, k.ny[i] = row.ny;
  k.arm_na[i] = row.arm_na, k.arm_nb[i] = row.arm_nb;
  k.arm_ta[i] = row.arm_ta, k.arm_tb[i] = row.arm_tb;
  k.inverse_mass_a[i] = a.inverse_mass, k.inverse_mass_b[i] = b.inverse_mass;
  k.inverse_inertia_a[i] = a.inverse_inertia, k.inverse_inertia_b[i] = b.inverse_inertia;
  k.mass_n[i] = row.mass_n, k.mass_t[i] = row.mass_t, k.mass_r[i] = row.mass_r;
}

void set_law(const ContactRow& row, std::size_t i, ContactBlock& k) {
  k.target[i] = row.target, k.slip_target[i] = row.slip_target;
  k.friction[i] = row.friction;
  k.rolling[i] = row.rolling;
  k.normal[i] = row.normal, k.tangential[i] = row.tangential, k.moment[i] = row.moment;
}

}  // namespace carom

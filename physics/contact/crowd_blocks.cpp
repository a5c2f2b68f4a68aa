#include "physics/contact/crowd_blocks.h"

#include <bit>

namespace carom {

namespace {

// Blocks are filled in groups that share no movable body either, so that the processor need not wait for one
// block before it starts with the next.
constexpr int kGroup = 2;
// Groups that are open at a time.
constexpr int kOpen = 32;

}  // namespace

void clear_blocks(int bodies, CrowdBlocks& crowd) {
  crowd.contacts.clear();
  crowd.blocks.clear();
  crowd.in_blocks.assign(static_cast<std::size_t>(bodies), 0);
  crowd.velocity.assign(static_cast<std::size_t>(bodies) + 1, {});
}

void add_blocks(const std::vector<int>& a, const std::vector<int>& b, const Eigen::VectorXd& inverse_mass,
                const Eigen::VectorXd& inverse_inertia, std::span<const int> order, CrowdBlocks& crowd) {
  const auto movable = [&](int i) { return inverse_mass[i] > 0.0 || inverse_inertia[i] > 0.0; };
  const std::size_t first = crowd.contacts.size();
  crowd.groups_of.assign(crowd.in_blocks.size(), 0);
  crowd.filled.clear();
  // Group g has bit g % kOpen of the masks; the open ones are the last kOpen.
  std::uint32_t with_room = 0;
  const auto retire = [&](int group) {
    const std::uint32_t bit = 1U << (group % kOpen);
    with_room &= ~bit;
    for (int lane = 0; lane < crowd.filled[group]; ++lane) {
      const int c = crowd.contacts[first + kGroup * group + lane / kLanes][lane % kLanes];
      crowd.groups_of[a[c]] &= ~bit;
      crowd.groups_of[b[c]] &= ~bit;
    }
  };
  for (const int c : order) {
    const int groups = static_cast<int>(crowd.filled.size());
    const bool moves_a = movable(a[c]);
    const bool moves_b = movable(b[c]);
    const std::uint32_t taken = (moves_a ? crowd.groups_of[a[c]] : 0U) | (moves_b ? crowd.groups_of[b[c]] : 0U);
    const std::uint32_t fits = with_room & ~taken;
    int group = groups;
    if (fits != 0) {
      const int oldest = std::max(groups - kOpen, 0);
      group = oldest + std::countr_zero(std::rotr(fits, oldest % kOpen));
    } else {
      if (groups >= kOpen) retire(groups - kOpen);
      crowd.filled.push_back(0);
      Lanes<int> none;
      none.fill(-1);
      crowd.contacts.insert(crowd.contacts.end(), kGroup, none);
      with_room |= 1U << (group % kOpen);
    }
    const int lane = crowd.filled[group]++;
    crowd.contacts[first + kGroup * group + lane / kLanes][lane % kLanes] = c;
    const std::uint32_t bit = 1U << (group % kOpen);
    if (crowd.filled[group] == kGroup * kLanes) with_room &= ~bit;
    for (const int i : {a[c], b[c]}) {
      if (!movable(i)) continue;
      crowd.groups_of[i] |= bit;
      crowd.in_blocks[i] = 1;
    }
  }
  // Blocks of a group that stayed empty.
  std::erase_if(crowd.contacts, [](const Lanes<int>& lanes) { return lanes[0] < 0; });
  const ContactBlock empty = [&] {
    const auto body = static_cast<std::uint32_t>(4 * crowd.in_blocks.size());
    ContactBlock block;
    block.a.fill(body);
    block.b.fill(body);
    for (auto* masses : {&block.mass_n, &block.mass_t, &block.mass_r}) masses->fill(1.0);
    return block;
  }();
  crowd.blocks.resize(crowd.contacts.size(), empty);
}

ContactRow row_of(const ContactBlock& k, std::size_t i) {
  ContactRow row;
  row.a = static_cast<int>(k.a[i] / 4);
  row.b = static_cast<int>(k.b[i] / 4);
  row.nx = k.nx[i], row.ny = k.ny[i];
  row.turn_na = k.turn_na[i], row.turn_nb = k.turn_nb[i];
  row.turn_ta = k.turn_ta[i], row.turn_tb = k.turn_tb[i];
  row.mass_n = k.mass_n[i], row.mass_t = k.mass_t[i], row.mass_r = k.mass_r[i];
  row.target = k.target[i];
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
  k.turn_na[i] = row.turn_na, k.turn_nb[i] = row.turn_nb;
  k.turn_ta[i] = row.turn_ta, k.turn_tb[i] = row.turn_tb;
  k.inverse_mass_a[i] = a.inverse_mass, k.inverse_mass_b[i] = b.inverse_mass;
  k.inverse_inertia_a[i] = a.inverse_inertia, k.inverse_inertia_b[i] = b.inverse_inertia;
  k.mass_n[i] = row.mass_n, k.mass_t[i] = row.mass_t, k.mass_r[i] = row.mass_r;
}

void set_law(const ContactRow& row, std::size_t i, ContactBlock& k) {
  k.target[i] = row.target;
  k.friction[i] = row.friction;
  k.rolling[i] = row.rolling;
  k.normal[i] = row.normal, k.tangential[i] = row.tangential, k.moment[i] = row.moment;
}

}  // namespace carom

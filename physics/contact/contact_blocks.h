#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <vector>

#include "physics/contact/block_kernels.h"
#include "physics/contact/contact_rows.h"

namespace carom {

// The contacts of large islands in blocks, and the velocities of all bodies, which include the blocks'
// impulses.
struct ContactBlocks {
  std::vector<Lanes<int>> contacts;  // of each block; -1: none
  std::vector<ContactBlock> blocks;
  std::vector<BodyVelocity> velocity;   // by body, and last that of empty lanes
  std::vector<std::uint8_t> in_blocks;  // by body: movable and in a block
  std::vector<BodyIndex> bodies;        // these, island by island

  std::vector<std::uint64_t> open_with;  // scratch, by body: the open blocks that it is in, one bit each
  std::vector<int> filled;               // scratch: lanes of each block
};

// Empties the blocks and sizes them for so many bodies.
void clear_blocks(int bodies, ContactBlocks& large);

// Appends a large island: blocks of its contacts `order`, between bodies a[c] and b[c]. Each contact goes to
// the first of the latest blocks that comes after all contacts that share a movable body with it. So solving
// block by block is the same as solving contact by contact, and a sweep passes through a pile in the given
// order.
void add_blocks(const std::vector<BodyIndex>& a, const std::vector<BodyIndex>& b,
                const Eigen::VectorXd& inverse_mass, const Eigen::VectorXd& inverse_inertia,
                std::span<const int> order, ContactBlocks& large);

// A lane's contact as a row; then the two parts of a row put into a lane.
[[nodiscard]] ContactRow row_of(const ContactBlock& block, std::size_t lane);
void set_geometry(const ContactRow& row, const SolverBody& a, const SolverBody& b, std::size_t lane,
                  ContactBlock& block);
void set_law(const ContactRow& row, std::size_t lane, ContactBlock& block);

}  // namespace carom

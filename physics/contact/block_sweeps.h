#pragma once

#include <span>
#include <vector>

#include "physics/contact/block_kernels.h"
#include "physics/model/index.h"

namespace carom {

// Memory of the sweeps of a large island; it may be reused.
struct SweepMomentum {
  struct OfBody {
    BodyVelocity last, step;
  };
  std::vector<BlockMomentum> blocks;
  std::vector<OfBody> bodies;
};

// Sweeps of projected Gauss-Seidel over one large island, with momentum: before a sweep the impulses take a
// share of the last step again, as long as the sweeps go that way too. The share is the ratio of the squares
// of two sweeps' changes, as in the conjugate gradients of Fletcher and Reeves (M. Silcowitz-Hansen, S.
// Niebe, K. Erleben, The Visual Computer 26 (2010) 893, whose projections and metric are others). Momentum
// against the sweep is dropped (B. O'Donoghue, E. Candès, Foundations of Computational Mathematics 15 (2015)
// 715). A sweep comes last, so that the impulses obey the laws' limits.
//
// An impulse takes some n² sweeps to pass through n contacts, with momentum some 4n.
class BlockSweeps {
 public:
  // `velocity` must already include the blocks' impulses; `bodies` are those that the blocks move.
  BlockSweeps(std::span<ContactBlock> blocks, std::span<const BodyIndex> bodies, BlockLaw law,
              std::vector<BodyVelocity>& velocity, SweepMomentum& momentum);
  // `with_momentum`: first takes a share of the last step again.
  void sweep(bool backwards, bool with_momentum);
  [[nodiscard]] double residual() const;  // as in contact_rows.h

 private:
  void carry_on();

  const BlockKernels& kernels_ = block_kernels();
  std::span<ContactBlock> blocks_;
  std::span<const BodyIndex> bodies_;
  BlockLaw law_;
  std::vector<BodyVelocity>& velocity_;
  SweepMomentum& momentum_;
  bool swept_ = false;
  double squared_before_ = 0.0;  // J, of the sweep before the last
};

}  // namespace carom

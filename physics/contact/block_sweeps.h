#pragma once

#include <span>
#include <vector>

#include "physics/contact/block_kernels.h"

namespace carom {

// What sweeps of a crowd remember; it may be reused.
struct SweepMomentum {
  struct OfBody {
    BodyVelocity last, step;
  };
  std::vector<BlockMomentum> blocks;
  std::vector<OfBody> bodies;
};

// Sweeps of projected Gauss-Seidel over one crowd with momentum between them: a share of the step before is
// gone on with, as long as the sweeps pull that way too. The share is the ratio of the squares of two
// sweeps' changes, as in Fletcher and Reeves' conjugate gradients (M. Silcowitz-Hansen, S. Niebe, K. Erleben,
// The Visual Computer 26 (2010) 893, whose projections and metric are others); momentum against the sweep is
// given up (B. O'Donoghue, E. Candès, Foundations of Computational Mathematics 15 (2015) 715). A sweep comes
// last, so that the impulses keep the laws' limits.
//
// A push through n contacts takes some n² sweeps, with momentum some 4n.
class BlockSweeps {
 public:
  // The blocks' impulses are in the velocities already; `bodies` are those that they move.
  BlockSweeps(std::span<ContactBlock> blocks, std::span<const int> bodies, BlockLaw law,
              std::vector<BodyVelocity>& velocity, SweepMomentum& momentum);
  // `with_momentum` first goes on with a share of the last step.
  void sweep(bool backwards, bool with_momentum);
  [[nodiscard]] double residual() const;  // as that of rows

 private:
  void carry_on();

  const BlockKernels& kernels_ = block_kernels();
  std::span<ContactBlock> blocks_;
  std::span<const int> bodies_;
  BlockLaw law_;
  std::vector<BodyVelocity>& velocity_;
  SweepMomentum& momentum_;
  bool swept_ = false;
  double squared_before_ = 0.0;  // J, of the sweep before the last
};

}  // namespace carom

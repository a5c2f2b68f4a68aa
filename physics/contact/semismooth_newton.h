#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "physics/contact/contact_rows.h"
#include "physics/math/block_lu.h"

namespace carom {

struct NewtonOptions {
  double tolerance = 0.0;   // of the residual, m/s
  int max_iterations = 60;  // linear systems
};

struct NewtonResult {
  double residual = 0.0;  // m/s, of the impulses that are left in the rows
  int iterations = 0;     // linear systems solved
  bool settled = false;   // the residual is at most the tolerance, or what rounding leaves of it
};

// The exact finish of one island: semismooth Newton within the proximal-point (augmented Lagrangian) iteration
//   λ⁺ = proj(λ + r (b - J v⁺)),  M (v⁺ - v) = Jᵀ(λ⁺ - λ),
// where proj clips to the cone of Coulomb and rolling. The states of the contacts (open, sticking, sliding ±)
// make it a linear system in v⁺, positive definite where nothing slides, whatever the redundancy; Newton's
// method on v⁺ searches the states, the outer iteration takes away what 1/r left and raises r. All is solved
// for increments, so the answer is exact to rounding. Where a step does not reduce the system's residual,
// sweeps of Gauss-Seidel move on from the best impulses so far, and r falls. With friction nothing of this is
// sure to end; the result tells. Alart and Curnier, Computer Methods in Applied Mechanics and Engineering 92
// (1991) 353; Rockafellar, SIAM Journal on Control and Optimization 14 (1976) 877.
class SemismoothNewton {
 public:
  // Rows of one island; bodies as apply_all leaves them. Leaves the best impulses that were met, applied.
  NewtonResult run(std::span<ContactRow> rows, std::span<SolverBody> bodies, const NewtonOptions& options);

 private:
  enum State : std::uint8_t { kOpen = 0, kClosed = 1, kHeld = 2, kUp = 4, kLocked = 8, kTurnsUp = 16 };
  struct Local {  // of a contact: its bodies within the island, and their blocks
    int a = 0, b = 0;
    BlockLu::Slot slot;
  };
  struct Impulses {
    double normal = 0.0, tangential = 0.0, moment = 0.0;
  };
  struct Miss {  // target less velocity at the centre of the proximal step, m/s and rad/s
    double normal = 0.0, tangential = 0.0, spin = 0.0;
  };

  void number_bodies(std::span<const ContactRow> rows, std::span<const SolverBody> bodies);
  void centre(std::span<const ContactRow> rows, std::span<const SolverBody> bodies);
  // Impulses, states and the system's residual at `step`; its norm is returned.
  double evaluate(std::span<const ContactRow> rows, const Eigen::VectorXd& step);
  bool factorise(std::span<const ContactRow> rows);
  bool search_states(std::span<const ContactRow> rows, int& left);

  double stiffness_ = 0.0;  // r K, dimensionless
  std::vector<int> local_of_;
  std::vector<int> bodies_;           // of the island, movable
  Eigen::VectorXd root_, turn_root_;  // √(1/m), √(1/I) of the island's bodies and a last, immovable one
  std::vector<Local> local_;
  std::vector<Miss> miss_;
  std::vector<Impulses> change_;
  std::vector<Impulses> best_;
  std::vector<std::uint8_t> states_, factorised_states_;
  double factorised_stiffness_ = 0.0;
  Eigen::VectorXd step_, direction_, next_, system_;  // velocities times √m, √I; system_: the residual
  std::vector<std::pair<int, int>> edges_;
  BlockLu lu_;
};

}  // namespace carom

#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include "physics/contact/contact_rows.h"
#include "physics/contact/pivoted_contacts.h"
#include "physics/math/block_lu.h"
#include "physics/model/index.h"

namespace carom {

struct NewtonOptions {
  double tolerance = 0.0;                                         // of the residual, m/s
  int max_iterations = 60;                                        // linear systems
  double most_impulse = std::numeric_limits<double>::infinity();  // N s: of a contact
  // Where a step fails, sweeps go on unless the residual is at most `enough` (m/s) or they would be more than
  // max_sweeps in all: the best impulses so far are the answer then.
  double enough = 0.0;
  int max_sweeps = std::numeric_limits<int>::max();
};

struct NewtonResult {
  double residual = 0.0;  // m/s, of the impulses returned in the rows
  int iterations = 0;     // linear systems solved
  bool settled = false;   // the residual is at most the tolerance or the rounding level
};

// Semismooth Newton for one island, within the proximal-point (augmented Lagrangian) iteration
//   λ⁺ = proj(λ + r (b - J v⁺)),  M (v⁺ - v) = Jᵀ(λ⁺ - λ),
// where proj clips to the cones of Coulomb and rolling friction. For known states of the contacts (open,
// sticking, sliding ±) it is a linear system in v⁺, positive definite if nothing slides, however redundant.
// Newton's method on v⁺ finds the states; the outer iteration removes the error that 1/r left and raises r.
// All is solved for increments, so the answer is exact to rounding. If a step does not reduce the system's
// residual, a small island is pivoted, twice at most (PivotedContacts); in a larger one, or where that finds
// nothing or presses jammed bodies too hard, Gauss-Seidel sweeps go on, and r falls. With friction their
// convergence is not guaranteed; the result reports it. Alart and Curnier, Computer Methods in Applied
// Mechanics and Engineering 92 (1991) 353; Rockafellar, SIAM Journal on Control and Optimization 14 (1976)
// 877.
class SemismoothNewton {
 public:
  // Takes the rows of one island and bodies as apply_all() leaves them. Leaves the best impulses found,
  // applied.
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
  struct Miss {  // target minus velocity at the centre of the proximal step, m/s and rad/s
    double normal = 0.0, tangential = 0.0, spin = 0.0;
  };

  void number_bodies(std::span<const ContactRow> rows, std::span<const SolverBody> bodies);
  void centre(std::span<const ContactRow> rows, std::span<const SolverBody> bodies);
  // Computes impulses, states and the system's residual at `step`; returns its norm.
  double evaluate(std::span<const ContactRow> rows, const Eigen::VectorXd& step);
  bool factorise(std::span<const ContactRow> rows);
  bool search_states(std::span<const ContactRow> rows, int& left);
  void take_step(std::span<ContactRow> rows, std::span<SolverBody> bodies) const;  // by change_
  void keep(std::span<const ContactRow> rows);                                     // as the best impulses
  void put_best(std::span<ContactRow> rows, std::span<SolverBody> bodies) const;

  double stiffness_ = 0.0;  // r K, dimensionless
  std::vector<int> local_of_;
  std::vector<BodyIndex> bodies_;     // of the island, movable
  Eigen::VectorXd root_, turn_root_;  // √(1/m), √(1/I) of the island's bodies; last, 0 for infinite mass
  std::vector<Local> local_;
  std::vector<Miss> miss_;
  std::vector<Impulses> change_;
  std::vector<Impulses> best_;
  std::vector<std::uint8_t> states_, factorised_states_;
  double factorised_stiffness_ = 0.0;
  Eigen::VectorXd step_, direction_, next_, system_;  // velocities times √m, √I; system_: the residual
  std::vector<std::pair<int, int>> edges_;
  BlockLu lu_;
  PivotedContacts pivoted_;
};

}  // namespace carom

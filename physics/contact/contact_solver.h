#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cstdint>
#include <vector>

#include "physics/contact/block_sweeps.h"
#include "physics/contact/contact_blocks.h"
#include "physics/contact/contact_rows.h"
#include "physics/contact/contacts.h"
#include "physics/contact/islands.h"
#include "physics/contact/semismooth_newton.h"
#include "physics/model/mass.h"

namespace carom {

struct ContactSolverOptions {
  double tolerance = 1e-9;  // of the residual, m/s (m for a projection)
  int max_sweeps = 64;      // of projected Gauss-Seidel, per island
  int max_newton = 60;      // linear systems of semismooth Newton, per island; 0: no Newton
  double enough = 0.0;      // m/s: where that fails with no more left, it is not tried again
  // The most contacts of an ordinary island, if the call prepares the contacts itself. A larger island is
  // solved in blocks, without semismooth Newton, and has its own budget and tolerance:
  int most_exact = 1 << 30;
  int large_sweeps = 64;
  int large_contact_sweeps = 0;   // more sweeps while contacts times sweeps stay below this
  double large_tolerance = 1e-9;  // m/s
  // If given (3×N), the tolerance is `large_share` of the island's rms velocity in it, at least
  // large_tolerance and at most large_coarsest.
  const Eigen::Matrix3Xd* large_motion = nullptr;
  double large_share = 0.1;
  double large_coarsest = 1e-9;  // m/s
  // A larger island that is slow (see ExactIslands) is solved exactly; in blocks where that would need more
  // sweeps after failed steps of semismooth Newton.
  int slow_sweeps = 64;
  double slip_speed = 0.0;  // a contact whose slip is at most this sticks, m/s
};

// Cost and result of a solve. An island misses its tolerance if its residual is above both the tolerance and
// what rounding alone leaves (rounding_level); a large island, if it is above its tolerance.
struct ContactSolverReport {
  int islands = 0;
  int sweeps = 0;                   // the most of any island, before semismooth Newton
  std::int64_t contact_sweeps = 0;  // contacts swept, over all islands
  int newton_islands = 0;           // islands that needed semismooth Newton
  int newton_iterations = 0;        // linear systems, over all islands
  int missed_islands = 0;
  double residual = 0.0;  // the largest of any island, m/s (m for a projection); see residual()
};

// Which islands are solved exactly: those of up to `most` contacts; if it can be done, slow ones of up to
// `most_slow`: where the rms velocity of the contacts in `motion` (3×N) is at most slow_speed.
struct ExactIslands {
  int most = 1 << 30;
  int most_slow = 0;
  double slow_speed = 0.0;                   // m/s
  const Eigen::Matrix3Xd* motion = nullptr;  // none: no island is slow
};

// Buffers that solves reuse; it may be copied. `islands` are those of the contacts that were prepared last.
struct ContactWorkspace {
  Islands islands;
  std::vector<ContactRow> rows;     // in the order of islands.contacts; those of large islands if they are slow
  std::vector<std::uint8_t> moves;  // by contact: the directions in which an impulse has an effect
  ContactBlocks large_islands;
  SweepMomentum momentum;
  std::vector<std::uint8_t> in_blocks;  // by island: solved in blocks
  // A large island i, a slow one as well, has the blocks first_block[i] .. first_block[i + 1] - 1
  std::vector<int> first_block;
  std::vector<int> first_body;  // and large_islands.bodies[first_body[i]] .. [first_body[i + 1] - 1]
  std::vector<BlockLaw> law;    // by island
  std::vector<SolverBody> bodies;
  SemismoothNewton newton;

  // Whether one is solved in blocks; of slow ones this may change in a solve.
  [[nodiscard]] bool has_large_island() const {
    return std::find(in_blocks.begin(), in_blocks.end(), 1) != in_blocks.end();
  }
};

// Prepares what several solves share: which bodies touch, normals and arms, masses, and which islands are
// solved exactly. Allocates nothing once the workspace has held as much.
void prepare_contacts(const MassProperties& mass, const Contacts& contacts, const ExactIslands& exact,
                      ContactWorkspace& workspace);

// Solves the contacts of one (sub-)step for the bodies' velocities v (3×N: x and y in m/s, spin in rad/s), to
// which smooth forces have already been applied:
//   v' = v + M⁻¹ Jᵀ λ,
//   0 <= λ_n ⊥ u_n' - b_n >= 0,
//   |λ_t| <= μ λ_n, and λ_t = -μ λ_n sign(u_t' - b_t) where u_t' != b_t,     μ = μ_s if the contact sticks,
//   else μ_k |M| <= ρ λ_n,   and M = -ρ λ_n sign(w') where w' != 0.
// Contacts are rigid: the only error is the residual. Each island has its own budget: warm-started projected
// Gauss-Seidel (in a large island with momentum, see BlockSweeps), then semismooth Newton, unless the
// tolerance is met or clearly will be. The laws leave the impulses of redundant contacts open; one choice is
// returned. Bodies of infinite mass keep their velocities. Allocates nothing once the workspace has held as
// much. Call prepare_contacts() first, with the same number of contacts, bodies, normals and arms.
ContactSolverReport solve_prepared(const MassProperties& mass, Contacts& contacts, Eigen::Matrix3Xd& v,
                                   const ContactSolverOptions& options, ContactWorkspace& workspace);
// Prepares them too.
ContactSolverReport solve_contacts(const MassProperties& mass, Contacts& contacts, Eigen::Matrix3Xd& v,
                                   const ContactSolverOptions& options, ContactWorkspace& workspace);

// The smallest displacement dq (3×N, m and rad; least dqᵀ M dq) that removes `fraction` of each penetration
// and makes no new one: J_n dq >= -fraction·gap where gap < 0, else J_n dq >= -gap, to first order in dq.
// Without friction; `contacts` are not changed. Call prepare_contacts() first.
ContactSolverReport project_prepared(const MassProperties& mass, const Contacts& contacts, double fraction,
                                     Eigen::Matrix3Xd& dq, const ContactSolverOptions& options,
                                     ContactWorkspace& workspace);
// Prepares them too.
ContactSolverReport project_penetrations(const MassProperties& mass, const Contacts& contacts, double fraction,
                                         Eigen::Matrix3Xd& dq, const ContactSolverOptions& options,
                                         ContactWorkspace& workspace);

}  // namespace carom

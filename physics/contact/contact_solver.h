#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "physics/contact/block_sweeps.h"
#include "physics/contact/contact_blocks.h"
#include "physics/contact/contact_rows.h"
#include "physics/contact/contacts.h"
#include "physics/contact/islands.h"
#include "physics/contact/semismooth_newton.h"
#include "physics/dynamics/state.h"
#include "physics/model/mass.h"

namespace carom {

struct ContactSolverOptions {
  double tolerance = 1e-9;  // of the residual, m/s (m for a projection)
  int max_sweeps = 64;      // of projected Gauss-Seidel, an island
  int max_newton = 60;      // linear systems of the exact finish, an island; 0: no exact finish
  // Contacts of an island where the contacts are not prepared yet; a larger one, a crowd, is solved in blocks
  // and gets no exact finish, and a budget and tolerance of its own.
  int most_exact = 1 << 30;
  int large_sweeps = 64;
  int large_contact_sweeps = 0;   // more sweeps where its contacts times the sweeps stay below this
  double large_tolerance = 1e-9;  // m/s
  // Where it is given, the tolerance is `large_share` of the crowd's rms velocity there, at least
  // large_tolerance and at most large_coarsest.
  const Eigen::Matrix3Xd* large_motion = nullptr;
  double large_share = 0.1;
  double large_coarsest = 1e-9;  // m/s
  double slip_speed = 0.0;       // a contact whose slip is at most this sticks, m/s
};

// What a solve took and left. An island that missed the tolerance is one whose residual is above both the
// tolerance and what rounding alone leaves (rounding_level); a crowd, above its tolerance.
struct ContactSolverReport {
  int islands = 0;
  int sweeps = 0;                   // the most that an island took before its exact finish
  std::int64_t contact_sweeps = 0;  // contacts swept, over all islands
  int newton_islands = 0;           // islands that the exact finish worked on
  int newton_iterations = 0;        // linear systems, over all islands
  int missed_islands = 0;
  double residual = 0.0;  // the largest that is left, m/s (m for a projection); see residual()
};

// What solves reuse; it may be copied. `islands` are those of the contacts that were prepared last.
struct ContactWorkspace {
  Islands islands;
  std::vector<ContactRow> rows;     // in the order of islands.contacts; those of large islands are not used
  std::vector<std::uint8_t> moves;  // by contact: the directions in which an impulse changes anything
  ContactBlocks large_islands;
  SweepMomentum momentum;
  std::vector<int> first_block;  // island i has the blocks first_block[i] .. first_block[i + 1] - 1
  std::vector<int> first_body;   // and the large islands.bodies first_body[i] .. first_body[i + 1] - 1
  std::vector<BlockLaw> law;     // by island
  std::vector<SolverBody> bodies;
  SemismoothNewton newton;
};

// Which islands become large islands: those of more than `most_exact` contacts that move, and all of more than
// `most_slow`. An island moves if the rms velocity of its contacts' bodies is above slow_speed in `motion`.
struct LargeIslandChoice {
  int most_exact = 1 << 30;
  int most_slow = 0;
  double slow_speed = 0.0;                   // m/s
  const Eigen::Matrix3Xd* motion = nullptr;  // none: every island moves
};

// Takes in what stays the same in several solves: which bodies touch, normals and arms, and the masses, and
// which islands are large islands. Nothing is allocated once the workspace has held as much.
void prepare_contacts(const MassProperties& mass, const Contacts& contacts, const LargeIslandChoice& choice,
                      ContactWorkspace& workspace);

// Solves the contacts of one (sub-)step for the bodies' velocities v (3×N: x and y in m/s, spin in rad/s),
// which smooth forces have already changed:
//   v' = v + M⁻¹ Jᵀ λ,
//   0 <= λ_n ⊥ u_n' - b_n >= 0,
//   |λ_t| <= μ λ_n, and λ_t = -μ λ_n sign(u_t') where u_t' != 0,     μ = μ_s if the contact sticks, else μ_k
//   |M| <= ρ λ_n,   and M = -ρ λ_n sign(w') where w' != 0.
// Nothing is soft: what is left is the residual. Island by island, each with its own budget: warm-started
// projected Gauss-Seidel (of a crowd with momentum, see BlockSweeps), then, unless the tolerance is met or
// clearly will be, the exact finish. Of the impulses of redundant contacts, which the laws leave open, some are
// returned. Immovable bodies keep their velocities. Nothing is allocated once the workspace has held as much.
// The contacts must have been prepared, by their number, bodies, normals and arms.
ContactSolverReport solve_prepared(const MassProperties& mass, Contacts& contacts, Eigen::Matrix3Xd& v,
                                   const ContactSolverOptions& options, ContactWorkspace& workspace);
// Prepares them too.
ContactSolverReport solve_contacts(const MassProperties& mass, Contacts& contacts, Eigen::Matrix3Xd& v,
                                   const ContactSolverOptions& options, ContactWorkspace& workspace);

// The smallest displacement dq (3×N, m and rad; least dqᵀ M dq) that takes away `fraction` of each penetration
// and makes no new one: J_n dq >= -fraction·gap where gap < 0, else J_n dq >= -gap, to first order in dq.
// Without friction; nothing of `contacts` is changed. They must have been prepared.
ContactSolverReport project_prepared(const MassProperties& mass, const Contacts& contacts, double fraction,
                                     Eigen::Matrix3Xd& dq, const ContactSolverOptions& options,
                                     ContactWorkspace& workspace);
// Prepares them too.
ContactSolverReport project_penetrations(const MassProperties& mass, const Contacts& contacts, double fraction,
                                         Eigen::Matrix3Xd& dq, const ContactSolverOptions& options,
                                         ContactWorkspace& workspace);

}  // namespace carom

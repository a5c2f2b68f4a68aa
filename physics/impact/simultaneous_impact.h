#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "physics/impact/impact_law.h"
#include "physics/math/lcp.h"

namespace carom {

// A contact of a cluster, between two of its bodies (columns of the velocities).
struct ClusterContact {
  int a = 0;
  int b = 0;
  Vec2 normal = Vec2::Zero();  // unit, from A to B
  Vec2 from_a = Vec2::Zero();  // m, from A's centre to the contact point
  Vec2 from_b = Vec2::Zero();  // m, from B's centre to it
  double restitution = 1.0;
  double kinetic_friction = 0.0;
};

struct ClusterOutcome {
  bool solved = true;  // false: no impulses satisfy the law, e.g. between kinematic bodies; nothing changed
  double restitution = 1.0;  // no contact had a larger e
  bool lowered = false;      // e was lowered so that energy is not gained, or to find a solution
};

// Which e each contact of a cluster has.
enum class ClusterRestitution {
  kSmallest,  // all have the smallest of the contacts that take part
  kOwn        // each has its own
};

// Buffers that are kept between calls, so that a call of no greater size allocates nothing.
struct ClusterScratch {
  struct Row {  // one direction at one contact
    int a, b;
    Vec2 direction;
    double turn_a, turn_b;  // r × direction, m
  };
  std::vector<Row> rows;
  std::vector<double> response;  // K: velocity of row i by an impulse along row j, 1/kg
  std::vector<double> velocity;  // of each row before, m/s
  std::vector<double> after;     // and after it
  std::vector<double> impulse;   // of each row, N s
  std::vector<double> scale;     // of each contact, 1/√K_nn
  std::vector<int> rubbing;      // contacts with friction
  std::vector<double> matrix, vector;
  LcpSolver lcp;
};

// How bodies that no joint couples answer unit impulses at the contacts: columns 2 n c ... 2 n c + n - 1 are
// the changes of the n bodies' velocities by one along the normal of contact c, the next n columns those by one
// along its tangent (the normal turned by +90°). In m/s and rad/s by N s.
void free_answers(const Eigen::Ref<const Eigen::VectorXd>& inverse_mass,
                  const Eigen::Ref<const Eigen::VectorXd>& inverse_inertia,
                  std::span<const ClusterContact> contacts, Eigen::Matrix3Xd& answers);

// Resolves all contacts of a cluster at once, those that take part (K_nn > 0) with one e or each with its own:
//   0 <= u_n' + e min(u_n, 0)   ⊥   j_n >= 0       (Moreau; Glocker, Set-Valued Force Laws, 2001)
//   |j_t| <= μ_k j_n, j_t against u_t' where it is on the border, u_t' = 0 inside
// For one contact this is Newton's law with Coulomb's cone (μ_k is the only friction that it uses). Moreau
// has u_n in place of min(u_n, 0), which would make a separating contact approach. Both lines are one linear
// complementarity problem, exact in two dimensions (Stewart and Trinkle, International Journal for Numerical
// Methods in Engineering 39 (1996) 2673). Without friction the velocities after it are unique. With friction,
// or contacts that separate before, it may gain energy: then the largest e is lowered by bisection until it
// does not; at e = 0 it never does. If there is no solution with the e of the contacts, as in a wedge that
// closes, e = 0 at once. The impulses of redundant contacts are one choice of many.
//
// `velocities` is 3×n, v_x, v_y in m/s and spin in rad/s, and is changed; `answers` is 3×2nm, as in
// free_answers(). `impacts` gets the impulses and losses of each of the m contacts; with friction, only the sum
// of these losses is certain not to be negative.
[[nodiscard]] ClusterOutcome resolve_simultaneous(Eigen::Ref<Eigen::Matrix3Xd> velocities,
                                                  const Eigen::Ref<const Eigen::Matrix3Xd>& answers,
                                                  std::span<const ClusterContact> contacts,
                                                  ClusterRestitution restitution, std::span<Impact> impacts,
                                                  ClusterScratch& scratch);

}  // namespace carom

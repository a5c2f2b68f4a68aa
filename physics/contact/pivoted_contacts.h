#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "physics/contact/contact_rows.h"
#include "physics/math/lcp.h"

namespace carom {

// The contacts of one island as a linear complementarity problem, solved by pivoting: with friction it finds
// answers where iterations go round for ever, and its cost grows with the cube of the number of contacts.
//
// Friction in the plane: λ_t = σ - μ λ_n with 0 <= σ <= 2 μ λ_n. With w the velocities beyond their targets,
//   0 <= λ_n ⟂ w_n >= 0,  0 <= σ ⟂ w_t + τ >= 0,  0 <= τ ⟂ 2 μ λ_n - σ >= 0,
// and the same for rolling with its own arm ρ instead of μ (the law of D. E. Stewart and J. C. Trinkle,
// International Journal for Numerical Methods in Engineering 39 (1996) 2673, with one unknown less a contact).
// The matrix of (λ_n, σ, τ) is not copositive for large μ, so that pivoting may end without an answer.
class PivotedContacts {
 public:
  // The impulses that change the free velocities of these bodies as the laws of the contacts ask. False, with
  // the impulses as before, if none were found. Of redundant impulses those of rigid contacts are such that
  // some do all they can and others nothing; a `compliance` shares the load: each impulse λ along a direction
  // leaves a velocity of -K λ times that, for the next solver to remove.
  [[nodiscard]] bool solve(std::span<ContactRow> rows, std::span<const SolverBody> bodies, double compliance);

 private:
  // A direction in which a contact can act, scaled so that a unit impulse changes its own velocity by 1.
  struct Direction {
    BodyIndex a, b;
    Eigen::Vector3d row_a, row_b;
    double scale;   // 1/√K
    double beyond;  // the free velocity beyond its target, times the scale
  };
  // Friction or rolling resistance: its direction, the normal one whose impulse limits it, and by how much.
  struct Limited {
    int direction;
    int normal;
    double share;
  };
  void add(const ContactRow& row, std::span<const SolverBody> bodies);
  [[nodiscard]] double coupling(int i, int j, std::span<const SolverBody> bodies) const;

  std::vector<Direction> directions_;
  std::vector<int> normals_;  // directions
  std::vector<Limited> limited_;
  // Memory of matrices, which keeps what it has held.
  std::vector<double> coupling_;
  std::vector<double> matrix_;
  std::vector<double> beyond_;
  LcpSolver lcp_;
};

}  // namespace carom

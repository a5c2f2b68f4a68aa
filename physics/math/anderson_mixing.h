#pragma once

#include <Eigen/Core>

namespace carom {

// Anderson's mixing for a fixed point x = x + f(x), where f, the residual, is linear in x or nearly so: a
// linear one is found in few rounds, even where plain rounds, x + f(x), converge slowly. Where f has kinks it
// may go astray: after kMixed rounds it is back at the start, and goes on by plain ones. (D. G. Anderson,
// Iterative procedures for nonlinear integral equations, J. ACM 12 (1965) 547; H. F. Walker and P. Ni, Anderson
// acceleration for fixed-point iterations, SIAM J. Numer. Anal. 49 (2011) 1715.)
class AndersonMixing {
 public:
  static constexpr int kMixed = 24;

  // For n unknowns.
  void start(Eigen::Index n) {
    if (changes_.rows() != n) {
      changes_.resize(n, kMost);
      residuals_.resize(n, kMost);
      last_.resize(n);
      residual_.resize(n);
      change_.resize(n);
      since_start_.resize(n);
    }
    since_start_.setZero();
    known_ = 0;
    rounds_ = 0;
  }
  // By what to change x, which has this residual.
  const Eigen::VectorXd& change(const Eigen::VectorXd& residual) {
    if (++rounds_ == kMixed) return change_ = -since_start_;
    if (rounds_ > kMixed) return change_ = residual;
    if (rounds_ > 1) {
      if (known_ == kMost || residual.norm() > kAstray * last_.norm()) known_ = 0;
      learn(residual);
    }
    last_ = residual;
    residual_ = residual;
    change_.setZero();
    take_known();
    change_ += residual_;
    if (!(change_.norm() <= kFarthest * residual.norm())) change_ = residual;
    since_start_ += change_;
    return change_;
  }

 private:
  static constexpr Eigen::Index kMost = 12;
  // Times the residual before: a larger one follows another law, and what is known is forgotten.
  static constexpr double kAstray = 2.0;
  // Times the residual: a longer change is not trusted.
  static constexpr double kFarthest = 1e3;
  // Of a change of the residual: what is left of it beside the known ones is rounding.
  static constexpr double kSame = 1e-8;

  // How the residual has changed with the last change of x, as far as it is not known yet.
  void learn(const Eigen::VectorXd& residual) {
    residual_ = residual - last_;
    const double all = residual_.norm();
    take_known();
    const double left = residual_.norm();
    if (!(left > kSame * all)) return;
    residuals_.col(known_) = residual_ / left;
    changes_.col(known_) = change_ / left;
    ++known_;
  }
  // What the known changes leave of residual_, and what they add to change_.
  void take_known() {
    for (Eigen::Index k = 0; k < known_; ++k) {
      const double share = residuals_.col(k).dot(residual_);
      residual_ -= share * residuals_.col(k);
      change_ -= share * changes_.col(k);
    }
  }

  Eigen::MatrixXd residuals_;  // orthonormal
  Eigen::MatrixXd changes_;    // of x, which change the residual by those
  Eigen::Index known_ = 0;
  int rounds_ = 0;
  Eigen::VectorXd last_;
  Eigen::VectorXd residual_;
  Eigen::VectorXd change_;       // the last one
  Eigen::VectorXd since_start_;  // by what x has changed
};

}  // namespace carom

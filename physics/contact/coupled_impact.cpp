#include "physics/contact/coupled_impact.h"

#include <cmath>

namespace carom {
namespace {

// A coupling below this share of K_nn + K_tt is rounding.
constexpr double kNoCoupling = 1e-14;

Impact with_losses(const RelativeVelocity& u, const ContactAnswer& k, double j_n, double j_t) {
  const double after_n = u.normal + k.nn * j_n + k.nt * j_t;
  const double after_t = u.tangential + k.nt * j_n + k.tt * j_t;
  return {j_n, j_t, -0.5 * j_n * (u.normal + after_n), -0.5 * j_t * (u.tangential + after_t)};
}

}  // namespace

Impact resolve_coupled_impact(const RelativeVelocity& u, const ContactAnswer& k, const Material& material) {
  if (u.normal >= 0.0 || !(k.nn > 0.0)) return {};
  const double e = material.restitution;
  const double friction = material.kinetic_friction;
  const Impact smooth = with_losses(u, k, -(1.0 + e) * u.normal / k.nn, 0.0);
  if (!(friction > 0.0)) return smooth;

  const bool apart = std::abs(k.nt) <= kNoCoupling * (k.nn + k.tt);
  const double turned = apart ? 1.0 + material.tangential_restitution : 1.0;
  const double determinant = k.nn * k.tt - k.nt * k.nt;
  // A link can hold the point along t: then there is no slip to stop.
  if (!(determinant > kNoCoupling * k.nn * (k.nn + k.tt))) return smooth;
  const double by_n = -(1.0 + e) * u.normal;
  const double by_t = -turned * u.tangential;
  double j_n = (k.tt * by_n - k.nt * by_t) / determinant;
  double j_t = (k.nn * by_t - k.nt * by_n) / determinant;
  if (!(j_n > 0.0) || std::abs(j_t) > friction * j_n) {
    const double side = u.tangential > 0.0 ? -friction : friction;
    const double sliding = k.nn + side * k.nt;
    if (!(sliding > 0.0)) return smooth;
    j_n = by_n / sliding;
    j_t = side * j_n;
  }
  const Impact rough = with_losses(u, k, j_n, j_t);
  return rough.lost_to_restitution + rough.lost_to_friction < 0.0 ? smooth : rough;
}

}  // namespace carom

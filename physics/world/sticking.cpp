#include <utility>

#include "physics/math/vectors.h"
#include "physics/world/simulation.h"

// Bodies that stay joined from their first impact on.
namespace carom {

Impact Simulation::join(int a, int b, const Contact& contact) {
  const int body = immovable(a) ? b : a;
  const int other = body == a ? b : a;
  const Eigen::Vector3d q = tracks_.settled(body).head<3>();
  const Eigen::Vector3d q_other = tracks_.settled(other).head<3>();
  Link weld;
  weld.kind = LinkKind::kWeld;
  weld.body = bodies()[body].name;
  weld.point = turned_by(-q[2], contact.point - q.head<2>());
  weld.to = bodies()[other].name;
  weld.anchor = turned_by(-q_other[2], contact.point - q_other.head<2>());
  weld.angle = q[2] - q_other[2];
  Scene scene = model_->scene;
  scene.links.push_back(std::move(weld));
  recompile(std::move(scene), needs(), tracks_.start(body));

  // The impact is wholly plastic, and the two turn as one after it: it is what the weld does to motions that it
  // finds as they are.
  const auto [taken, impulse] = tracks_.catch_by(static_cast<int>(links().size()) - 1, body);
  const Vec2 on_b = body == b ? impulse : Vec2(-impulse);
  Impact impact;
  impact.normal = on_b.dot(contact.normal);
  impact.tangential = on_b.dot(crossed(contact.normal));
  impact.lost_to_sticking = taken;
  return impact;
}

}  // namespace carom

#include <chipmunk/chipmunk.h>
#include <cmath>
#include <memory>

#include "tests/peers/cases.h"

// Chipmunk 7 with its defaults: 10 iterations, a collision slop of 0.1 m, no sleeping. Debian builds it with
// its assertions, which its times include.
namespace carom::peers {
namespace {

constexpr int kIterations = 10;

struct Free {
  void operator()(cpSpace* space) const { cpSpaceFree(space); }
  void operator()(cpBody* body) const { cpBodyFree(body); }
  void operator()(cpShape* shape) const { cpShapeFree(shape); }
};

template <class T>
using Owned = std::unique_ptr<T, Free>;

class ChipmunkWorld {
 public:
  explicit ChipmunkWorld(const Scene& scene) : space_(cpSpaceNew()) {
    cpSpaceSetIterations(space_.get(), kIterations);
    cpSpaceSetGravity(space_.get(), cpv(scene.gx, scene.gy));
    for (const Body& body : scene.bodies) add(scene, body);
    if (scene.counts_contacts) count_contacts();
  }

  // The handler has the counter's address.
  ChipmunkWorld(const ChipmunkWorld&) = delete;
  ChipmunkWorld& operator=(const ChipmunkWorld&) = delete;

  void step(double h) { cpSpaceStep(space_.get(), h); }

  [[nodiscard]] Motion motion(int i) const {
    const cpBody* b = bodies_[static_cast<std::size_t>(i)].get();
    const cpVect p = cpBodyGetPosition(b);
    const cpVect v = cpBodyGetVelocity(b);
    return {p.x, p.y, cpBodyGetAngle(b), v.x, v.y, cpBodyGetAngularVelocity(b)};
  }

  // A step first moves the bodies and then collides them, so that the contacts' depths are those of the
  // present poses; a negative depth is a penetration. Every pair is reported twice, once from each body.
  [[nodiscard]] std::vector<double> overlaps() const {
    std::vector<double> list;
    const auto tell = [](cpBody*, cpArbiter* arbiter, void* data) {
      for (int k = 0; k < cpArbiterGetCount(arbiter); ++k)
        static_cast<std::vector<double>*>(data)->push_back(-cpArbiterGetDepth(arbiter, k));
    };
    for (const Owned<cpBody>& body : bodies_) cpBodyEachArbiter(body.get(), tell, &list);
    return list;
  }

  [[nodiscard]] long contacts_begun() const { return contacts_begun_; }

 private:
  void add(const Scene& scene, const Body& body) {
    const bool moves = body.density > 0.0;
    bodies_.emplace_back(moves ? cpBodyNew(mass(body), inertia(body)) : cpBodyNewStatic());
    cpBody* b = bodies_.back().get();
    cpBodySetPosition(b, cpv(body.start.x, body.start.y));
    cpBodySetAngle(b, body.start.angle);
    cpSpaceAddBody(space_.get(), b);
    if (moves) {
      cpBodySetVelocity(b, cpv(body.start.vx, body.start.vy));
      cpBodySetAngularVelocity(b, body.start.spin);
    }
    const Disc* disc = std::get_if<Disc>(&body.shape);
    const Box* box = std::get_if<Box>(&body.shape);
    shapes_.emplace_back(disc ? cpCircleShapeNew(b, disc->radius, cpvzero)
                              : cpBoxShapeNew(b, box->width, box->height, 0.0));
    cpShape* shape = shapes_.back().get();
    // A pair has the product of its shapes' coefficients.
    cpShapeSetFriction(shape, std::sqrt(scene.friction));
    cpShapeSetElasticity(shape, std::sqrt(scene.restitution));
    cpSpaceAddShape(space_.get(), shape);
  }

  // Only on request: a handler is looked up at every contact.
  void count_contacts() {
    cpCollisionHandler* handler = cpSpaceAddCollisionHandler(space_.get(), 0, 0);
    handler->userData = &contacts_begun_;
    handler->beginFunc = [](cpArbiter*, cpSpace*, void* count) -> cpBool {
      ++*static_cast<long*>(count);
      return cpTrue;
    };
  }

  std::vector<Owned<cpBody>> bodies_;
  std::vector<Owned<cpShape>> shapes_;
  Owned<cpSpace> space_;  // freed first: it accesses its bodies then
  long contacts_begun_ = 0;
};

}  // namespace

Engine chipmunk() { return {"chipmunk-7", cases<ChipmunkWorld>()}; }

}  // namespace carom::peers

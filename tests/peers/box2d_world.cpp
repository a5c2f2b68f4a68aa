#include <box2d/box2d.h>

#include "tests/peers/cases.h"

// Box2D 2.4, with continuous collision (its default) and without sleeping. Restitution acts at every speed;
// by default it would only at 1 m/s and more.
namespace carom::peers {
namespace {

constexpr int kVelocityIterations = 8;
constexpr int kPositionIterations = 3;

float single(double x) { return static_cast<float>(x); }

// Box2D gives polygons a skin of b2_polygonRadius and reports separations between skins.
float skin(const b2Fixture* fixture) {
  return fixture->GetType() == b2Shape::e_polygon ? fixture->GetShape()->m_radius : 0.0f;
}

class Box2dWorld : private b2ContactListener {
 public:
  explicit Box2dWorld(const Scene& scene) : world_({single(scene.gx), single(scene.gy)}) {
    world_.SetAllowSleeping(false);
    if (scene.counts_contacts) world_.SetContactListener(this);
    for (const Body& body : scene.bodies) add(scene, body);
  }

  // The listener has the world's address.
  Box2dWorld(const Box2dWorld&) = delete;
  Box2dWorld& operator=(const Box2dWorld&) = delete;

  void step(double h) { world_.Step(single(h), kVelocityIterations, kPositionIterations); }

  [[nodiscard]] Motion motion(int i) const {
    const b2Body& b = *bodies_[static_cast<std::size_t>(i)];
    return {b.GetPosition().x,       b.GetPosition().y,       b.GetAngle(),
            b.GetLinearVelocity().x, b.GetLinearVelocity().y, b.GetAngularVelocity()};
  }

  // The world manifold puts the contact's features at the present poses; without the skins it is that of the
  // true boxes.
  [[nodiscard]] std::vector<double> overlaps() const {
    std::vector<double> list;
    for (const b2Contact* c = world_.GetContactList(); c != nullptr; c = c->GetNext()) {
      if (!c->IsTouching()) continue;
      b2WorldManifold at;
      c->GetWorldManifold(&at);
      for (int k = 0; k < c->GetManifold()->pointCount; ++k)
        list.push_back(-at.separations[k] - skin(c->GetFixtureA()) - skin(c->GetFixtureB()));
    }
    return list;
  }

  [[nodiscard]] long contacts_begun() const { return contacts_begun_; }

 private:
  void BeginContact(b2Contact*) override { ++contacts_begun_; }

  void add(const Scene& scene, const Body& body) {
    b2BodyDef def;
    def.type = body.density > 0.0 ? b2_dynamicBody : b2_staticBody;
    def.position = {single(body.start.x), single(body.start.y)};
    def.angle = single(body.start.angle);
    def.linearVelocity = {single(body.start.vx), single(body.start.vy)};
    def.angularVelocity = single(body.start.spin);
    def.bullet = body.bullet;
    bodies_.push_back(world_.CreateBody(&def));

    b2CircleShape circle;
    b2PolygonShape polygon;
    b2FixtureDef fixture;
    if (const Disc* disc = std::get_if<Disc>(&body.shape)) {
      circle.m_radius = single(disc->radius);
      fixture.shape = &circle;
    } else {
      const Box& box = std::get<Box>(body.shape);
      polygon.SetAsBox(single(0.5 * box.width), single(0.5 * box.height));
      fixture.shape = &polygon;
    }
    fixture.density = single(body.density);
    fixture.friction = single(scene.friction);  // a pair has √(μμ)
    fixture.restitution = single(scene.restitution);
    fixture.restitutionThreshold = 0.0f;
    bodies_.back()->CreateFixture(&fixture);
  }

  b2World world_;
  std::vector<b2Body*> bodies_;
  long contacts_begun_ = 0;
};

}  // namespace

Engine box2d() { return {"box2d-2.4", cases<Box2dWorld>()}; }

}  // namespace carom::peers

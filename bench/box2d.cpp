#include <box2d/box2d.h>
#include <numbers>

#include "carom/world.hpp"
#include "simulator.hpp"

namespace bench {

namespace {

// Box2D wants metres and moves nothing more than 2 m in a step: so a ball is 1 m wide, and the
// fastest shot (2000 px/s) moves 1 m in a step.
constexpr double metres_per_pixel = 0.05;

float metres(double pixels) { return static_cast<float>(pixels * metres_per_pixel); }
b2Vec2 metres(carom::Vec2 pixels) { return {metres(pixels.x), metres(pixels.y)}; }
carom::Vec2 pixels(b2Vec2 metres) {
  return {metres.x / metres_per_pixel, metres.y / metres_per_pixel};
}

class Box2d final : public Simulator {
 public:
  Box2d(const carom::Scene& start, const Workload& load)
      : world_(b2Vec2(0, -metres(start.gravity))) {
    // Nothing sleeps: nobody else's balls do either.
    world_.SetAllowSleeping(false);
    // In its favour: sides this thick need no search for the time of impact, which takes longer
    // than all the rest with thousands of balls.
    world_.SetContinuousPhysics(false);

    b2FixtureDef material;
    material.restitution = static_cast<float>(load.restitution);  // the larger of the two counts
    material.friction = static_cast<float>(load.grip);            // their geometric mean
    // By default slow contacts (1 m/s) do not bounce. Without loss all must.
    if (load.restitution == 1) material.restitutionThreshold = 0;

    const double thick = 40;
    const b2BodyDef standing;
    b2Body* sides = world_.CreateBody(&standing);
    const auto side = [&](double left, double bottom, double right, double top) {
      b2PolygonShape rectangle;
      rectangle.SetAsBox(metres((right - left) / 2), metres((top - bottom) / 2),
                         metres(carom::Vec2{(left + right) / 2, (bottom + top) / 2}), 0);
      b2FixtureDef definition = material;
      definition.shape = &rectangle;
      sides->CreateFixture(&definition);
    };
    const double w = start.width;
    const double h = start.height;
    if (start.edges.left == carom::Edge::solid) side(-thick, -thick, 0, h + thick);
    if (start.edges.right == carom::Edge::solid) side(w, -thick, w + thick, h + thick);
    if (start.edges.bottom == carom::Edge::solid) side(-thick, -thick, w + thick, 0);
    if (start.edges.top == carom::Edge::solid) side(-thick, h, w + thick, h + thick);

    for (const carom::Ball& ball : start.balls) {
      b2BodyDef definition;
      definition.type = b2_dynamicBody;
      definition.position = metres(ball.position);
      definition.linearVelocity = metres(ball.velocity);
      // It divides the velocity by 1 + damping·dt in each step.
      definition.linearDamping = static_cast<float>((1 / start.friction - 1) / carom::time_step);
      b2CircleShape circle;
      circle.m_radius = metres(ball.radius);
      b2FixtureDef fixture = material;
      fixture.shape = &circle;
      fixture.density =
          1 / (std::numbers::pi_v<float> * circle.m_radius * circle.m_radius);  // all 1 kg
      bodies_.push_back(world_.CreateBody(&definition));
      bodies_.back()->CreateFixture(&fixture);
      radii_.push_back(ball.radius);
    }
  }

  void advance(int steps) override {
    for (int n = 0; n < steps; ++n) step();
  }

  int run_until_rest(int limit) override {
    int steps = 0;
    for (; steps < limit && !at_rest(); ++steps) step();
    return steps;
  }

  std::vector<carom::Ball> balls() const override {
    std::vector<carom::Ball> all;
    for (std::size_t i = 0; i < bodies_.size(); ++i)
      all.push_back({.position = pixels(bodies_[i]->GetPosition()),
                     .velocity = pixels(bodies_[i]->GetLinearVelocity()),
                     .radius = radii_[i]});
    return all;
  }

 private:
  // 8 and 3 iterations, as its manual suggests.
  void step() { world_.Step(static_cast<float>(carom::time_step), 8, 3); }

  bool at_rest() const {
    const float limit = metres(carom::rest_speed);
    for (const b2Body* body : bodies_)
      if (body->GetLinearVelocity().LengthSquared() >= limit * limit) return false;
    return true;
  }

  b2World world_;
  std::vector<b2Body*> bodies_;
  std::vector<double> radii_;
};

}  // namespace

std::unique_ptr<Simulator> make_box2d(const carom::Scene& start, const Workload& load) {
  return std::make_unique<Box2d>(start, load);
}

}  // namespace bench

#include <chipmunk/chipmunk.h>
#include <chipmunk/chipmunk_structs.h>
#include <cmath>

#include "carom/world.hpp"
#include "simulator.hpp"

namespace bench {

namespace {

// As it comes: 10 iterations, default slop and bias; bodies never sleep unless they are told to.
class Chipmunk final : public Simulator {
 public:
  Chipmunk(const carom::Scene& start, const Workload& load, bool spatial_hash)
      : space_(cpSpaceNew()) {
    // Ten cells a ball, as its manual advises. Of cells 1, 1.5 and 2 balls wide these are the best.
    if (spatial_hash)
      cpSpaceUseSpatialHash(space_, 1.5 * 2 * carom::default_radius,
                            10 * static_cast<int>(start.balls.size()));
    cpSpaceSetGravity(space_, cpv(0, -start.gravity));
    // It takes the part of the velocity that is left after a second.
    cpSpaceSetDamping(space_, std::pow(start.friction, carom::steps_per_second));

    // It multiplies the factors of the two that meet.
    const double elasticity = std::sqrt(load.restitution);
    const double friction = std::sqrt(load.grip);
    const auto add = [&](cpShape* shape) {
      cpShapeSetElasticity(shape, elasticity);
      cpShapeSetFriction(shape, friction);
      shapes_.push_back(cpSpaceAddShape(space_, shape));
    };
    // Thick enough that no ball passes through in a step; the sides run past the corners.
    const double thick = 20;
    const auto side = [&](carom::Vec2 a, carom::Vec2 b) {
      add(cpSegmentShapeNew(cpSpaceGetStaticBody(space_), cpv(a.x, a.y), cpv(b.x, b.y), thick));
    };
    const double w = start.width;
    const double h = start.height;
    if (start.edges.left == carom::Edge::solid) side({-thick, -thick}, {-thick, h + thick});
    if (start.edges.right == carom::Edge::solid) side({w + thick, -thick}, {w + thick, h + thick});
    if (start.edges.bottom == carom::Edge::solid) side({-thick, -thick}, {w + thick, -thick});
    if (start.edges.top == carom::Edge::solid) side({-thick, h + thick}, {w + thick, h + thick});

    for (const carom::Ball& ball : start.balls) {
      cpBody* body = cpBodyNew(1, cpMomentForCircle(1, 0, ball.radius, cpvzero));
      bodies_.push_back(cpSpaceAddBody(space_, body));
      cpBodySetPosition(body, cpv(ball.position.x, ball.position.y));
      cpBodySetVelocity(body, cpv(ball.velocity.x, ball.velocity.y));
      radii_.push_back(ball.radius);
      add(cpCircleShapeNew(body, ball.radius, cpvzero));
    }
  }

  ~Chipmunk() override {
    cpSpaceFree(space_);
    for (cpShape* shape : shapes_) cpShapeFree(shape);
    for (cpBody* body : bodies_) cpBodyFree(body);
  }

  void advance(int steps) override {
    for (int n = 0; n < steps; ++n) cpSpaceStep(space_, carom::time_step);
  }

  int run_until_rest(int limit) override {
    int steps = 0;
    for (; steps < limit && !at_rest(); ++steps) cpSpaceStep(space_, carom::time_step);
    return steps;
  }

  std::vector<carom::Ball> balls() const override {
    std::vector<carom::Ball> all;
    for (std::size_t i = 0; i < bodies_.size(); ++i)
      all.push_back({.position = {bodies_[i]->p.x, bodies_[i]->p.y},
                     .velocity = {bodies_[i]->v.x, bodies_[i]->v.y},
                     .radius = radii_[i]});
    return all;
  }

 private:
  // Straight from its structures: its accessors are no inline functions.
  bool at_rest() const {
    for (const cpBody* body : bodies_)
      if (cpvlengthsq(body->v) >= carom::rest_speed * carom::rest_speed) return false;
    return true;
  }

  cpSpace* space_;
  std::vector<cpShape*> shapes_;
  std::vector<cpBody*> bodies_;
  std::vector<double> radii_;
};

}  // namespace

std::unique_ptr<Simulator> make_chipmunk_tree(const carom::Scene& start, const Workload& load) {
  return std::make_unique<Chipmunk>(start, load, false);
}

std::unique_ptr<Simulator> make_chipmunk_hash(const carom::Scene& start, const Workload& load) {
  return std::make_unique<Chipmunk>(start, load, true);
}

}  // namespace bench

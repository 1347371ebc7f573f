#include <algorithm>

#include "carom/world.hpp"
#include "simulator.hpp"

namespace bench {

namespace {

class Streaming final : public Simulator {
 public:
  explicit Streaming(const carom::Scene& start) : width_(start.width), height_(start.height) {
    for (const carom::Ball& ball : start.balls) {
      x_.push_back(ball.position.x);
      y_.push_back(ball.position.y);
      vx_.push_back(ball.velocity.x);
      vy_.push_back(ball.velocity.y);
    }
  }

  void advance(int steps) override {
    for (int n = 0; n < steps; ++n) {
      stream(x_.data(), vx_.data(), x_.size(), width_);
      stream(y_.data(), vy_.data(), y_.size(), height_);
    }
  }

  // Without friction there is no rest: as many steps as a break takes, about.
  int run_until_rest(int) override {
    advance(500);
    return 500;
  }

  std::vector<carom::Ball> balls() const override {
    std::vector<carom::Ball> all;
    for (std::size_t i = 0; i < x_.size(); ++i)
      all.push_back({.position = {x_[i], y_[i]}, .velocity = {vx_[i], vy_[i]}});
    return all;
  }

 private:
  // Selections instead of branches, so that the compiler makes vectors of it.
  static void stream(double* __restrict position, double* __restrict velocity, std::size_t count,
                     double end) {
    const double low = carom::default_radius;
    const double high = end - carom::default_radius;
    for (std::size_t i = 0; i < count; ++i) {
      const double moved = position[i] + velocity[i] * carom::time_step;
      position[i] = std::min(std::max(moved, low), high);
      velocity[i] = position[i] == moved ? velocity[i] : -velocity[i];
    }
  }

  double width_;
  double height_;
  std::vector<double> x_, y_, vx_, vy_;
};

}  // namespace

std::unique_ptr<Simulator> make_streaming(const carom::Scene& start, const Workload&) {
  return std::make_unique<Streaming>(start);
}

}  // namespace bench

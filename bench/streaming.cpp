#include "carom/world.hpp"
#include "reflect.hpp"
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
      stream(x_, vx_, width_);
      stream(y_, vy_, height_);
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
  static void stream(std::vector<double>& position, std::vector<double>& velocity, double end) {
    reflect(position.data(), velocity.data(), position.size(), carom::time_step,
            carom::default_radius, end - carom::default_radius);
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

#include <stdexcept>

#include "carom/world.hpp"
#include "simulator.hpp"

namespace bench {

namespace {

class Carom final : public Simulator {
 public:
  explicit Carom(carom::World world) : world_(std::move(world)) {}

  void advance(int steps) override {
    for (int n = 0; n < steps; ++n) world_.step();
  }

  int run_until_rest(int limit) override {
    int steps = 0;
    for (; steps < limit && !world_.at_rest(); ++steps) world_.step();
    return steps;
  }

  std::vector<carom::Ball> balls() const override {
    std::vector<carom::Ball> all;
    for (std::size_t i = 0; i < world_.size(); ++i)
      if (world_.in_play(i)) all.push_back(world_.ball(i));
    return all;
  }

  std::optional<std::uint64_t> hash() const override { return world_.state_hash(); }

 private:
  carom::World world_;
};

}  // namespace

std::unique_ptr<Simulator> make_carom(const carom::Scene& start, const Workload&) {
  carom::Result<carom::World> world = carom::World::create(start);
  if (!world) throw std::runtime_error(carom::to_string(world.errors().front()));
  return std::make_unique<Carom>(std::move(world).value());
}

}  // namespace bench

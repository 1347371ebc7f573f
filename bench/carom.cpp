#include <stdexcept>

#include "carom/world.hpp"
#include "simulator.hpp"

namespace bench {

namespace {

class Carom final : public Simulator {
 public:
  explicit Carom(carom::World world) : world_(std::move(world)) {}

  void advance(int steps) override { world_.run({}, static_cast<std::uint64_t>(steps)); }

  int run_until_rest(int limit) override {
    return static_cast<int>(world_.run({.rest = true}, static_cast<std::uint64_t>(limit)).steps);
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

namespace {

carom::World world_of(const carom::Scene& start) {
  carom::Result<carom::World> world = carom::World::create(start);
  if (!world) throw std::runtime_error(carom::to_string(world.errors().front()));
  return std::move(world).value();
}

template <int threads>
std::unique_ptr<Simulator> with_threads(const carom::Scene& start) {
  carom::World world = world_of(start);
  world.set_threads(threads);
  return std::make_unique<Carom>(std::move(world));
}

template <carom::BroadPhase broad_phase>
std::unique_ptr<Simulator> with_broad_phase(const carom::Scene& start) {
  carom::World world = world_of(start);
  world.set_broad_phase(broad_phase);
  return std::make_unique<Carom>(std::move(world));
}

}  // namespace

std::unique_ptr<Simulator> make_carom(const carom::Scene& start, const Workload&) {
  return std::make_unique<Carom>(world_of(start));
}

std::unique_ptr<Simulator> make_carom_never_skip(const carom::Scene& start, const Workload&) {
  carom::World world = world_of(start);
  world.set_skipping(false);
  return std::make_unique<Carom>(std::move(world));
}

std::unique_ptr<Simulator> make_carom_pairs(const carom::Scene& start, const Workload&) {
  return with_broad_phase<carom::BroadPhase::pairs>(start);
}

std::unique_ptr<Simulator> make_carom_quadtree(const carom::Scene& start, const Workload&) {
  return with_broad_phase<carom::BroadPhase::quadtree>(start);
}

std::unique_ptr<Simulator> make_carom_1_thread(const carom::Scene& start, const Workload&) {
  return with_threads<1>(start);
}

std::unique_ptr<Simulator> make_carom_2_threads(const carom::Scene& start, const Workload&) {
  return with_threads<2>(start);
}

std::unique_ptr<Simulator> make_carom_4_threads(const carom::Scene& start, const Workload&) {
  return with_threads<4>(start);
}

}  // namespace bench

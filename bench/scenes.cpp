#include "scenes.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <numbers>
#include <stdexcept>

#include "carom/scene_file.hpp"
#include "games/angry_balls.hpp"
#include "games/billiards.hpp"
// Where older commits had it: bench/compare builds this file with their engines.
#if __has_include("games/random.hpp")
#include "games/random.hpp"
#else
#include "soak/random.hpp"
namespace games {
using soak::Random;
}
#endif

namespace bench {

namespace {

using carom::Ball;
using carom::Scene;
using carom::Vec2;

using games::Random;

/// A unit vector in any direction, without sin and cos, whose last bits differ between libraries.
Vec2 direction(Random& random) {
  for (;;) {
    const Vec2 v{random.uniform(-1, 1), random.uniform(-1, 1)};
    const double square = carom::length_squared(v);
    if (square > 0.01 && square < 1) return v / std::sqrt(square);
  }
}

constexpr double radius = carom::default_radius;
constexpr double ball_area = std::numbers::pi * radius * radius;

/// Straight at the apex, but for the hair off the middle that opens the rack.
constexpr Vec2 break_shot{1999, 20};

Scene billiards_break() {
  Scene scene = games::billiards::rack();
  scene.balls[0].velocity = break_shot;
  return scene;
}

Scene break_without_holes() {
  Scene scene = billiards_break();
  scene.name = "BREAK";
  scene.holes.clear();
  scene.friction = 0.99;
  return scene;
}

/// The table of billiards with `balls` balls where they happen to lie, and a random shot.
Scene random_shot(int balls, bool holes, Random& random) {
  Scene scene = games::billiards::rack();
  if (!holes) scene.holes.clear();
  scene.balls.resize(static_cast<std::size_t>(balls));
  std::vector<Ball> placed;
  for (Ball ball : scene.balls) {
    const auto is_free = [&] {
      return std::ranges::none_of(placed,
                                  [&](const Ball& other) {
                                    return carom::length(other.position - ball.position) <
                                           1.02 * (other.radius + ball.radius);
                                  }) &&
             std::ranges::none_of(scene.holes, [&](const carom::Hole& hole) {
               return carom::length(hole.position - ball.position) < hole.radius + ball.radius;
             });
    };
    do
      ball.position = {random.uniform(ball.radius, scene.width - ball.radius),
                       random.uniform(ball.radius, scene.height - ball.radius)};
    while (!is_free());
    placed.push_back(ball);
  }
  scene.balls = placed;
  scene.balls[0].velocity = random.uniform(200, 2000) * direction(random);
  return scene;
}

constexpr int shots_in_a_row = 100;

std::vector<Scene> random_shots(int balls, bool holes) {
  Random random(static_cast<std::uint64_t>(balls));
  std::vector<Scene> shots;
  shots.reserve(shots_in_a_row);
  for (int n = 0; n < shots_in_a_row; ++n) shots.push_back(random_shot(balls, holes, random));
  return shots;
}

/// Breaks of the rack towards its half of the table.
std::vector<Scene> random_breaks() {
  Random random(5);
  std::vector<Scene> shots(50, games::billiards::rack());
  for (Scene& scene : shots) {
    Vec2& velocity = scene.balls[0].velocity;
    velocity = random.uniform(600, 2000) * direction(random);
    velocity.x = std::abs(velocity.x);
  }
  return shots;
}

/// Throws of a level's projectile in any direction.
std::vector<Scene> random_throws(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  const auto level = carom::read_scene(std::string(std::istreambuf_iterator<char>(stream), {}));
  if (!level) throw std::runtime_error(carom::to_string(level.errors().front(), file.string()));
  Random random(7);
  std::vector<Scene> throws(10, level.value());
  for (Scene& scene : throws)
    scene.balls[0].velocity = random.uniform(200, 2000) * direction(random);
  return throws;
}

constexpr double top_speed = 500;  // px/s

/// `count` balls, without gravity and friction, between four solid sides.
Scene box(const char* name, double width, double height) {
  Scene scene;
  scene.name = name;
  scene.width = width;
  scene.height = height;
  scene.friction = 1;
  return scene;
}

/// A square lattice in row order, each ball shaken by almost as much as leaves room to the next.
Scene gas(int count) {
  Random random(1);
  const double side = std::sqrt(count * ball_area / 0.30);
  const int columns = static_cast<int>(std::ceil(std::sqrt(count)));
  const double spacing = side / columns;
  const double jitter = 0.95 * (spacing / 2 - radius);
  Scene scene = box("GAS", side, side);
  for (int n = 0; n < count; ++n) {
    const int row = n / columns;
    const Vec2 site{(n % columns + 0.5) * spacing, (row + 0.5) * spacing};
    const double dx = random.uniform(-jitter, jitter);
    const double dy = random.uniform(-jitter, jitter);
    const double speed = random.uniform(0, top_speed);
    scene.balls.push_back(
        {.position = site + Vec2{dx, dy}, .velocity = speed * direction(random), .radius = radius});
  }
  return scene;
}

/// A hexagonal lattice that fills a box of about equal sides up to 0.70 of its area.
Scene dense(int count) {
  Random random(2);
  const double row_ratio = std::sqrt(3.0) / 2;  // distance of rows / distance of neighbours
  const int columns = static_cast<int>(std::sqrt(count * row_ratio));
  const int rows = (count + columns - 1) / columns;
  // In distances of neighbours; the first and last balls keep half of one from the sides.
  const double width = columns + 0.5;
  const double height = (rows - 1) * row_ratio + 1;
  const double spacing = std::sqrt(count * ball_area / 0.70 / (width * height));
  Scene scene = box("DENSE", width * spacing, height * spacing);
  for (int n = 0; n < count; ++n) {
    const int row = n / columns;
    const Vec2 site{n % columns + (row % 2 == 0 ? 0.5 : 1), row * row_ratio + 0.5};
    const double speed = random.uniform(0, top_speed);
    scene.balls.push_back(
        {.position = spacing * site, .velocity = speed * direction(random), .radius = radius});
  }
  return scene;
}

/// A loose lattice, wider than high, above a floor between two walls.
Scene pile(int count) {
  Random random(3);
  const int columns = static_cast<int>(std::sqrt(1.6 * count));
  const int rows = (count + columns - 1) / columns;
  const double spacing = 24;
  const double shift = 1.5;  // leaves neighbours 1 px apart
  Scene scene;
  scene.name = "PILE";
  scene.width = columns * spacing;
  scene.height = (rows + 1) * spacing;
  scene.edges.top = carom::Edge::open;
  scene.gravity = 500;
  for (int n = 0; n < count; ++n) {
    const int row = n / columns;
    const Vec2 site{(n % columns + 0.5) * spacing, (row + 0.5) * spacing};
    scene.balls.push_back(
        {.position = site + Vec2{random.uniform(-shift, shift), 0}, .radius = radius});
  }
  return scene;
}

Workload one(std::string name, int balls, Scene (*build)(int), int warm_up, int steps) {
  return {.scene = std::move(name),
          .balls = balls,
          .starts = [=] { return std::vector<Scene>{build(balls)}; },
          .warm_up = warm_up,
          .steps = steps};
}

Workload shots(std::string name, int balls, bool holes) {
  return {.scene = std::move(name),
          .balls = balls,
          .starts = [=] { return random_shots(balls, holes); },
          .ours_alone = holes};
}

}  // namespace

std::vector<Workload> workloads(const std::filesystem::path& levels) {
  std::vector<Workload> all;
  all.push_back({.scene = "BREAK", .balls = 37, .starts = [] {
                   return std::vector<Scene>{break_without_holes()};
                 }});
  for (const int balls : {2, 4, 8, 16}) all.push_back(shots("TABLE", balls, false));
  for (const int balls : {2, 4, 8, 16}) all.push_back(shots("BILLIARDS", balls, true));
  all.push_back({.scene = "BILLIARDS",
                 .balls = 37,
                 .starts = [] { return std::vector<Scene>{billiards_break()}; },
                 .ours_alone = true});
  all.push_back({.scene = "BREAKS", .balls = 37, .starts = random_breaks, .ours_alone = true});
  all.push_back(shots("SCATTERED", 37, true));
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(levels))
    if (entry.path().extension() == ".json" && entry.path().stem().extension() != ".proof" &&
        entry.path().filename() != "pack.json")
      files.push_back(entry.path());
  std::ranges::sort(files);
  for (const std::filesystem::path& file : files)
    all.push_back({.scene = "LEVEL-" + file.filename().string().substr(0, 2),
                   .balls = static_cast<int>(random_throws(file).front().balls.size()),
                   .starts = [file] { return random_throws(file); },
                   .most_steps = games::angry_balls::offer_steps,
                   .ours_alone = true});
  // Fewer steps for many balls, the same for every engine.
  const auto add = [&](const char* name, int balls, Scene (*build)(int), int warm_up, int steps,
                       bool big = false) {
    all.push_back(one(name, balls, build, warm_up, steps));
    all.back().big = big;
  };
  add("GAS", 100, gas, 20, 1000);
  add("GAS", 1000, gas, 20, 200);
  add("GAS", 10'000, gas, 20, 100);
  add("GAS", 100'000, gas, 10, 20);
  add("GAS", 1'000'000, gas, 5, 10, true);
  // Few steps: three that touch share their energy (docs/physics.md#three-balls), so that our balls
  // would soon stand, where those of others go on or fly apart.
  add("DENSE", 100, dense, 5, 20);
  add("DENSE", 1000, dense, 5, 20);
  add("DENSE", 10'000, dense, 5, 20);
  add("DENSE", 100'000, dense, 5, 20, true);
  add("DENSE", 1'000'000, dense, 5, 20, true);
  // The lattice falls together during the warm-up: what is measured is the pile.
  for (const auto& [balls, warm_up, steps] : {std::array{1000, 100, 200}, {10'000, 150, 50}}) {
    add("PILE", balls, pile, warm_up, steps);
    // Of a material in which piles of other engines come to rest.
    all.back().restitution = 0.2;
    all.back().grip = 0.3;
  }
  return all;
}

}  // namespace bench

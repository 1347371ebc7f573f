// The golden table: what the engine and the rules compute, as hashes at several steps of many
// scenes. golden/hashes.txt must come out of every compiler, optimisation level and processor.
// Run it in the repository's root, where scenes/ and levels/ are:
//
//   golden_hashes TABLE      compares
//   golden_hashes --print    writes the table
//   golden_hashes --steps N  reads a scene from standard input and prints its state hash after each
//                            of N steps

#include <array>
#include <clocale>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <iterator>
#include <span>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "carom/fnv1a.hpp"
#include "carom/scene_file.hpp"
#include "carom/trace.hpp"
#include "carom/world.hpp"
#include "games/angry_balls.hpp"
#include "games/billiards.hpp"
#include "games/random.hpp"
#include "search/opponent.hpp"

namespace {

using carom::Scene;
using carom::Vec2;
using carom::World;

int threads = 1;

[[noreturn]] void fail(const std::string& why, int status) {
  std::puts(why.c_str());
  std::exit(status);
}

constexpr int differs = 1;
constexpr int unusable = 2;

template <class T>
T good(carom::Result<T> result, const std::string& what) {
  if (!result) fail(carom::to_string(result.errors().front(), what), unusable);
  return std::move(result).value();
}

std::string read_file(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) fail(path + " cannot be read", unusable);
  return {std::istreambuf_iterator<char>(file), {}};
}

class Random : games::Random {
 public:
  using games::Random::Random;

  /// A multiple of 1/1024 in [low, high): products and sums of such numbers are exact, so the
  /// scenes are the same even where the engine is compiled wrongly, and differences are the
  /// engine's.
  double uniform(int low, int high) {
    const auto range = static_cast<std::uint64_t>(high - low) * 1024;
    return low + static_cast<double>(below(range)) / 1024;
  }
  bool chance(unsigned percent) { return below(100) < percent; }
};

/// Takes the table's lines as they are computed (scene, step, state hash, hash of all events so
/// far, in games the scores) and prints them, or compares them with those of a file.
class Table {
 public:
  Table() {
    std::puts("# scene, step, state hash, hash of all events so far, in games the scores");
  }
  explicit Table(const std::string& path) {
    std::istringstream file(read_file(path));
    for (std::string line; std::getline(file, line);)
      if (!line.starts_with('#')) expected_.push_back(line);
    if (expected_.empty()) fail(path + " has no lines", unusable);
  }

  void add(std::string_view scene, std::uint64_t step, std::uint64_t state, std::uint64_t events,
           std::string_view scores) {
    std::string line(scene);
    line.append(" ").append(std::to_string(step));
    line.append(" ").append(carom::hash_text(state));
    line.append(" ").append(carom::hash_text(events));
    if (!scores.empty()) line.append(" ").append(scores);
    if (expected_.empty())
      std::puts(line.c_str());
    else
      compare(line);
    ++count_;
  }

  void end() {
    if (expected_.empty()) return;
    if (count_ < expected_.size()) compare("nothing");
    std::printf("%zu lines equal\n", count_);
  }

 private:
  void compare(const std::string& line) const {
    const std::string expected = count_ < expected_.size() ? expected_[count_] : "nothing";
    if (line == expected) return;
    fail("differs after " + std::to_string(count_) + " equal lines\n  expected " + expected +
             "\n  got      " + line,
         differs);
  }

  std::vector<std::string> expected_{};  ///< empty when printing
  std::size_t count_ = 0;
};

/// Notes a scene's hashes every so many steps, and at its end.
class Recorder {
 public:
  Recorder(Table& table, std::string scene, std::uint64_t every)
      : table_(table), scene_(std::move(scene)), every_(every) {}

  void step(const World& world, std::span<const carom::Event> events,
            std::string_view scores = {}) {
    for (const carom::Event& event : events) add(event);
    if (++steps_ % every_ == 0) note(world, scores);
  }
  void end(const World& world, std::string_view scores = {}) {
    if (steps_ % every_ != 0) note(world, scores);
  }

 private:
  void note(const World& world, std::string_view scores) {
    table_.add(scene_, steps_, world.state_hash(), events_.hash(), scores);
  }
  void add(const carom::Event& event) {
    events_.add(static_cast<std::uint8_t>(event.kind));
    events_.add(event.ball);
    events_.add(event.other);
    for (const double number : {event.position.x, event.position.y, event.deviation.x,
                                event.deviation.y, event.damage, event.solidity})
      events_.add(number);
  }

  Table& table_;
  std::string scene_;
  std::uint64_t every_;
  std::uint64_t steps_ = 0;
  carom::Fnv1a events_;
};

void run(Table& table, const std::string& name, Scene scene, int steps, std::uint64_t every) {
  World world = good(World::create(std::move(scene)), name);
  world.set_threads(threads);
  Recorder recorder(table, name, every);
  for (int step = 0; step < steps; ++step) {
    const auto events = world.step();
    recorder.step(world, events);
  }
  recorder.end(world);
}

void run_file(Table& table, const std::string& name, int steps, std::uint64_t every) {
  const std::string path = "scenes/" + name + ".json";
  run(table, name, good(carom::read_scene(read_file(path)), path), steps, every);
}

/// A game of a player without a plan, until only the cue ball is left.
void play_billiards(Table& table, std::uint64_t seed) {
  namespace billiards = games::billiards;
  billiards::Game game;
  Random random(seed);
  Recorder recorder(table, "billiards-" + std::to_string(seed), 10'000);
  const auto scores = [&] {
    return std::to_string(game.score(0)) + ":" + std::to_string(game.score(1));
  };
  while (game.phase() != billiards::Phase::over) {
    if (game.phase() == billiards::Phase::aim) {
      const Vec2 drag{random.uniform(-400, 400), random.uniform(-400, 400)};
      good(game.apply(billiards::Shoot{drag}), "shot");
    } else if (game.phase() == billiards::Phase::place) {
      Vec2 position;
      do position = {random.uniform(0, 800), random.uniform(0, 400)};
      while (game.obstruction(position) != billiards::Obstruction::none);
      good(game.apply(billiards::Place{position}), "placement");
    }
    game.step();
    recorder.step(game.world(), game.physics_events(), scores());
  }
  recorder.end(game.world(), scores());
}

/// One throw after the other until the level is won or lost; each watched to its end and half a
/// second beyond.
void play_level(Table& table, const std::string& name, const std::string& level,
                std::span<const Vec2> drags) {
  namespace angry_balls = games::angry_balls;
  using angry_balls::Phase;
  const std::string path = "levels/" + level + ".json";
  auto game =
      good(angry_balls::Game::create(good(angry_balls::read_level(read_file(path)), path)), path);
  Recorder recorder(table, name, 100);
  const auto step = [&] {
    game.step();
    recorder.step(game.world(), game.physics_events(), std::to_string(game.score()));
  };
  for (const Vec2 drag : drags) {
    good(game.apply(angry_balls::Throw{drag}), "throw");
    while (game.phase() == Phase::fly) step();
    for (int more = 0; more < 50 && game.phase() == Phase::offer; ++more) step();
    if (game.phase() != Phase::offer) break;
    good(game.apply(angry_balls::Next{}), "next throw");
  }
  recorder.end(game.world(), std::to_string(game.score()));
}

/// Throws that win the level.
void play_recorded_throws(Table& table, const std::string& level) {
  std::ifstream file("tests/levels/original/" + level + ".throws");
  std::vector<Vec2> drags;
  for (Vec2 drag; file >> drag.x >> drag.y;) drags.push_back(drag);
  if (drags.empty()) fail("no throws for level " + level, unusable);
  play_level(table, "level-" + level, level, drags);
}

void play_random_throws(Table& table, const std::string& level, std::uint64_t seed) {
  Random random(seed);
  std::array<Vec2, 3> drags;
  for (Vec2& drag : drags) drag = {random.uniform(50, 400), random.uniform(-100, 300)};
  play_level(table, "level-" + level + "-random-" + std::to_string(seed), level, drags);
}

Vec2 random_vector(Random& random, int most) {
  return {random.uniform(-most, most), random.uniform(-most, most)};
}

/// Balls of radius 3 in a square lattice with gaps, in all directions.
Scene gas(int columns, int rows, int speed, std::uint64_t seed) {
  constexpr double pitch = 9;  // px
  Random random(seed);
  Scene scene{.width = columns * pitch, .height = rows * pitch, .friction = 1};
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column)
      scene.balls.push_back({.position = {(column + 0.5) * pitch, (row + 0.5) * pitch},
                             .velocity = random_vector(random, speed),
                             .radius = 3});
  return scene;
}

/// A jittered lattice that falls into a heap. `pitch`: px; below 24 neighbours may overlap.
Scene pile(int columns, int rows, double pitch, std::uint64_t seed) {
  Random random(seed);
  Scene scene{.width = columns * pitch + 20, .height = rows * pitch + 200, .gravity = 500};
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column)
      scene.balls.push_back({.position = {column * pitch + random.uniform(10, 14),
                                          row * pitch + random.uniform(10, 14)},
                             .radius = random.uniform(6, 10)});
  return scene;
}

/// Radii of 1 to 160 px, anywhere: most balls overlap several others at the start.
Scene mixed_radii(int balls, std::uint64_t seed) {
  Random random(seed);
  Scene scene{.width = 2000, .height = 1200};
  for (const int x : {300, 1000, 1700})
    scene.holes.push_back({.position = {x * 1.0, 600}, .radius = 40});
  for (int n = 0; n < balls; ++n) {
    const double radius = random.chance(4) ? random.uniform(40, 160) : random.uniform(1, 20);
    scene.balls.push_back({.position = {random.uniform(160, 1840), random.uniform(160, 1040)},
                           .velocity = random_vector(random, 1000),
                           .radius = radius});
  }
  return scene;
}

/// Everything that a level can have: gravity, obstacles, balls that break, open sides, a hole, a
/// projectile that is far too fast (sub-steps).
Scene fortress(std::uint64_t seed) {
  Random random(seed);
  Scene scene{
      .width = 1200,
      .height = 600,
      .edges = {.left = carom::Edge::open, .right = carom::Edge::open, .top = carom::Edge::open},
      .gravity = 600,
      .damage_threshold = 100};
  scene.holes = {{.position = {620, 60}, .radius = 24}};
  scene.obstacles = {{.x = 400, .height = 150, .radius = 14},
                     {.x = 800, .height = 220, .radius = 20},
                     {.x = 850, .height = 90, .radius = 10}};
  scene.balls.push_back({.role = carom::Role::projectile,
                         .position = {60, 400},
                         .velocity = {20'000, -3'000},
                         .radius = 12});
  for (int column = 0; column < 16; ++column)
    for (int row = 0; row < 6; ++row) {
      const double x = 440 + column * 21;
      if (x > 765) continue;
      scene.balls.push_back({.role = random.chance(50) ? carom::Role::enemy : carom::Role::neutral,
                             .position = {x, 12 + row * 20.5},
                             .radius = random.uniform(8, 11),
                             .solidity = random.uniform(50, 20'000)});
    }
  for (int n = 0; n < 30; ++n)
    scene.balls.push_back({.role = carom::Role::enemy,
                           .position = {random.uniform(880, 1180), random.uniform(30, 500)},
                           .velocity = random_vector(random, 400),
                           .radius = random.uniform(4, 16),
                           .solidity = random.uniform(50, 20'000)});
  return scene;
}

/// Many balls on one spot, and some as fast as a scene may have them.
Scene crowd() {
  Scene scene{.width = 800, .height = 400, .edges = {.right = carom::Edge::open}};
  for (int n = 0; n < 60; ++n) scene.balls.push_back({.position = {400, 200}, .radius = 5});
  for (int n = 0; n < 8; ++n)
    scene.balls.push_back({.position = {20.0 + 40 * n, 40},
                           .velocity = {n * 9'000.0, 60'000 - n * 7'000.0},
                           .radius = 3.0 + n});
  return scene;
}

/// Numbers as they go into files and come back: the "state" is the hash of the file's bytes.
void write_numbers(Table& table) {
  Scene scene = mixed_radii(400, 5);
  World world = good(World::create(scene), "numbers");
  for (int step = 0; step < 30; ++step) world.step();
  // Positions after some steps use all the digits.
  scene.balls.clear();
  scene.edges = {carom::Edge::open, carom::Edge::open, carom::Edge::open, carom::Edge::open};
  for (std::size_t i = 0; i < world.size(); ++i) scene.balls.push_back(world.ball(i));
  const std::string bytes = carom::write_scene(scene);
  const Scene again = good(carom::read_scene(bytes), "numbers");
  carom::Fnv1a written;
  written.add(std::string_view(bytes));
  table.add("numbers-in-a-file", 30, written.hash(),
            good(World::create(again), "numbers").state_hash(), {});
}

/// Decisions of the computer, a line for every hundred: the "state" is the hash of all so far, the
/// "events" that of what was found on the way.
class Decisions {
 public:
  Decisions(Table& table, std::string name) : table_(table), name_(std::move(name)) {}

  search::Decision decide(const search::Game& game, const search::Level& level) {
    search::Opponent opponent = good(search::Opponent::create(game, level, 1, count_), "decision");
    while (!opponent.done()) opponent.advance(7, rollouts_);
    const search::Decision decision = opponent.decision();
    if (decision.meant.place) add(decisions_, *decision.meant.place);
    add(decisions_, decision.drag);
    add(aims_, search::drag(decision.meant.aim));
    if (++count_ % 100 == 0) table_.add(name_, count_, decisions_.hash(), aims_.hash(), {});
    return decision;
  }
  std::uint64_t count() const { return count_; }

 private:
  static void add(carom::Fnv1a& hash, Vec2 vector) {
    hash.add(vector.x);
    hash.add(vector.y);
  }

  Table& table_;
  std::string name_;
  carom::Rollouts rollouts_{threads};
  std::uint64_t count_ = 0;
  carom::Fnv1a decisions_;
  carom::Fnv1a aims_;
};

void decide_billiards(Table& table, std::uint64_t count) {
  namespace billiards = games::billiards;
  const std::array<search::Level, 2> players{{{.name = "hand", .hand = {6}, .simulations = 10},
                                              {.name = "exact", .hand = {}, .simulations = 20}}};
  Decisions decisions(table, "decisions-billiards");
  billiards::Game game;
  while (decisions.count() < count) {
    if (game.phase() == billiards::Phase::over) game = billiards::Game();
    const search::Decision decision =
        decisions.decide(game, players[static_cast<std::size_t>(game.player())]);
    if (decision.meant.place) good(game.apply(billiards::Place{*decision.meant.place}), "place");
    good(game.apply(billiards::Shoot{decision.drag}), "shot");
    while (game.phase() == billiards::Phase::roll) game.step();
  }
}

void decide_throws(Table& table, std::uint64_t count) {
  namespace angry_balls = games::angry_balls;
  Decisions decisions(table, "decisions-levels");
  std::vector<angry_balls::Game> levels;
  for (const char* name :
       {"01-first-steps", "05-over-the-wall", "06-skittles", "10-the-fortress"}) {
    const std::string path = std::string("levels/") + name + ".json";
    levels.push_back(good(
        angry_balls::Game::create(good(angry_balls::read_level(read_file(path)), path)), path));
  }
  while (decisions.count() < count)
    decisions.decide(
        levels[decisions.count() / 2 % levels.size()],
        {.name = "", .hand = {decisions.count() % 2 == 0 ? 0.0 : 5.0}, .simulations = 12});
}

void compute(Table table) {
  run_file(table, "two-balls", 300, 100);
  run_file(table, "three-balls", 300, 100);
  run_file(table, "hole", 60, 20);
  run_file(table, "break", 1000, 200);
  for (const std::uint64_t seed : {1U, 2U}) play_billiards(table, seed);
  for (const char* level : {"01-first-steps", "03-pass-it-on", "05-over-the-wall", "07-the-pit",
                            "09-the-crown", "10-the-fortress"})
    play_recorded_throws(table, level);
  play_random_throws(table, "06-skittles", 1);
  play_random_throws(table, "10-the-fortress", 2);
  run(table, "fortress", fortress(1), 400, 50);
  run(table, "crowd", crowd(), 120, 20);
  run(table, "mixed-radii", mixed_radii(300, 2), 400, 50);
  run(table, "pile-200", pile(20, 10, 24, 3), 600, 100);
  run(table, "pile-2000", pile(100, 20, 18, 4), 40, 10);
  run(table, "gas-1500", gas(50, 30, 300, 5), 200, 25);
  run(table, "gas-20000", gas(200, 100, 400, 6), 3, 1);
  write_numbers(table);
  decide_billiards(table, 700);
  decide_throws(table, 300);
  table.end();
}

void print_steps(long steps) {
  const std::string json(std::istreambuf_iterator<char>(std::cin), {});
  World world = good(World::create(good(carom::read_scene(json), "scene")), "scene");
  for (; steps > 0; --steps) {
    world.step();
    std::puts(carom::hash_text(world.state_hash()).c_str());
  }
}

}  // namespace

int main(int argc, char** argv) {
  std::vector<std::string> arguments(argv + 1, argv + argc);
  if (arguments.size() == 3 && arguments[1] == "--locale") {
    const bool known = std::setlocale(LC_ALL, arguments[2].c_str()) != nullptr;
    if (!known || *std::localeconv()->decimal_point != ',') fail("no decimal comma", unusable);
    arguments.resize(1);
  }
  if (arguments.size() == 3 && arguments[1] == "--threads") {
    threads = std::atoi(arguments[2].c_str());
    arguments.resize(1);
  }
  if (arguments.size() == 1 && arguments[0] == "--print")
    compute(Table());
  else if (arguments.size() == 2 && arguments[0] == "--steps")
    print_steps(std::strtol(arguments[1].c_str(), nullptr, 10));
  else if (arguments.size() == 1)
    compute(Table(arguments[0]));
  else
    fail("Usage: golden_hashes TABLE [--threads N | --locale NAME] | --print | --steps N",
         unusable);
}

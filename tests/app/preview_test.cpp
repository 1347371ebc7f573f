#include "app/play/preview.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <rapidcheck/gtest.h>

#include "app/storage/level.hpp"
#include "games/angry_balls.hpp"
#include "games/billiards.hpp"
#include "games/launch.hpp"

namespace {

using app::BallPath;
using app::Preview;
using app::PreviewLength;
namespace billiards = games::billiards;
namespace angry_balls = games::angry_balls;

constexpr double gone = std::numeric_limits<double>::quiet_NaN();
constexpr PreviewLength lengths[] = {PreviewLength::contact, PreviewLength::brief,
                                     PreviewLength::full};

carom::Vec2 random_drag() {
  const auto part = [] { return *rc::gen::inRange(-420 * 64, 420 * 64) / 64.0; };
  const carom::Vec2 drag{part(), part()};
  RC_PRE(games::launch_factor * carom::length(drag) >= carom::rest_speed);
  return drag;
}

/// Where the balls of a real game are after each step, by id; not a number once they are gone.
using Places = std::vector<std::vector<carom::Vec2>>;

template <class Game>
bool under_way(const Game& game) {
  if constexpr (std::is_same_v<Game, billiards::Game>)
    return game.phase() == billiards::Phase::roll;
  else
    return game.phase() == angry_balls::Phase::fly;
}

template <class Game, class Command>
Places play(Game& game, const Command& command) {
  std::size_t ids = 0;
  for (std::size_t i = 0; i < game.world().size(); ++i)
    ids = std::max(ids, std::size_t{game.world().ball(i).id} + 1);
  Places places;
  const auto note = [&] {
    auto& now = places.emplace_back(ids, carom::Vec2{gone, gone});
    for (std::size_t i = 0; i < game.world().size(); ++i)
      if (game.world().in_play(i)) now[game.world().ball(i).id] = game.world().ball(i).position;
  };
  note();
  RC_ASSERT(bool(game.apply(command)));
  while (under_way(game) && places.size() <= app::full_steps) {
    game.step();
    note();
  }
  return places;
}

/// Every step of a path is one of the real game, to the last bit, and none is left out. Gives the
/// last step.
int expect_real(const BallPath& path, const Places& places, std::uint32_t id, int before) {
  for (const app::Waypoint& waypoint : path) {
    if (waypoint.bend) {
      RC_ASSERT(waypoint.step == before + 1 || waypoint.step == before);
      continue;
    }
    RC_ASSERT(waypoint.step == before + 1);
    before = waypoint.step;
    RC_ASSERT(std::size_t(before) < places.size());
    RC_ASSERT(waypoint.at == places[std::size_t(before)][id]);
  }
  return before;
}

/// The preview of a turn, of each length, against the turn itself.
void expect_what_happens(app::Previewer& previewer, const carom::World& world, carom::Vec2 drag,
                         const Places& places) {
  app::Aim aim;
  aim.set(drag);
  for (const PreviewLength length : lengths) {
    const Preview& preview = previewer.of(world, aim, {.preview = length}, true);
    const std::uint32_t lead = world.ball(0).id;
    int last = expect_real(preview.lead, places, lead, -1);
    RC_ASSERT(preview.ghost.has_value() || preview.lead_after.empty());
    last = expect_real(preview.lead_after, places, lead, last);
    if (!preview.target.empty())
      expect_real(preview.target, places, preview.target_ball, preview.target.front().step - 1);
    if (length == PreviewLength::full) {
      int in_play = 0;  // the last step that the lead lived to see
      for (std::size_t i = 0; i < places.size(); ++i)
        if (!std::isnan(places[i][lead].x)) in_play = static_cast<int>(i);
      RC_ASSERT(last == std::min(in_play, app::full_steps));
    }
    for (std::size_t i = 0; i < preview.dots.size(); ++i)
      RC_ASSERT(preview.dots[i] == places[(i + 1) * app::steps_per_dot][lead]);
    if (preview.pocketed)
      RC_ASSERT(std::isnan(places[std::size_t(last) + 1][lead].x));
    else if (length == PreviewLength::full && world.ball(0).role == carom::Role::cue)
      RC_ASSERT(!std::isnan(places.back()[lead].x));
  }
}

RC_GTEST_PROP(Preview, IsTheShotBitByBit, ()) {
  app::Previewer previewer;
  billiards::Game game;
  const int turns = *rc::gen::inRange(1, 6);
  for (int turn = 0; turn < turns; ++turn) {
    const carom::World before = game.world();
    const carom::Vec2 drag = random_drag();
    expect_what_happens(previewer, before, drag, play(game, billiards::Shoot{drag}));
    for (int tries = 0; game.phase() == billiards::Phase::place && tries < 50; ++tries)
      (void)game.apply(billiards::Place{{100.0 + 11 * tries, 60.0 + 5 * tries}});
    if (game.phase() != billiards::Phase::aim) break;
  }
}

RC_GTEST_PROP(Preview, IsTheThrowBitByBit, ()) {
  const std::vector<app::Level> levels = app::shipped_levels();
  const auto& level = levels[*rc::gen::inRange(std::size_t{0}, levels.size())];
  app::Previewer previewer;
  auto game = angry_balls::Game::create(level.scene.value()).value();
  while (game.phase() == angry_balls::Phase::aim) {
    const carom::World before = game.world();
    const carom::Vec2 drag = random_drag();
    expect_what_happens(previewer, before, drag, play(game, angry_balls::Throw{drag}));
    if (game.phase() == angry_balls::Phase::offer) RC_ASSERT(bool(game.apply(angry_balls::Next{})));
  }
}

/// A table without friction with a cue ball at (100, 200) and reds.
carom::World table(const std::vector<carom::Vec2>& reds) {
  carom::Scene scene;
  scene.friction = 1;
  scene.balls = {{.role = carom::Role::cue, .position = {100, 200}, .radius = 8}};
  for (const carom::Vec2 red : reds) scene.balls.push_back({.position = red});
  scene.holes = {{.position = {10, 10}}};
  return carom::World::create(scene).value();
}

Preview ahead(const carom::World& world, carom::Vec2 drag,
              PreviewLength length = PreviewLength::brief) {
  return app::look_ahead(world, drag, length);
}

TEST(Preview, TheGhostTouchesTheBallItHits) {
  const Preview preview = ahead(table({{300, 208}, {600, 380}}), {100, 0});
  ASSERT_TRUE(preview.ghost);
  EXPECT_EQ(preview.target_ball, 1u);
  EXPECT_NEAR(carom::length(*preview.ghost - preview.target.front().at), 18, 1e-9);
  EXPECT_EQ(preview.lead.back().at, *preview.ghost);
  // The red goes where it is pushed, the cue ball at a right angle to it, up to the cushions.
  const carom::Vec2 red = preview.target.back().at - preview.target.front().at;
  const carom::Vec2 cue = preview.lead_after.back().at - preview.lead_after.front().at;
  EXPECT_GT(red.y, 0);
  EXPECT_LT(cue.y, 0);
  EXPECT_NEAR(carom::dot(carom::unit(red), carom::unit(cue)), 0, 0.02);
}

TEST(Preview, BallsThatPartHaveNoContact) {
  // The cue ball overlaps the red still after a step, and is put apart from it.
  const carom::World close = table({{100, 212}});
  EXPECT_FALSE(ahead(close, {0, -15}, PreviewLength::contact).ghost);
  EXPECT_TRUE(ahead(close, {0, 15}, PreviewLength::contact).ghost);
}

TEST(Preview, BriefEndsAtTheNextContactOfEach) {
  const Preview preview = ahead(table({{300, 200}, {500, 200}}), {100, 0});
  // Head on: the first red stops at the second, 20 px before it.
  EXPECT_NEAR(preview.target.back().at.x, 480, 4);
}

TEST(Preview, GoesOnAfterACushion) {
  const Preview preview = ahead(table({{500, 200}}), {100, 100});
  ASSERT_TRUE(preview.ghost) << "up to the cushion and down to the red";
  double highest = 0;
  for (const app::Waypoint& waypoint : preview.lead)
    if (waypoint.bend) highest = std::max(highest, waypoint.at.y);
  EXPECT_EQ(highest, 392) << "the bend at the cushion is a place of its own";
}

TEST(Preview, ContactEndsThere) {
  const Preview preview = ahead(table({{300, 208}}), {100, 0}, PreviewLength::contact);
  EXPECT_TRUE(preview.ghost);
  EXPECT_TRUE(preview.lead_after.empty());
  EXPECT_TRUE(preview.target.empty());
}

TEST(Preview, TellsThatTheCueBallFalls) {
  EXPECT_TRUE(ahead(table({}), {-90, -190}).pocketed);
  EXPECT_FALSE(ahead(table({}), {100, 0}).pocketed);
}

TEST(Preview, BriefLooksThreeSecondsAhead) {
  EXPECT_EQ(ahead(table({}), {100, 0}).lead.back().step, app::brief_steps);
}

TEST(Preview, NothingWhenItIsOffOrNothingIsLaunched) {
  EXPECT_EQ(ahead(table({}), {100, 0}, PreviewLength::off), Preview{});
  EXPECT_EQ(ahead(table({}), {0, 0}), Preview{});
}

TEST(Preview, DotsShowTheFirstSecondOfFlight) {
  const carom::World level = carom::World::create(app::shipped_levels()[0].scene.value()).value();
  EXPECT_EQ(ahead(level, {-20, 100}).dots.size(),
            std::size_t{app::dotted_steps / app::steps_per_dot});
  EXPECT_LT(ahead(level, {155, -14}, PreviewLength::contact).dots.size(),
            std::size_t{app::dotted_steps / app::steps_per_dot})
      << "up to the contact";
  EXPECT_GT(ahead(level, {-20, 380}, PreviewLength::full).dots.size(),
            std::size_t{app::dotted_steps / app::steps_per_dot});
}

TEST(Previewer, MakesAPreviewOnlyWhenSomethingChanged) {
  app::Previewer previewer;
  carom::World world = table({{300, 208}});
  app::Aim aim;
  aim.set({100, 0});
  app::AimSettings settings;
  const Preview first = previewer.of(world, aim, settings, false);
  for (int i = 0; i < 5; ++i) EXPECT_EQ(previewer.of(world, aim, settings, false), first);
  EXPECT_EQ(previewer.made(), 1u);
  aim.turn(1);
  EXPECT_NE(previewer.of(world, aim, settings, false), first);
  EXPECT_EQ(previewer.made(), 2u);
  ASSERT_TRUE(world.place_lead({120, 200}));
  EXPECT_NE(previewer.of(world, aim, settings, false), first);
  EXPECT_EQ(previewer.made(), 3u);
  settings.preview = PreviewLength::contact;
  EXPECT_TRUE(previewer.of(world, aim, settings, false).target.empty());
  EXPECT_EQ(previewer.made(), 4u);
}

TEST(Previewer, FullIsForPracticeOnly) {
  app::Previewer previewer;
  const carom::World world = table({});
  app::Aim aim;
  aim.set({100, 0});
  const app::AimSettings settings{.preview = PreviewLength::full};
  EXPECT_EQ(previewer.of(world, aim, settings, false).lead.back().step, app::brief_steps);
  EXPECT_GT(previewer.of(world, aim, settings, true).lead.back().step, app::brief_steps);
  aim.set({1, 0});
  EXPECT_EQ(previewer.of(world, aim, settings, true), Preview{}) << "too weak to be a launch";
}

/// In a level the dots tell the first second, and no ring lies beyond it, unless the player wants
/// to see more.
TEST(Preview, InALevelEndsWithTheDots) {
  carom::Scene scene;
  scene.gravity = 1;
  scene.width = 2000;
  scene.balls = {{.role = carom::Role::projectile, .position = {100, 200}},
                 {.role = carom::Role::enemy, .position = {800, 199}}};
  const carom::World level = carom::World::create(scene).value();
  app::Aim aim;
  app::Previewer previewer;
  const auto ring = [&](double drag, PreviewLength length) {
    aim.set({drag, 0});
    return previewer.of(level, aim, {.preview = length}, false).ghost.has_value();
  };
  EXPECT_TRUE(ring(200, PreviewLength::brief)) << "after 0.7 s";
  EXPECT_FALSE(ring(100, PreviewLength::brief)) << "after 1.8 s";
  EXPECT_FALSE(ring(100, PreviewLength::contact));
  EXPECT_TRUE(ring(100, PreviewLength::full));
  EXPECT_EQ(previewer.of(level, aim, {}, false).dots.size(), 20U);
}

}  // namespace

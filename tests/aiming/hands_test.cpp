// Simulated hands: what a hand that is 1.5 points off wins by the real Launcher and Viewport.

#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <functional>
#include <gtest/gtest.h>
#include <iterator>
#include <map>
#include <random>
#include <sstream>

#include "app/hud/aim_controls.hpp"
#include "app/play/launcher.hpp"
#include "app/view/level_view.hpp"
#include "games/angry_balls.hpp"
#include "games/launch.hpp"
#include "search/proof_file.hpp"

namespace {

using app::Launcher;
using app::Point;
namespace angry_balls = games::angry_balls;

constexpr double noise = 1.5;  ///< points of the screen, the standard deviation on each axis

/// A level in a window, and the hand in front of it.
class Hand {
 public:
  Hand(const carom::Scene& level, app::View view, unsigned seed) : random_(seed), view_(view) {
    const app::GameLayout layout = app::GameLayout::of(view);
    stage_ = {.lead = level.balls[0],
              .viewport = app::level_viewport(layout.world, level),
              .view = view,
              .world = layout.world,
              .meter = app::strength_meter(view, layout.footer),
              .shoot = app::shoot_button(view, layout.footer),
              .fine = app::fine_field(view, layout.footer)};
  }

  // What the hand launches when it means to launch `drag`. It sees the aim, and lets go when that
  // is what it wants, as far as it can.

  carom::Vec2 pull(carom::Vec2 drag) {
    Launcher launcher;
    const Point lead = stage_.viewport.to_window(stage_.lead.position);
    const Point back = lead - stage_.viewport.to_window(stage_.lead.position + drag);
    const Point way = app::unit(back);
    const double wanted = carom::length(games::launch_velocity(drag));
    press(launcher, lead);
    // It pulls until the strength is what it wants, if the window does not end before.
    float far = 0;
    while (far < 3000 && inside(lead + way * far) && launcher.aim.speed() < wanted)
      move(launcher, lead + way * (far += 0.25f));
    move(launcher, shaken(lead + way * far));
    const carom::Vec2 result = launcher.aim.drag();
    return result;
  }

  /// A tap, a drag across, the bar, the button. `small_steps`: then the field for small steps, too.
  carom::Vec2 turn_and_slide(carom::Vec2 drag, bool small_steps) {
    Launcher launcher;
    app::Aim wanted;
    wanted.set(drag);
    const Point lead = stage_.viewport.to_window(stage_.lead.position);
    const Point way = app::unit(stage_.viewport.to_window(stage_.lead.position + drag) - lead);
    float far = 60 * view_.density;
    while (stage_.world.inset(10).contains(lead + way * (far + 1))) ++far;
    const Point there = lead + way * far;
    press(launcher, shaken(there));
    release(launcher, pointer_);
    const auto too_little = [&] {  // degrees
      return static_cast<float>(std::remainder(wanted.degrees() - launcher.aim.degrees(), 360.0));
    };
    drag_until(launcher, there, app::turned(way) * -10, too_little);
    slide(launcher, wanted.speed());
    if (small_steps) {
      const Point fine = stage_.fine.center();
      drag_until(launcher, fine, Point{-100, 0}, too_little);
      drag_until(launcher, fine, Point{0, -1},
                 [&] { return static_cast<float>(wanted.speed() - launcher.aim.speed()); });
    }
    EXPECT_EQ(press(launcher, stage_.shoot.center()), Launcher::Outcome::launch);
    return launcher.aim.drag();
  }

 private:
  /// Holds `from` and moves until nothing is too little any more; `by`: points to move for each
  /// that is.
  template <class TooLittle>
  void drag_until(Launcher& launcher, Point from, Point by, TooLittle too_little) {
    press(launcher, from);
    Point at = from + app::unit(by) * (8 * view_.density);
    move(launcher, at);
    for (int i = 0; i < 4; ++i) move(launcher, at = at + by * (view_.density * too_little()));
    release(launcher, shaken(at));
  }
  void slide(Launcher& launcher, double speed) {
    const auto place = [&](double at) {
      const auto share = static_cast<float>(at / games::max_launch_speed);
      return Point{stage_.meter.x + stage_.meter.w * share, stage_.meter.center().y};
    };
    press(launcher, place(launcher.aim.speed()));
    move(launcher, place(speed));
    release(launcher, shaken(place(speed)));
  }
  Launcher::Outcome press(Launcher& launcher, Point at) {
    move(launcher, at);
    return launcher.event(app::PointerPressed{at, app::PointerButton::left, view_.touch}, stage_);
  }
  void move(Launcher& launcher, Point at) {
    pointer_ = at;
    launcher.event(app::PointerMoved{at}, stage_);
  }
  void release(Launcher& launcher, Point at) {
    move(launcher, at);
    launcher.event(app::PointerReleased{at}, stage_);
  }
  bool inside(Point at) const { return view_.area().contains(at); }
  Point shaken(Point at) {
    const auto off = [&] { return static_cast<float>(noise * normal_(random_)) * view_.density; };
    at = at + Point{off(), 0};
    at = at + Point{0, off()};
    return {std::clamp(at.x, 0.0f, view_.width - 1), std::clamp(at.y, 0.0f, view_.height - 1)};
  }

  std::mt19937 random_;
  std::normal_distribution<double> normal_;
  app::View view_;
  Launcher::Stage stage_;
  Point pointer_;
};

/// The shipped levels, by the names of their files.
std::map<std::string, carom::Scene> shipped_levels() {
  std::map<std::string, carom::Scene> levels;
  for (const auto& entry : std::filesystem::directory_iterator(SOURCE_DIR "/levels")) {
    if (entry.path().extension() != ".json" ||
        search::lies_beside_levels(entry.path().filename().string()))
      continue;
    std::ifstream file(entry.path());
    const std::string json(std::istreambuf_iterator<char>(file), {});
    levels.emplace(entry.path().stem().string(), angry_balls::read_level(json).value());
  }
  return levels;
}

std::vector<carom::Vec2> recorded_throws(const std::string& name) {
  std::ifstream file(SOURCE_DIR "/tests/levels/original/" + name + ".throws");
  std::vector<carom::Vec2> throws;
  carom::Vec2 drag;
  while (file >> drag.x >> drag.y) throws.push_back(drag);
  return throws;
}

bool wins(angry_balls::Game game, std::span<const carom::Vec2> throws,
          const std::function<carom::Vec2(carom::Vec2)>& by_hand) {
  for (const carom::Vec2 drag : throws) {
    if (!game.apply(angry_balls::Throw{by_hand(drag)})) return false;
    while (game.phase() == angry_balls::Phase::fly) game.step();
    if (game.phase() != angry_balls::Phase::offer) break;
    if (!game.apply(angry_balls::Next{})) return false;
  }
  return game.phase() == angry_balls::Phase::won;
}

app::View desktop() { return app::View::of(1280, 720); }
app::View phone() {
  app::View view = app::View::of(390, 844);
  view.touch = true;
  return view;
}

/// Plays every shipped level so often, and prints what is won.
void compare(int tries) {
  std::printf("%-24s%10s%10s%10s%10s%10s\n", "", "desktop", "phone", "desktop", "phone", "desktop");
  std::array<double, 2> wins_of_all{};
  std::printf("%-24s%20s%20s%10s\n", "won of tries", "turn and bar", "with small steps", "pull");
  for (const auto& shipped : shipped_levels()) {
    const auto& [name, level] = shipped;
    const auto throws = recorded_throws(name);
    ASSERT_FALSE(throws.empty()) << name;
    const angry_balls::Game game = angry_balls::Game::create(level).value();
    std::printf("%-24s", name.c_str());
    unsigned seed = 0;
    const auto rate = [&](const app::View& view, auto by_hand) {
      Hand hand(shipped.second, view, ++seed);
      int won = 0;
      for (int i = 0; i < tries; ++i)
        won += wins(game, throws, [&](carom::Vec2 drag) { return by_hand(hand, drag); });
      std::printf("%8.1f %%", 100.0 * won / tries);
      std::fflush(stdout);
      return static_cast<double>(won) / tries;
    };
    const auto variance = [&](double share) { return share * (1 - share) / tries; };
    for (const bool small_steps : {false, true}) {
      const auto turn = [&](Hand& hand, carom::Vec2 drag) {
        return hand.turn_and_slide(drag, small_steps);
      };
      const double on_desktop = rate(desktop(), turn);
      const double on_phone = rate(phone(), turn);
      EXPECT_GE(on_phone,
                0.8 * on_desktop - 2 * std::sqrt(variance(on_phone) + 0.64 * variance(on_desktop)))
          << name;
      wins_of_all[small_steps ? 1 : 0] += on_desktop + on_phone;
    }
    rate(desktop(), [](Hand& hand, carom::Vec2 drag) { return hand.pull(drag); });
    std::printf("\n");
  }
  EXPECT_GT(wins_of_all[1], 1.2 * wins_of_all[0]) << "what the small steps are for";
}

TEST(SimulatedHands, WinOnAPhoneAsOftenAsOnADesktop) { compare(40); }
TEST(SimulatedHands, WinOnAPhoneAsOftenAsOnADesktopSlow) { compare(2000); }

}  // namespace

#include "app/play/preview.hpp"

#include <span>

#include "carom/event.hpp"
#include "games/launch.hpp"

namespace app {
namespace {

using carom::EventKind;

/// Goes along with a world and notes down the ways of two balls.
class Follower {
 public:
  Follower(const carom::World& world, PreviewLength length, int brief, Preview& preview)
      : world_(world),
        preview_(preview),
        length_(length),
        brief_(brief),
        lead_(world.ball(0).id),
        dotted_(world.scene().gravity > 0) {
    preview_.lead.push_back({world.ball(0).position, 0});
    for (std::size_t i = 0; i < world.size(); ++i) {
      const carom::Ball ball = world.ball(i);
      if (ball.id >= radius_.size()) radius_.resize(ball.id + 1);
      radius_[ball.id] = ball.radius;
    }
  }

  /// After every step.
  void note(std::span<const carom::Event> events) {
    ++step_;
    for (const carom::Event& event : events) note(event);
    if (lost_ball_) note_what_is_left();
    if (on_lead_) follow(lead_path(), 0);
    for (std::size_t i = 0; on_target_ && i < world_.size(); ++i)
      if (world_.ball(i).id == target_) follow(preview_.target, i);
    const bool reached = length_ == PreviewLength::contact && preview_.ghost;
    if (dotted_ && !lead_gone_ && !reached && step_ % steps_per_dot == 0 &&
        (step_ <= dotted_steps || length_ == PreviewLength::full))
      preview_.dots.push_back(world_.ball(0).position);
  }

  bool done() const {
    if (world_.at_rest() || game_over_) return true;
    const bool turn_over = lead_gone_ && world_.ball(0).role == carom::Role::cue;
    if (length_ == PreviewLength::full) return turn_over || step_ >= full_steps;
    if (turn_over || step_ >= brief_) return true;
    if (length_ == PreviewLength::contact && preview_.ghost) return true;
    const bool dots_to_come = dotted_ && !lead_gone_ && step_ < dotted_steps;
    return !on_lead_ && !on_target_ && !dots_to_come;
  }

 private:
  BallPath& lead_path() { return preview_.ghost ? preview_.lead_after : preview_.lead; }

  void follow(BallPath& path, std::size_t index) {
    path.push_back({world_.ball(index).position, step_});
  }

  void note(const carom::Event& event) {
    if (event.kind == EventKind::pair) {
      note_pair(event);
      return;
    }
    const bool gone = event.kind == EventKind::pocketed || event.kind == EventKind::destroyed ||
                      event.kind == EventKind::left;
    lost_ball_ |= gone;
    // A ball that lies on the floor or rolls along a wall meets it in every step.
    if (!gone && (event.kind == EventKind::damage || event.deviation == carom::Vec2{})) return;
    if (event.ball == lead_) {
      if (on_lead_) lead_path().push_back({event.position, step_, true});
      if (gone) {
        lead_gone_ = true;
        preview_.pocketed = on_lead_ && event.kind == EventKind::pocketed;
        on_lead_ = false;
      } else if (preview_.ghost) {
        on_lead_ &= length_ == PreviewLength::full;
      }
    } else if (on_target_ && event.ball == target_) {
      preview_.target.push_back({event.position, step_, true});
      on_target_ = !gone && length_ == PreviewLength::full;
    }
  }

  /// A game ends with its last red, or its last enemy.
  void note_what_is_left() {
    lost_ball_ = false;
    const bool cue = world_.ball(0).role == carom::Role::cue;
    game_over_ = true;
    for (std::size_t i = 1; i < world_.size(); ++i)
      game_over_ &= !cue && world_.ball(i).role != carom::Role::enemy;
  }

  void note_pair(const carom::Event& event) {
    if (event.deviation == carom::Vec2{}) return;  // they were parting
    const carom::Vec2 to_second = carom::unit(event.deviation);
    if (!preview_.ghost) {
      // The lead has index 0: of a pair it is the first.
      if (event.ball != lead_) return;
      const carom::Vec2 ghost = event.position - world_.ball(0).radius * to_second;
      preview_.lead.push_back({ghost, step_, true});
      preview_.ghost = ghost;
      if (length_ == PreviewLength::contact) {
        on_lead_ = false;
        return;
      }
      preview_.target_ball = target_ = event.other;
      on_target_ = true;
      preview_.lead_after.push_back({ghost, step_, true});
      preview_.target.push_back({event.position + radius_[target_] * to_second, step_, true});
      return;
    }
    const bool again = event.ball == lead_ && event.other == target_;
    const bool ends = length_ != PreviewLength::full && !again;
    if (on_lead_ && event.ball == lead_) {
      preview_.lead_after.push_back(
          {event.position - world_.ball(0).radius * to_second, step_, true});
      on_lead_ = !ends;
    }
    if (on_target_ && (event.ball == target_ || event.other == target_)) {
      const double side = event.ball == target_ ? -1 : 1;
      preview_.target.push_back(
          {event.position + side * radius_[target_] * to_second, step_, true});
      on_target_ = !ends;
    }
  }

  const carom::World& world_;
  Preview& preview_;
  PreviewLength length_;
  int brief_;
  std::uint32_t lead_;
  bool dotted_;
  int step_ = 0;
  bool on_lead_ = true;
  bool lead_gone_ = false;
  bool lost_ball_ = false;  ///< in this step
  bool game_over_ = false;
  bool on_target_ = false;
  std::uint32_t target_ = 0;
  std::vector<double> radius_;  ///< px, by id: a ball may be gone when its contact is noted
};

}  // namespace

Preview look_ahead(carom::World world, carom::Vec2 drag, PreviewLength length, int brief) {
  Preview preview;
  if (length == PreviewLength::off || !games::launch(world, drag)) return preview;
  Follower follower(world, length, brief, preview);
  do follower.note(world.step());
  while (!follower.done());
  return preview;
}

const Preview& Previewer::of(const carom::World& world, const Aim& aim, const AimSettings& settings,
                             bool practice) {
  PreviewLength length = settings.preview;
  const bool dots_only = world.scene().gravity > 0 && length != PreviewLength::full;
  if (length == PreviewLength::full && !practice) length = PreviewLength::brief;
  if (aim.too_weak()) length = PreviewLength::off;
  const Question asked{world.state_hash(), aim.drag(), length,
                       dots_only ? dotted_steps : brief_steps};
  if (answered_ == asked) return preview_;
  preview_ = look_ahead(world, asked.drag, length, asked.brief);
  answered_ = asked;
  ++made_;
  return preview_;
}

}  // namespace app

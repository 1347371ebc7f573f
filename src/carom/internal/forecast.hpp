#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "carom/balls.hpp"
#include "carom/internal/fixed_parts.hpp"
#include "carom/scene.hpp"

namespace carom {

/// Balls as bits, by index.
using BallMask = std::uint64_t;

inline BallMask bit(std::size_t i) { return BallMask{1} << i; }

/// Calls visit(i) for the balls of a mask by ascending index; visit may change the mask.
template <class Visit>
void for_each_ball(BallMask balls, Visit visit) {
  for (; balls != 0; balls &= balls - 1) visit(static_cast<std::size_t>(std::countr_zero(balls)));
}

/// Knows for each ball of a world until when it surely meets nothing: no ball, edge, hole or
/// obstacle, and nothing that it lies on changes. As long as this is true of all, a step is stage 1
/// alone; in the other steps only the balls that are due need the other stages. It errs on the safe
/// side only: a ball that is due too early costs time (docs/physics.md proves the margin).
///
/// Each ball has one time, on the clock of a TimeScale. A pair is covered by whichever of its balls
/// was predicted last, so only balls whose motion changed are predicted again.
///
/// After stage 7 a ball is
/// - asleep: it stands, and no acceleration acts on it. Nothing it depends on moves, so its next
///   step is as the last;
/// - free: it moves, accelerated by gravity alone (if there is any);
/// - rolling: under gravity, it moves without acceleration, on the floor;
/// - hot: anything else, as a ball that a hole pulls. It is due in every step.
class Forecast {
 public:
  static constexpr std::size_t max_balls = 64;
  static constexpr std::size_t max_fixtures = RoundedHoles::most;  ///< holes, and obstacles, each

  /// True if worlds like this are forecast at all.
  static bool suits(const Scene& scene, std::size_t balls) {
    return balls <= max_balls && scene.holes.size() <= max_fixtures &&
           scene.obstacles.size() <= max_fixtures;
  }

  bool begun() const { return begun_; }
  /// The state has been changed by other means than steps.
  void forget() { begun_ = false, pause_left_ = 0; }

  /// True if one can begin in any state; else only after a whole step.
  static bool begins_anywhere(const FixedParts& fixed) { return fixed.scale.straight; }
  /// Begins, unless that does not pay or the margins do not hold. `events`: whether the whole step
  /// had any.
  void begin(const FixedParts& fixed, const Balls& balls, bool lead_out, bool events);

  /// The number of the next steps, at most `most`, that are surely stage 1 alone, and whether the
  /// one after these is known to be another one. None also when the forecast has just ended.
  struct Ahead {
    int quiet = 0;
    bool due = false;
    bool whole = false;  ///< the due one has one part, and its stage 1 is as in a quiet step
  };
  Ahead look_ahead(const FixedParts& fixed, const Balls& balls, std::uint64_t most);
  /// Stage 1 of so many steps, the whole due one after the quiet ones included.
  void advance(const FixedParts& fixed, Balls& balls, int steps) const;
  /// So many quiet steps have been taken.
  void pass(int steps);

  /// Takes the next step if it is known already that it is quiet.
  bool pass_quiet_step(const FixedParts& fixed, Balls& balls);

  /// A step that is not quiet: the number of its parts; then, for each part, stage 1, then the
  /// balls that are due in it; then, after its other stages, `settle`.
  int parts(const FixedParts& fixed, const Balls& balls);
  void move(const FixedParts& fixed, Balls& balls, double part, double friction) const;
  struct Due {
    BallMask balls = 0;  ///< those that are due
    BallMask pairs = 0;  ///< those of them that may meet another ball,
    BallMask holes = 0;  ///< and a hole
  };
  Due due(const FixedParts& fixed, const Balls& balls, int part, int parts);
  /// Predicts the active balls anew. `struck`: those of them that may have another speed than
  /// stage 1 gave them. `unsettled`: those that stages 2 to 6 have put elsewhere; all, if a ball
  /// went out of play.
  void settle(const FixedParts& fixed, const Balls& balls, BallMask struck, BallMask unsettled);
  /// The end of that step, after `part` of its parts.
  void end_step(const FixedParts& fixed, Balls& balls, int part, int parts);

  /// The balls whose stages 3 to 6 have been computed in this part.
  BallMask active() const { return active_; }
  void set_active(BallMask active) { active_ = active; }

  /// Balls::swap_out was called.
  void swap_out(std::size_t i);
  void lead_went_out();

  /// Before so many steps the world is surely not at rest; ≥ 1.
  std::uint64_t steps_until_rest() const {
    return may_rest() ? 1 : static_cast<std::uint64_t>(busy_until_ - step_);
  }
  /// Whether, for all that is known, the world may be at rest now.
  bool may_rest() const { return step_ >= busy_until_; }
  /// True if it is known that it is not.
  bool surely_busy() const { return begun_ && !may_rest(); }
  /// True if it is surely not; finds out until when.
  bool is_busy(const FixedParts& fixed, const Balls& balls);

  // For the search of what is near, in floats: an answer may hold more than it should.

  /// All positions and velocities again.
  void pack(const Balls& balls);
  /// Those of one.
  void pack(const Balls& balls, std::size_t i) {
    x_[i] = static_cast<float>(balls.x[i]);
    y_[i] = static_cast<float>(balls.y[i]);
    vx_[i] = static_cast<float>(balls.vx[i]);
    vy_[i] = static_cast<float>(balls.vy[i]);
  }
  /// The others in play that may touch ball i.
  BallMask near(std::size_t i) const;

 private:
  static constexpr double never = std::numeric_limits<double>::infinity();
  static constexpr double always = -1;  ///< the clock starts at 0
  /// Bounds are computed with some roundings; this is far more than these, as a share.
  static constexpr double hair = 1e-9;
  static constexpr std::size_t lanes = 8;  ///< that a kernel may read behind the last ball
  static constexpr std::size_t padded = max_balls + lanes;
  using Floats = std::array<float, padded>;

  void classify(const FixedParts& fixed, const Balls& balls, std::size_t i);
  static bool inside(const FixedParts& fixed, const Balls& balls, std::size_t i);
  bool stands_clear(const FixedParts& fixed, const Balls& balls, std::size_t i) const;
  void note_place(const FixedParts& fixed, const Balls& balls, std::size_t i);
  void note_speed(const FixedParts& fixed, const Balls& balls, std::size_t i);
  void widen(double extent);
  void give_up();
  void predict(const FixedParts& fixed, const Balls& balls, std::size_t i);
  void straight(const FixedParts& fixed, const Balls& balls, std::size_t i);
  double bounded(const FixedParts& fixed, const Balls& balls, std::size_t i) const;
  void set_due(std::size_t i, double pairs, double holes, double edges) {
    pairs_due_[i] = pairs;
    holes_due_[i] = holes;
    due_[i] = std::min({pairs, holes, edges});
  }
  void blank(std::size_t i);
  void wake(BallMask moving);
  void begin_clock(const FixedParts& fixed, const Balls& balls);
  void choose_parts(const FixedParts& fixed, const Balls& balls);
  int one_part_until(const FixedParts& fixed, const Balls& balls, std::size_t i) const;

  bool begun_ = false;
  bool fails_ =
      false;  ///< the margins do not hold; ends with the step, whose parts belong together
  std::size_t size_ = 0;
  BallMask in_play_ = 0;
  BallMask moving_ = 0;  ///< free, rolling or hot
  BallMask hot_ = 0;
  BallMask held_ = 0;  ///< under gravity: asleep or rolling, so stage 1's fall is taken back
  BallMask active_ = 0;
  int step_ = 0;             ///< since the clock began
  int quiet_until_ = 0;      ///< step up to which nothing is due; below step_: not known
  int parts_ = 1;            ///< of the next steps,
  int parts_until_ = 0;      ///< up to this one
  int busy_until_ = 0;       ///< before this step the world is surely not at rest,
  std::size_t witness_ = 0;  ///< because of this ball
  double now_ = 0;           ///< on the clock
  double unit_ = 1;
  double extent_ = 0;  ///< px, no ball gets further from the origin until the clock begins anew
  double margin_ = 0;  ///< px, more than all rounding in a prediction
  float slack_ = 0;    ///< px, more than rounding to floats, and margin_
  double least_radius_ = 0;
  double balance_ = 0;  ///< what has been saved, as the cost of one ball in one whole step
  static constexpr int shortest_pause = 32;
  int pause_ = shortest_pause;  ///< steps, if it does not pay
  int pause_left_ = 0;
  // On the clock: until when the ball meets nothing; no ball; no hole.
  std::array<double, padded> due_{}, pairs_due_{}, holes_due_{};
  // Rounded, for choosing. Places behind the last ball are far away.
  Floats x_{}, y_{}, vx_{}, vy_{}, radius_{};
};

}  // namespace carom

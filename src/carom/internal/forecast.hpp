#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

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
  static constexpr std::size_t max_fixtures = 32;  ///< holes, and obstacles, each

  /// Whether worlds like this are forecast at all.
  static bool suits(const Scene& scene, std::size_t balls) {
    return balls <= max_balls && scene.holes.size() <= max_fixtures &&
           scene.obstacles.size() <= max_fixtures;
  }

  bool begun() const { return begun_; }
  /// The state has been changed by other means than steps.
  void forget() { begun_ = false, pause_left_ = 0; }

  /// Begins after a whole step, unless that does not pay or the margins do not hold. `events`:
  /// whether the step had any.
  void begin(const FixedParts& fixed, const Balls& balls, bool lead_out, bool events);

  /// Takes as many of the next steps, at most `most`, as are surely stage 1 alone, and returns
  /// their number; 0 also when the forecast has just ended.
  std::uint64_t pass_quiet_steps(const FixedParts& fixed, Balls& balls, std::uint64_t most);

  /// Takes the next step if it is known already that it is one of these.
  bool pass_quiet_step(const FixedParts& fixed, Balls& balls);

  /// A step that is not quiet: the number of its parts; then, for each part, after stage 1, the
  /// balls that are due in it; then, after its other stages, `settle`.
  int parts(const FixedParts& fixed, const Balls& balls);
  /// Stage 1 of a part, if it is as in a quiet step; otherwise does nothing and returns false.
  bool move(const FixedParts& fixed, Balls& balls, double part, double friction) const;
  BallMask due(const FixedParts& fixed, int part, int parts);
  /// Predicts the active balls anew. `unsettled`: those of them that stages 2 to 6 have put
  /// elsewhere; all, if a ball went out of play.
  void settle(const FixedParts& fixed, Balls& balls, BallMask unsettled);
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
  /// Whether it is surely not; finds out until when.
  bool is_busy(const FixedParts& fixed, const Balls& balls);

  // For the search of what is near, in floats: an answer may hold more than it should.

  /// All positions again.
  void pack(const Balls& balls);
  /// The position of one.
  void pack(const Balls& balls, std::size_t i) {
    x_[i] = static_cast<float>(balls.x[i]);
    y_[i] = static_cast<float>(balls.y[i]);
  }
  /// The others in play that may touch ball i.
  BallMask near(std::size_t i) const;

 private:
  static constexpr std::size_t lanes = 8;  ///< that a kernel may read behind the last ball
  static constexpr std::size_t padded = max_balls + lanes;
  using Floats = std::array<float, padded>;

  void classify(const FixedParts& fixed, const Balls& balls, std::size_t i);
  void note(const FixedParts& fixed, const Balls& balls, std::size_t i);
  void widen(double extent);
  void give_up();
  void predict(const FixedParts& fixed, const Balls& balls, std::size_t i);
  double straight(const FixedParts& fixed, const Balls& balls, std::size_t i) const;
  double bounded(const FixedParts& fixed, const Balls& balls, std::size_t i) const;
  void earn(int steps);
  void blank(std::size_t i);
  void wake(BallMask moving);
  int quiet_steps(const FixedParts& fixed, const Balls& balls, int most);
  void advance(const FixedParts& fixed, Balls& balls, int steps);
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
  int pause_ = 64;      ///< steps, if it does not pay
  int pause_left_ = 0;
  std::array<double, padded> due_{};  ///< on the clock
  // Rounded, for choosing. Places behind the last ball are far away.
  Floats x_{}, y_{}, vx_{}, vy_{}, radius_{};
  Floats hole_x_{}, hole_y_{}, hole_radius_{};
};

}  // namespace carom

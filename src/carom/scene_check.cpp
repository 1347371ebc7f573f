#include "carom/internal/scene_check.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string_view>
#include <utf8cpp/utf8/core.h>
#include <utility>

#include "carom/arithmetic.hpp"
#include "carom/internal/arithmetic_check.hpp"
#include "carom/internal/quadtree_search.hpp"
#include "carom/internal/scene_fields.hpp"
#include "json/number_text.hpp"

namespace carom {

namespace {

// For people: whole numbers are written out (100000, not 1e+05).
std::string number_text(double number) {
  if (std::isnan(number)) return "NaN";
  if (std::isinf(number)) return number > 0 ? "infinite" : "infinite (negative)";
  std::string text;
  if (std::abs(number) < 1e15 && std::trunc(number) == number)
    append_number(text, static_cast<long long>(number));
  else
    append_number(text, number);
  return text;
}

// Stage 5's test of a step (docs/physics.md#one-step).
bool overlaps(const Obstacle& obstacle, Vec2 position, double radius) {
  const double reach = obstacle.radius + radius;
  return position.y < obstacle.height
             ? std::abs(position.x - obstacle.x) < reach
             : length(position - Vec2{obstacle.x, obstacle.height}) < reach;
}

std::optional<Error> edge_error(const Scene& fixed, Vec2 position, double radius,
                                std::string pointer) {
  using enum MessageCode;
  struct Side {
    Edge edge;
    bool sticks_out;
    MessageCode problem;
    MessageCode expected;
    double limit;
  };
  const auto& [x, y] = position;
  const auto& [width, height] = Vec2{fixed.width, fixed.height};
  const Side sides[] = {
      {fixed.edges.left, x - radius < 0, sticks_out_left, x_at_least, radius},
      {fixed.edges.right, x + radius > width, sticks_out_right, x_at_most, width - radius},
      {fixed.edges.bottom, y - radius < 0, sticks_out_bottom, y_at_least, radius},
      {fixed.edges.top, y + radius > height, sticks_out_top, y_at_most, height - radius},
  };
  for (const Side& side : sides)
    if (side.edge == Edge::solid && side.sticks_out)
      return Error{.pointer = std::move(pointer),
                   .problem = side.problem,
                   .expected = {side.expected, {number_text(side.limit)}}};
  return std::nullopt;
}

Error obstacle_error(const Scene& fixed, std::size_t n, std::string pointer) {
  const Obstacle& obstacle = fixed.obstacles[n];
  return {.pointer = std::move(pointer),
          .problem = {MessageCode::overlaps_obstacle,
                      {std::to_string(n), number_text(obstacle.x), number_text(obstacle.height),
                       number_text(obstacle.radius)}},
          .expected = MessageCode::place_outside_obstacles};
}

// The overlaps of balls in a scene whose numbers are sound, by the quadtree.
class Neighbours {
 public:
  Neighbours(const Scene& scene, std::vector<std::uint32_t> balls)
      : scene_(scene), index_(std::move(balls)) {
    build();
  }

  /// True if more than `most` pairs of balls overlap. Stops when it knows.
  bool more_pairs_than(std::size_t most) {
    if (x_.size() * (x_.size() - 1) / 2 <= most) return false;
    std::size_t pairs = 0;
    const QuadtreeSearch search(tree_);
    for (std::size_t i = 0; i < x_.size() && pairs <= most; ++i) {
      found_.clear();
      search.near(x_[i], y_[i], radius_[i], 1, [&](std::uint32_t k) {
        const double sum = radius_[i] + radius_[k];
        if (k < i && length_squared(Vec2{x_[k] - x_[i], y_[k] - y_[i]}) < sum * sum)
          found_.push_back(k);
      });
      std::sort(found_.begin(), found_.end());
      pairs += static_cast<std::size_t>(std::unique(found_.begin(), found_.end()) - found_.begin());
    }
    return pairs > most;
  }

  /// True if more than `most` pairs of a hole and a ball's centre in it. Stops when it knows.
  bool more_in_holes_than(std::size_t most) {
    if (x_.size() * scene_.holes.size() <= most) return false;
    std::size_t pairs = 0;
    for (const Hole& hole : scene_.holes) {
      const Vec2 reach{hole.radius, hole.radius};
      tree_.query_box(hole.position - reach, hole.position + reach, found_);
      for (const std::uint32_t i : found_)
        if (length(Vec2{x_[i], y_[i]} - hole.position) < hole.radius) ++pairs;
      if (pairs > most) return true;
    }
    return false;
  }

  /// By ball of the scene the first obstacle that it overlaps, or the number of obstacles.
  std::vector<std::uint32_t> first_obstacles() {
    const auto none = static_cast<std::uint32_t>(scene_.obstacles.size());
    std::vector<std::uint32_t> first(scene_.balls.size(), none);
    // Balls that lie in a wall already are met again and again: those are left out now and then.
    std::size_t in_vain = 0;
    for (std::uint32_t n = 0; n < none && !index_.empty(); ++n) {
      const Obstacle& obstacle = scene_.obstacles[n];
      if (obstacle.height + obstacle.radius < lowest_) continue;
      tree_.query_box({obstacle.x - obstacle.radius, lowest_},
                      {obstacle.x + obstacle.radius, obstacle.height + obstacle.radius}, found_);
      for (const std::uint32_t i : found_) {
        std::uint32_t& known = first[index_[i]];
        if (known != none)
          ++in_vain;
        else if (overlaps(obstacle, {x_[i], y_[i]}, radius_[i]))
          known = n;
      }
      if (in_vain <= index_.size()) continue;
      in_vain = 0;
      std::erase_if(index_, [&](std::uint32_t ball) { return first[ball] != none; });
      build();
    }
    return first;
  }

 private:
  void build() {
    x_.resize(index_.size());
    y_.resize(index_.size());
    radius_.resize(index_.size());
    for (std::size_t i = 0; i < index_.size(); ++i) {
      const Ball& ball = scene_.balls[index_[i]];
      x_[i] = ball.position.x;
      y_[i] = ball.position.y;
      radius_[i] = ball.radius;
    }
    lowest_ = max_quantity;
    for (std::size_t i = 0; i < y_.size(); ++i) lowest_ = std::min(lowest_, y_[i] - radius_[i]);
    tree_ = {};
    tree_.build(x_, y_, radius_);
  }

  const Scene& scene_;
  std::vector<std::uint32_t> index_;  // in the scene, of each ball here
  std::vector<double> x_, y_, radius_;
  double lowest_ = 0;  // px, no ball reaches further down
  Quadtree tree_;
  std::vector<std::uint32_t> found_;
};

class Checker {
 public:
  Checker(const Scene& scene, const std::function<void(Error)>& report)
      : scene_(scene), report_([this, &report](Error error) {
          sound_ = false;
          report(std::move(error));
        }) {}

  void run() {
    if (!arithmetic_is_exact() || !step_arithmetic_is_exact())
      report_({.problem = MessageCode::is_inexact, .expected = MessageCode::exact_arithmetic});
    check_texts();
    numbers(scene_fields, scene_, [] { return std::string(); });
    fixed_is_sound_ = contains(size_range, scene_.width) && contains(size_range, scene_.height);
    if (scene_.throws < 1 || scene_.throws > max_throws)
      report_({.pointer = "/throws",
               .problem = is(scene_.throws),
               .expected = expectation(scene_fields[index_of(scene_fields, "throws")])});
    each("/holes", scene_.holes, max_fixtures, [&](const Hole& hole, auto pointer) {
      if (!numbers(hole_fields, hole, pointer)) fixed_is_sound_ = false;
    });
    each("/obstacles", scene_.obstacles, max_fixtures, [&](const Obstacle& obstacle, auto pointer) {
      if (!numbers(obstacle_fields, obstacle, pointer)) fixed_is_sound_ = false;
    });
    if (scene_.balls.size() <= max_balls && scene_.obstacles.size() <= max_fixtures &&
        scene_.holes.size() <= max_fixtures)
      find_obstacles();
    each("/balls", scene_.balls, max_balls,
         [&](const Ball& ball, auto pointer) { check_ball(ball, pointer); });
    if (!sound_) return;
    for (Error& error : heap_errors(scene_, max_overlaps(scene_.balls.size())))
      report_(std::move(error));
  }

 private:
  static Message is(double number) { return {MessageCode::is, {number_text(number)}}; }

  // Of balls and obstacles whose numbers are sound.
  void find_obstacles() {
    if (!fixed_is_sound_ || scene_.obstacles.empty()) return;
    std::vector<std::uint32_t> balls;
    for (const Ball& ball : scene_.balls)
      if (is_sound(ball)) balls.push_back(static_cast<std::uint32_t>(&ball - scene_.balls.data()));
    if (!balls.empty()) first_obstacles_ = Neighbours(scene_, std::move(balls)).first_obstacles();
  }

  static bool is_sound(const Ball& ball) {
    return std::all_of(std::begin(ball_fields), std::end(ball_fields), [&](const auto& field) {
      return !field.number || contains(field.range, field.value(ball));
    });
  }

  void check_texts() {
    for (const auto& field : scene_fields) {
      if (!field.text) continue;
      const std::string& text = scene_.*field.text;
      const std::string pointer = "/" + std::string(field.name);
      if (text.size() > field.most_bytes)
        report_({.pointer = pointer,
                 .problem = {MessageCode::is_bytes_long, {std::to_string(text.size())}},
                 .expected = expectation(field)});
      else if (!utf8::is_valid(text.begin(), text.end()))
        report_({.pointer = pointer,
                 .problem = MessageCode::is_not_utf8,
                 .expected = expectation(field)});
    }
  }

  // Calls check_one(element, pointer); `pointer` makes the element's pointer, which only errors
  // need.
  template <class T, class F>
  void each(const std::string& list, const std::vector<T>& elements, std::size_t most,
            F check_one) {
    if (elements.size() > most) {
      report_({.pointer = list,
               .problem = {MessageCode::has_elements, {std::to_string(elements.size())}},
               .expected = {MessageCode::at_most, {std::to_string(most)}}});
      return;
    }
    for (const T& element : elements)
      check_one(element, [&] { return list + "/" + std::to_string(&element - elements.data()); });
  }

  // True if all numbers of an object are in their ranges.
  template <class T, std::size_t count, class F>
  bool numbers(const Field<T> (&fields)[count], const T& object, F pointer) {
    bool sound = true;
    for (const Field<T>& field : fields) {
      if (!field.number || contains(field.range, field.value(object))) continue;
      report_({.pointer = pointer() + "/" + std::string(field.name),
               .problem = is(field.value(object)),
               .expected = expectation(field)});
      sound = false;
    }
    return sound;
  }

  template <class F>
  void check_ball(const Ball& ball, F pointer) {
    check_role(ball, pointer);
    if (!numbers(ball_fields, ball, pointer)) return;
    const double speed = length(ball.velocity);
    if (speed > max_speed)
      report_({.pointer = pointer(),
               .problem = {MessageCode::moves_at, {number_text(speed)}},
               .expected = {MessageCode::at_most_speed, {number_text(max_speed)}}});
    if (!fixed_is_sound_) return;
    const auto index = static_cast<std::size_t>(&ball - scene_.balls.data());
    if (auto error = edge_error(scene_, ball.position, ball.radius, {})) {
      error->pointer = pointer();
      report_(*std::move(error));
    } else if (!first_obstacles_.empty() && first_obstacles_[index] < scene_.obstacles.size()) {
      report_(obstacle_error(scene_, first_obstacles_[index], pointer()));
    }
  }

  template <class F>
  void check_role(const Ball& ball, F pointer) {
    const Ball& first = scene_.balls.front();
    if (!is_lead(ball.role) || &ball == &first) return;
    const auto quoted = [](Role role) {
      return '"' + std::string(role_names[static_cast<std::size_t>(role)]) + '"';
    };
    report_({.pointer = pointer() + "/role",
             .problem = is_lead(first.role) ? Message(MessageCode::is_second_lead,
                                                      {quoted(ball.role), quoted(first.role)})
                                            : Message(MessageCode::is, {quoted(ball.role)}),
             .expected = MessageCode::one_lead_first});
  }

  const Scene& scene_;
  const std::function<void(Error)> report_;
  bool sound_ = true;           // nothing was reported
  bool fixed_is_sound_ = true;  // whether it makes sense to say what a ball overlaps
  std::vector<std::uint32_t> first_obstacles_;  // by ball; empty if there are no obstacles
};

}  // namespace

bool contains(const Range& range, double number) {
  const bool low_enough =
      range.low_is == Range::Low::included ? number >= range.low : number > range.low;
  return low_enough && number <= range.high;
}

Message expectation(const Range& range) {
  using enum MessageCode;
  const std::string low = number_text(range.low);
  const std::string high = number_text(range.high);
  const std::string note = range.note.empty() ? "" : " (" + std::string(range.note) + ")";
  const bool above = range.low_is == Range::Low::excluded;
  if (range.high < std::numeric_limits<double>::max())
    return {above ? number_above_to : number_from_to, {low, high, note}};
  return {above ? number_above : number_from, {low, note}};
}

std::optional<Error> obstruction_error(const Scene& fixed, Vec2 position, double radius,
                                       std::string pointer) {
  if (auto error = edge_error(fixed, position, radius, pointer)) return error;
  for (std::size_t n = 0; n < fixed.obstacles.size(); ++n)
    if (overlaps(fixed.obstacles[n], position, radius))
      return obstacle_error(fixed, n, std::move(pointer));
  return std::nullopt;
}

Errors heap_errors(const Scene& scene, std::size_t most) {
  Errors errors;
  const std::size_t n = scene.balls.size();
  if (n == 0 || (n * (n - 1) / 2 <= most && n * scene.holes.size() <= most)) return errors;
  std::vector<std::uint32_t> balls(n);
  std::iota(balls.begin(), balls.end(), 0U);
  Neighbours neighbours(scene, std::move(balls));
  const auto report = [&](MessageCode problem) {
    errors.push_back({.pointer = "/balls",
                      .problem = {problem, {std::to_string(most)}},
                      .expected = MessageCode::at_most_pairs});
  };
  if (neighbours.more_pairs_than(most)) report(MessageCode::has_overlapping_pairs);
  if (neighbours.more_in_holes_than(most)) report(MessageCode::has_balls_in_holes);
  return errors;
}

void check(const Scene& scene, const std::function<void(Error)>& report) {
  const ExactArithmetic exact;
  Checker(scene, report).run();
}

Error more_errors(std::size_t count) {
  if (count == 1) return {.problem = MessageCode::one_more_error};
  return {.problem = {MessageCode::more_errors, {std::to_string(count)}}};
}

Errors check(const Scene& scene) {
  Errors errors;
  std::size_t more = 0;
  check(scene, [&](Error error) {
    if (errors.size() < max_errors)
      errors.push_back(std::move(error));
    else
      ++more;
  });
  if (more > 0) errors.push_back(more_errors(more));
  return errors;
}

}  // namespace carom

#include "carom/internal/scene_check.hpp"

#include <cmath>
#include <string_view>
#include <utf8cpp/utf8/core.h>
#include <utility>

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

class Checker {
 public:
  Checker(const Scene& scene, const std::function<void(Error)>& report)
      : scene_(scene), report_(report) {}

  void run() {
    check_name();
    numbers(scene_fields, scene_, [] { return std::string(); });
    fixed_is_sound_ = contains(size_range, scene_.width) && contains(size_range, scene_.height);
    if (scene_.throws < 1 || scene_.throws > max_throws)
      report_({.pointer = "/throws",
               .problem = is(scene_.throws),
               .expected = expectation(scene_fields[index_of(scene_fields, "throws")])});
    each("/holes", scene_.holes, max_fixtures,
         [&](const Hole& hole, auto pointer) { numbers(hole_fields, hole, pointer); });
    each("/obstacles", scene_.obstacles, max_fixtures, [&](const Obstacle& obstacle, auto pointer) {
      if (!numbers(obstacle_fields, obstacle, pointer)) fixed_is_sound_ = false;
    });
    each("/balls", scene_.balls, max_balls,
         [&](const Ball& ball, auto pointer) { check_ball(ball, pointer); });
  }

 private:
  static std::string is(double number) { return "is " + number_text(number); }

  void check_name() {
    const auto& field = scene_fields[index_of(scene_fields, "name")];
    const std::size_t bytes = scene_.name.size();
    if (bytes > max_name_bytes)
      report_({.pointer = "/name",
               .problem = "is " + std::to_string(bytes) + " bytes long",
               .expected = expectation(field)});
    else if (!utf8::is_valid(scene_.name.begin(), scene_.name.end()))
      report_({.pointer = "/name", .problem = "is not in UTF-8", .expected = expectation(field)});
  }

  // Calls check_one(element, pointer); `pointer` makes the element's pointer, which only errors
  // need.
  template <class T, class F>
  void each(const std::string& list, const std::vector<T>& elements, std::size_t most,
            F check_one) {
    if (elements.size() > most) {
      report_({.pointer = list,
               .problem = "has " + std::to_string(elements.size()) + " elements",
               .expected = "at most " + std::to_string(most)});
      return;
    }
    for (const T& element : elements)
      check_one(element, [&] { return list + "/" + std::to_string(&element - elements.data()); });
  }

  // Whether all numbers of an object are in their ranges.
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
               .problem = "moves at " + number_text(speed) + " px/s",
               .expected = "at most " + number_text(max_speed) + " (px/s)"});
    if (!fixed_is_sound_) return;
    if (auto error = obstruction_error(scene_, ball.position, ball.radius, {})) {
      error->pointer = pointer();
      report_(*std::move(error));
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
             .problem =
                 "is " + quoted(ball.role) +
                 (is_lead(first.role) ? ", but ball 0 is " + quoted(first.role) + " already" : ""),
             .expected = "at most one cue ball or projectile, and that as the first ball"});
  }

  const Scene& scene_;
  const std::function<void(Error)>& report_;
  bool fixed_is_sound_ = true;  // whether it makes sense to say what a ball overlaps
};

}  // namespace

bool contains(const Range& range, double number) {
  const bool low_enough =
      range.low_is == Range::Low::included ? number >= range.low : number > range.low;
  return low_enough && number <= range.high;
}

std::string expectation(const Range& range) {
  const std::string low = number_text(range.low);
  const std::string high = number_text(range.high);
  const bool bounded = range.high < std::numeric_limits<double>::max();
  std::string text = "a number ";
  if (range.low_is == Range::Low::excluded)
    text += "greater than " + low + (bounded ? " and at most " + high : "");
  else
    text += bounded ? "from " + low + " to " + high : "of at least " + low;
  if (!range.note.empty()) text += " (" + std::string(range.note) + ")";
  return text;
}

std::optional<Error> obstruction_error(const Scene& fixed, Vec2 position, double radius,
                                       std::string pointer) {
  struct Side {
    Edge edge;
    bool sticks_out;
    const char* name;
    const char* expected;
    double limit;
  };
  const auto& [x, y] = position;
  const Side sides[] = {
      {fixed.edges.left, x - radius < 0, "left", "x of at least ", radius},
      {fixed.edges.right, x + radius > fixed.width, "right", "x of at most ", fixed.width - radius},
      {fixed.edges.bottom, y - radius < 0, "bottom", "y of at least ", radius},
      {fixed.edges.top, y + radius > fixed.height, "top", "y of at most ", fixed.height - radius},
  };
  for (const Side& side : sides)
    if (side.edge == Edge::solid && side.sticks_out)
      return Error{.pointer = std::move(pointer),
                   .problem = "sticks out of the solid " + std::string(side.name) + " edge",
                   .expected = side.expected + number_text(side.limit) + " (px)"};

  // The same test as the obstacles' in a step (spec §2, stage 5).
  for (const Obstacle& obstacle : fixed.obstacles) {
    const double reach = obstacle.radius + radius;
    const bool overlaps = y < obstacle.height
                              ? std::abs(x - obstacle.x) < reach
                              : length(position - Vec2{obstacle.x, obstacle.height}) < reach;
    if (overlaps)
      return Error{.pointer = std::move(pointer),
                   .problem = "overlaps obstacle " +
                              std::to_string(&obstacle - fixed.obstacles.data()) + " (x " +
                              number_text(obstacle.x) + ", height " + number_text(obstacle.height) +
                              ", radius " + number_text(obstacle.radius) + ")",
                   .expected = "a place outside of every obstacle"};
  }
  return std::nullopt;
}

void check(const Scene& scene, const std::function<void(Error)>& report) {
  Checker(scene, report).run();
}

Error more_errors(std::size_t count) {
  return {.problem =
              "and " + std::to_string(count) + (count == 1 ? " more error" : " more errors")};
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

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "carom/arithmetic.hpp"
#include "carom/internal/fixed_parts.hpp"
#include "carom/internal/workspace.hpp"
#include "carom/world.hpp"

namespace carom {

namespace {

constexpr double unmet = std::numeric_limits<double>::infinity();

/// A disc that moves along a straight line; `along` is a unit vector.
struct Sweep {
  Vec2 from;
  Vec2 along;
  double radius;

  Vec2 at(double distance) const { return from + distance * along; }
};

// The distance until it touches another disc. A disc that it overlaps already is not met.
double distance_to(const Sweep& sweep, Vec2 centre, double radius) {
  const double reach = sweep.radius + radius;
  const Vec2 w = sweep.from - centre;
  const double b = dot(w, sweep.along);
  const double c = length_squared(w) - reach * reach;
  if (b >= 0 || c < 0) return unmet;
  const double discriminant = b * b - c;
  return discriminant < 0 ? unmet : c / (std::sqrt(discriminant) - b);
}

// A wall goes down for ever, as in a step's stage 5; its top is a disc.
double distance_to(const Sweep& sweep, const Obstacle& obstacle) {
  const double reach = sweep.radius + obstacle.radius;
  const bool inside = sweep.from.y < obstacle.height
                          ? std::abs(sweep.from.x - obstacle.x) < reach
                          : length(sweep.from - Vec2{obstacle.x, obstacle.height}) < reach;
  if (inside) return unmet;
  double least = unmet;
  const double side = sweep.along.x > 0 ? obstacle.x - reach : obstacle.x + reach;
  if (sweep.along.x != 0) {
    const double wall = (side - sweep.from.x) / sweep.along.x;
    if (wall >= 0 && sweep.at(wall).y < obstacle.height) least = wall;
  }
  const double cap = distance_to(sweep, {obstacle.x, obstacle.height}, obstacle.radius);
  if (cap < least && sweep.at(cap).y >= obstacle.height) least = cap;
  return least;
}

double distance_to(const Sweep& sweep, const Scene& scene, Side side) {
  const bool upright = side == Side::left || side == Side::right;
  const bool low = side == Side::left || side == Side::bottom;
  const double from = upright ? sweep.from.x : sweep.from.y;
  const double along = upright ? sweep.along.x : sweep.along.y;
  if (low ? along >= 0 : along <= 0) return unmet;
  const double end = low ? sweep.radius : (upright ? scene.width : scene.height) - sweep.radius;
  return std::max((end - from) / along, 0.0);
}

// The part of the way, if any, on which the sweep may reach into the box.
std::pair<double, double> part_within(const Sweep& sweep, Box box) {
  double begin = 0;
  double end = unmet;
  const auto cut = [&](double from, double along, double low, double high) {
    low -= sweep.radius;
    high += sweep.radius;
    if (along == 0) {
      if (from < low || from > high) end = -1;
      return;
    }
    const double a = (low - from) / along;
    const double b = (high - from) / along;
    begin = std::max(begin, std::min(a, b));
    end = std::min(end, std::max(a, b));
  };
  cut(sweep.from.x, sweep.along.x, box.low.x, box.high.x);
  cut(sweep.from.y, sweep.along.y, box.low.y, box.high.y);
  return {begin, end};
}

bool within(Vec2 place, double most) {
  return std::abs(place.x) <= most && std::abs(place.y) <= most;
}

Error too_far(std::string pointer) {
  return {.pointer = std::move(pointer),
          .problem = MessageCode::is_too_far,
          .expected = {MessageCode::coordinates_from_to, {"-1000000000", "1000000000"}}};
}

std::optional<Error> radius_error(double radius) {
  if (radius >= 0 && radius <= max_quantity) return std::nullopt;
  return Error{.pointer = "radius",
               .problem = {MessageCode::text, {"is negative, not finite or too large"}},
               .expected = {MessageCode::number_from_to, {"0", "1000000000", " (px)"}}};
}

}  // namespace

std::optional<std::size_t> World::index_of(std::uint32_t id) const {
  const auto at = std::find(balls_.id.begin(), balls_.id.end(), id);
  if (at == balls_.id.end()) return std::nullopt;
  const auto index = static_cast<std::size_t>(at - balls_.id.begin());
  return in_play(index) ? std::optional(index) : std::nullopt;
}

std::vector<std::uint32_t> World::in_play_only(std::vector<std::uint32_t> found) const {
  // Ascending, so the lead is the first.
  if (lead_out_ && !found.empty() && found.front() == 0) found.erase(found.begin());
  return found;
}

Result<std::vector<std::uint32_t>> World::balls_in(Disc disc) {
  const ExactArithmetic exact;
  if (!within(disc.centre, max_quantity)) return too_far("centre");
  if (auto error = radius_error(disc.radius)) return *error;
  std::vector<std::uint32_t> found;
  workspace().places.of(balls_, steps_).query_disc(disc.centre, disc.radius, found);
  return in_play_only(std::move(found));
}

Result<std::vector<std::uint32_t>> World::balls_in(Box box) {
  const ExactArithmetic exact;
  if (!(box.low.x <= box.high.x && box.low.y <= box.high.y))
    return Error{.pointer = "box",
                 .problem = {MessageCode::text, {"has corners that are not in order"}},
                 .expected = {MessageCode::text, {"low left of and below high"}}};
  std::vector<std::uint32_t> found;
  workspace().places.of(balls_, steps_).query_box(box.low, box.high, found);
  return in_play_only(std::move(found));
}

Result<std::optional<Contact>> World::first_contact(Vec2 from, Vec2 direction, double radius) {
  const ExactArithmetic exact;
  if (!within(from, max_quantity)) return too_far("from");
  if (auto error = radius_error(radius)) return *error;
  const double largest = std::max(std::abs(direction.x), std::abs(direction.y));
  if (!(largest > 0) || !std::isfinite(direction.x) || !std::isfinite(direction.y))
    return Error{.pointer = "direction",
                 .problem = {MessageCode::text, {"is zero or not finite"}},
                 .expected = MessageCode::finite_drag};
  // In two steps, so that no square is too large or too small.
  const Sweep sweep{from, unit({direction.x / largest, direction.y / largest}), radius};

  std::optional<Contact> first;
  double least = unmet;
  const auto meet = [&](Contact::With with, std::size_t index, double distance) {
    if (distance >= least) return;
    least = distance;
    first = Contact{with, index, distance, sweep.at(distance)};
  };
  const Scene& scene = fixed_->scene;
  const Edge edges[] = {scene.edges.left, scene.edges.right, scene.edges.bottom, scene.edges.top};
  for (const Side side : {Side::left, Side::right, Side::bottom, Side::top})
    if (edges[static_cast<std::size_t>(side)] == Edge::solid)
      meet(Contact::With::edge, static_cast<std::size_t>(side), distance_to(sweep, scene, side));
  for (std::size_t n = 0; n < scene.obstacles.size(); ++n)
    meet(Contact::With::obstacle, n, distance_to(sweep, scene.obstacles[n]));

  // Balls piece by piece, so that no more is looked at than lies along the way.
  Places& places = workspace().places;
  const Quadtree& tree = places.of(balls_, steps_);
  const auto [begin, until] = part_within(sweep, places.bounds());
  const double end = std::min(until, least);
  if (size() == 0 || !(begin <= end)) return first;
  const double piece = std::max(8 * (radius + places.mean_radius()), (end - begin) / 512);
  // More than rounding.
  const double margin = 1e-9 * (length(sweep.at(begin)) + end + radius);
  std::vector<std::uint32_t> found;
  for (double done = begin; done <= end && done < least; done += piece) {
    const Vec2 a = sweep.at(done);
    const Vec2 b = sweep.at(done + piece);
    const Vec2 reach{radius + margin, radius + margin};
    tree.query_box(Vec2{std::min(a.x, b.x), std::min(a.y, b.y)} - reach,
                   Vec2{std::max(a.x, b.x), std::max(a.y, b.y)} + reach, found);
    for (const std::uint32_t i : found)
      if (in_play(i))
        meet(Contact::With::ball, i, distance_to(sweep, balls_.position(i), balls_.radius[i]));
  }
  return first;
}

}  // namespace carom

#include <algorithm>
#include <cmath>
#include <vector>

#include "carom/arithmetic.hpp"
#include "carom/internal/fixed_parts.hpp"
#include "carom/internal/scene_check.hpp"
#include "carom/scene_file.hpp"
#include "carom/state_bytes.hpp"
#include "carom/world.hpp"

namespace carom {

namespace {

constexpr std::size_t ball_bytes = 4 + 1 + 8 * 8;

// No world gets that far or that fast in any time that can be waited for.
constexpr double beyond = 1e30;

// A lead that broke waits with what is left of its solidity.
bool is_state(const Ball& ball) {
  const auto within = [](Vec2 vector) {
    return std::abs(vector.x) <= beyond && std::abs(vector.y) <= beyond;
  };
  return ball.role <= Role::projectile && within(ball.position) && within(ball.velocity) &&
         within(ball.acceleration) && ball.radius >= min_size && ball.radius <= max_quantity &&
         ball.solidity >= (is_lead(ball.role) ? -beyond : 0);
}

}  // namespace

std::string World::save_state() const {
  const ExactArithmetic exact;
  bytes::Writer out;
  out.text(write_scene(scene()));
  out.number(static_cast<std::uint8_t>(lead_out_));
  out.number(steps_);
  out.number(next_id_);
  out.number(std::uint64_t{size()});
  for (std::size_t i = 0; i < size(); ++i) {
    const Ball one = ball(i);
    out.number(one.id);
    out.number(static_cast<std::uint8_t>(one.role));
    for (const Vec2 vector : {one.position, one.velocity, one.acceleration}) {
      out.number(vector.x);
      out.number(vector.y);
    }
    out.number(one.radius);
    out.number(one.solidity);
  }
  return bytes::seal('w', out.take());
}

Result<World> World::load_state(std::string_view state) {
  const ExactArithmetic exact;
  const auto payload = bytes::unseal('w', state);
  if (!payload) return payload.errors();
  bytes::Reader in(payload.value());
  auto scene = read_scene(in.text());
  if (!scene) return scene.errors();
  if (!scene.value().balls.empty()) return bytes::damaged("its scene has balls");
  auto world = create(std::move(scene).value());
  if (!world) return world;
  World& loaded = world.value();

  const auto lead_out = in.number<std::uint8_t>();
  loaded.steps_ = in.number<std::uint64_t>();
  loaded.next_id_ = in.number<std::uint32_t>();
  const auto count = in.number<std::uint64_t>();
  if (count > max_balls || in.left() != count * ball_bytes)
    return bytes::damaged("its number of balls is wrong");
  std::vector<std::uint32_t> ids;
  Scene heaps;
  heaps.holes = loaded.scene().holes;
  for (std::uint64_t i = 0; i < count; ++i) {
    Ball ball;
    ball.id = in.number<std::uint32_t>();
    ball.role = static_cast<Role>(in.number<std::uint8_t>());
    for (Vec2* vector : {&ball.position, &ball.velocity, &ball.acceleration}) {
      vector->x = in.real();
      vector->y = in.real();
    }
    ball.radius = in.real();
    ball.solidity = in.real();
    const bool may_lead = i == 0 && (ball.role != Role::projectile || std::isinf(ball.solidity));
    if (!is_state(ball) || (is_lead(ball.role) && !may_lead) || ball.id >= loaded.next_id_)
      return bytes::damaged("ball " + std::to_string(i) + " is none");
    ids.push_back(ball.id);
    loaded.balls_.push_back(ball);
    heaps.balls.push_back(ball);
  }
  if (!in.whole() || lead_out > 1 || (lead_out == 1 && !loaded.has_lead()))
    return bytes::damaged("it is not whole");
  std::sort(ids.begin(), ids.end());
  if (std::adjacent_find(ids.begin(), ids.end()) != ids.end())
    return bytes::damaged("an id is there twice");
  // A run may heap balls up more than a scene may at its start, but not that much more.
  if (Errors errors = heap_errors(heaps, 10 * max_overlaps(heaps.balls.size())); !errors.empty())
    return errors;
  loaded.lead_out_ = lead_out == 1;
  return world;
}

}  // namespace carom

#include <algorithm>
#include <cstring>
#include <new>
#include <string>
#include <utility>
#include <vector>

#include "carom/carom.h"
#include "carom/scene_file.hpp"
#include "carom/version.hpp"
#include "carom/world.hpp"

struct carom_world {
  carom::World world;
  std::vector<carom_event> events{};
};

static_assert(sizeof(carom::Role) == 1 && static_cast<int>(carom::Role::projectile) == 4 &&
                  static_cast<int>(carom::EventKind::left) == 8,
              "carom.h says so");

namespace {

void tell(const std::string& text, char* error, std::size_t room) {
  if (room == 0) return;
  // Not in the middle of a character.
  std::size_t size = std::min(text.size(), room - 1);
  while (size < text.size() && size > 0 && (text[size] & 0xc0) == 0x80) --size;
  std::memcpy(error, text.data(), size);
  error[size] = '\0';
}

// Makes the world, unless that is refused or memory is short.
template <class Make>
carom_world* made(char* error, std::size_t room, Make make) try {
  carom::Result<carom::World> world = make();
  if (world) return new carom_world{std::move(world).value()};
  tell(to_string(world.errors().front()), error, room);
  return nullptr;
} catch (const std::bad_alloc&) {
  tell("there is not enough memory", error, room);
  return nullptr;
}

int done(const carom::Status& status, char* error, std::size_t room) {
  if (status) return 1;
  tell(to_string(status.errors().front()), error, room);
  return 0;
}

}  // namespace

const char* carom_version(void) { return carom::library_version(); }

carom_world* carom_read(const char* json, size_t size, char* error, size_t room) {
  return made(error, room, [&]() -> carom::Result<carom::World> {
    auto scene = carom::read_scene({json, size});
    if (!scene) return scene.errors();
    return carom::World::create(std::move(scene).value());
  });
}

carom_world* carom_copy(const carom_world* world) {
  return made(nullptr, 0, [&] { return world->world; });
}

void carom_free(carom_world* world) { delete world; }

uint64_t carom_run(carom_world* world, uint64_t most, int until_rest) {
  world->events.clear();
  const auto keep = [&](std::uint64_t step, std::span<const carom::Event> events) {
    for (const carom::Event& e : events)
      world->events.push_back({step, static_cast<std::uint8_t>(e.kind), e.ball, e.other,
                               e.position.x, e.position.y, e.deviation.x, e.deviation.y, e.damage,
                               e.solidity});
  };
  return world->world.run({.rest = until_rest != 0}, most, keep).steps;
}

size_t carom_events(const carom_world* world, const carom_event** events) {
  *events = world->events.data();
  return world->events.size();
}

void carom_get_balls(const carom_world* world, carom_balls* to) {
  const carom::BallsView balls = world->world.balls();
  *to = {.size = balls.size(),
         .lead_is_out = balls.size() > 0 && !world->world.in_play(0) ? 1 : 0,
         .x = balls.x.data(),
         .y = balls.y.data(),
         .vx = balls.vx.data(),
         .vy = balls.vy.data(),
         .radius = balls.radius.data(),
         .solidity = balls.solidity.data(),
         .id = balls.id.data(),
         .role = reinterpret_cast<const std::uint8_t*>(balls.role.data())};
}

uint64_t carom_steps(const carom_world* world) { return world->world.steps(); }
int carom_at_rest(const carom_world* world) { return world->world.at_rest() ? 1 : 0; }
uint64_t carom_state_hash(const carom_world* world) { return world->world.state_hash(); }

int carom_set_velocity(carom_world* world, size_t index, double vx, double vy, char* error,
                       size_t room) {
  return done(world->world.set_velocity(index, {vx, vy}), error, room);
}

int carom_place_lead(carom_world* world, double x, double y, char* error, size_t room) {
  return done(world->world.place_lead({x, y}), error, room);
}

size_t carom_save(const carom_world* world, void* bytes, size_t room) {
  const std::string state = world->world.save_state();
  if (state.size() <= room) std::memcpy(bytes, state.data(), state.size());
  return state.size();
}

carom_world* carom_load(const void* bytes, size_t size, char* error, size_t room) {
  return made(error, room, [&] {
    return carom::World::load_state({static_cast<const char*>(bytes), size});
  });
}

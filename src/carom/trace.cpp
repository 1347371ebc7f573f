#include "carom/trace.hpp"

#include <array>
#include <cstdint>
#include <string_view>

#include "carom/arithmetic.hpp"
#include "json/number_text.hpp"

namespace carom {

namespace {

constexpr std::array<std::string_view, 4> side_names{"left", "right", "bottom", "top"};
constexpr std::array<std::string_view, 9> kind_names{
    "pair", "cushion", "floor", "wall", "cap", "damage", "pocketed", "destroyed", "left"};

template <class Number>
void field(std::string& out, std::string_view key, Number number) {
  out.append(",\"").append(key).append("\":");
  append_number(out, number);
}

void deviation(std::string& out, Vec2 dv) {
  out += ",\"dv\":[";
  append_number(out, dv.x);
  out += ',';
  append_number(out, dv.y);
  out += ']';
}

void ball(std::string& out, const Ball& b) {
  out += "{\"id\":";
  append_number(out, b.id);
  field(out, "x", b.position.x);
  field(out, "y", b.position.y);
  field(out, "vx", b.velocity.x);
  field(out, "vy", b.velocity.y);
  field(out, "ax", b.acceleration.x);
  field(out, "ay", b.acceleration.y);
  field(out, "radius", b.radius);
  if (b.solidity == infinite_solidity)
    out += ",\"solidity\":null";
  else
    field(out, "solidity", b.solidity);
  out += '}';
}

void event(std::string& out, const Event& e) {
  out.append("{\"kind\":\"").append(kind_names[static_cast<std::size_t>(e.kind)]).append("\"");
  field(out, e.kind == EventKind::pair ? "a" : "ball", e.ball);
  switch (e.kind) {
    case EventKind::pair:
      field(out, "b", e.other);
      deviation(out, e.deviation);
      break;
    case EventKind::cushion:
      out.append(",\"side\":\"").append(side_names[e.other]).append("\"");
      deviation(out, e.deviation);
      break;
    case EventKind::floor:
      deviation(out, e.deviation);
      break;
    case EventKind::wall:
    case EventKind::cap:
      field(out, "obstacle", e.other);
      deviation(out, e.deviation);
      break;
    case EventKind::damage:
      field(out, "ds", e.damage);
      field(out, "solidity", e.solidity);
      break;
    case EventKind::pocketed:
      field(out, "hole", e.other);
      break;
    case EventKind::destroyed:
    case EventKind::left:
      break;
  }
  out += '}';
}

void separate(std::string& out, bool& first) {
  if (!first) out += ',';
  first = false;
}

}  // namespace

std::string hash_text(std::uint64_t hash) {
  constexpr std::string_view digits = "0123456789abcdef";
  std::string text;
  for (int shift = 60; shift >= 0; shift -= 4) text += digits[(hash >> shift) & 15];
  return text;
}

void append_trace_line(std::string& out, const World& world, std::span<const Event> events) {
  const ExactArithmetic exact;
  out += "{\"step\":";
  append_number(out, world.steps());
  out.append(",\"hash\":\"").append(hash_text(world.state_hash())).append("\",\"balls\":[");
  bool first = true;
  for (std::size_t i = 0; i < world.size(); ++i) {
    if (!world.in_play(i)) continue;
    separate(out, first);
    ball(out, world.ball(i));
  }
  out += "],\"events\":[";
  first = true;
  for (const Event& e : events) {
    separate(out, first);
    event(out, e);
  }
  out += "]}\n";
}

}  // namespace carom

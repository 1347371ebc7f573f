#pragma once

#include <limits>
#include <string>
#include <string_view>

#include "carom/scene.hpp"

namespace carom {

// The parts of a scene file: for every kind of object its keys, in the order in which they are
// written. Reading, checking and writing all go by these tables.

inline constexpr std::size_t max_name_bytes = 200;  ///< author and licence, too
inline constexpr std::size_t max_description_bytes = 2000;
inline constexpr int format_version = 1;

/// The numbers a field takes.
struct Range {
  enum class Low { included, excluded };

  double low = 0;
  Low low_is = Low::included;
  double high = std::numeric_limits<double>::max();
  std::string_view note;  ///< shown in brackets, mostly the unit
};

bool contains(const Range& range, double number);

inline constexpr Range size_range{min_size, Range::Low::included, max_quantity, "px"};
inline constexpr Range coordinate_range{-max_quantity, Range::Low::included, max_quantity, "px"};
inline constexpr Range velocity_range{-max_speed, Range::Low::included, max_speed, "px/s"};
inline constexpr Range acceleration_range{0, Range::Low::included, max_quantity, "px/s²"};
inline constexpr Range friction_range{0, Range::Low::excluded, 1, ""};
inline constexpr Range damage_per_speed_range{0, Range::Low::included, max_quantity, ""};
inline constexpr Range damage_range{0, Range::Low::included, std::numeric_limits<double>::max(),
                                    ""};
inline constexpr Range solidity_range{0, Range::Low::included, infinite_solidity,
                                      "left out: infinite"};

/// A key of the object that a T is in a file.
template <class T>
struct Field {
  std::string_view name;
  bool required = false;
  /// Where a number goes, and which numbers; null for what is no number.
  double& (*number)(T&) = nullptr;
  Range range = {};
  /// The expectation for a field that is not a number.
  MessageCode expected = MessageCode::text;
  /// Where an edge goes; null for what is none.
  Edge T::*edge = nullptr;
  /// Where a text goes, and how long it may be; null for what is none.
  std::string T::*text = nullptr;
  std::size_t most_bytes = max_name_bytes;

  double value(const T& object) const {
    return number(const_cast<T&>(object));  // `number` writes nothing
  }
};

/// The values that a field takes, for messages.
Message expectation(const Range& range);
template <class T>
Message expectation(const Field<T>& field) {
  return field.number ? expectation(field.range) : Message(field.expected);
}

/// The index of the key `name`, or the number of keys if there is none.
template <class T, std::size_t count>
constexpr std::size_t index_of(const Field<T> (&fields)[count], std::string_view name) {
  std::size_t index = 0;
  while (index < count && fields[index].name != name) ++index;
  return index;
}

static_assert(max_name_bytes == 200 && max_description_bytes == 2000 && max_throws == 1000 &&
                  format_version == 1,
              "the texts below say so");

inline constexpr Field<Scene> scene_fields[] = {
    // For editors; not kept.
    {.name = "$schema", .expected = MessageCode::text_of_2000_bytes},
    {.name = "carom", .required = true, .expected = MessageCode::format_version},
    {.name = "name", .expected = MessageCode::text_of_200_bytes, .text = &Scene::name},
    {.name = "author", .expected = MessageCode::text_of_200_bytes, .text = &Scene::author},
    {.name = "licence", .expected = MessageCode::text_of_200_bytes, .text = &Scene::licence},
    {.name = "description",
     .expected = MessageCode::text_of_2000_bytes,
     .text = &Scene::description,
     .most_bytes = max_description_bytes},
    {"width", true, [](Scene& s) -> double& { return s.width; }, size_range},
    {"height", true, [](Scene& s) -> double& { return s.height; }, size_range},
    {.name = "edges", .expected = MessageCode::object_of_edges},
    {"friction", false, [](Scene& s) -> double& { return s.friction; }, friction_range},
    {"gravity", false, [](Scene& s) -> double& { return s.gravity; }, acceleration_range},
    {"hole_pull", false, [](Scene& s) -> double& { return s.hole_pull; }, acceleration_range},
    {"damage_per_speed", false, [](Scene& s) -> double& { return s.damage_per_speed; },
     damage_per_speed_range},
    {"damage_threshold", false, [](Scene& s) -> double& { return s.damage_threshold; },
     damage_range},
    {.name = "throws", .expected = MessageCode::throws},
    {.name = "holes", .expected = MessageCode::array_of_holes},
    {.name = "obstacles", .expected = MessageCode::array_of_obstacles},
    {.name = "balls", .required = true, .expected = MessageCode::array_of_balls},
};

inline constexpr Field<Edges> edges_fields[] = {
    {.name = "left", .expected = MessageCode::edge, .edge = &Edges::left},
    {.name = "right", .expected = MessageCode::edge, .edge = &Edges::right},
    {.name = "bottom", .expected = MessageCode::edge, .edge = &Edges::bottom},
    {.name = "top", .expected = MessageCode::edge, .edge = &Edges::top},
};

inline constexpr Field<Hole> hole_fields[] = {
    {"x", true, [](Hole& h) -> double& { return h.position.x; }, coordinate_range},
    {"y", true, [](Hole& h) -> double& { return h.position.y; }, coordinate_range},
    {"radius", false, [](Hole& h) -> double& { return h.radius; }, size_range},
};

inline constexpr Field<Obstacle> obstacle_fields[] = {
    {"x", true, [](Obstacle& o) -> double& { return o.x; }, coordinate_range},
    {"height", false, [](Obstacle& o) -> double& { return o.height; }, size_range},
    {"radius", false, [](Obstacle& o) -> double& { return o.radius; }, size_range},
};

inline constexpr Field<Ball> ball_fields[] = {
    {"x", true, [](Ball& b) -> double& { return b.position.x; }, coordinate_range},
    {"y", true, [](Ball& b) -> double& { return b.position.y; }, coordinate_range},
    {"vx", false, [](Ball& b) -> double& { return b.velocity.x; }, velocity_range},
    {"vy", false, [](Ball& b) -> double& { return b.velocity.y; }, velocity_range},
    {"radius", false, [](Ball& b) -> double& { return b.radius; }, size_range},
    {"solidity", false, [](Ball& b) -> double& { return b.solidity; }, solidity_range},
    {.name = "role", .expected = MessageCode::role},
};

/// As files name them, in the order of the enumerations.
inline constexpr std::string_view edge_names[] = {"solid", "open"};
inline constexpr std::string_view role_names[] = {"neutral", "cue", "red", "enemy", "projectile"};

/// The radius of a ball that gives none.
constexpr double radius_left_out(Role role) {
  return role == Role::cue ? default_cue_radius : default_radius;
}

}  // namespace carom

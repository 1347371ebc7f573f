#pragma once

#include <functional>
#include <optional>
#include <string>

#include "carom/result.hpp"
#include "carom/scene.hpp"
#include "carom/vec2.hpp"

namespace carom {

/// Why a disc at `position` with `radius` (both sound numbers) cannot be in the scene `fixed`: it
/// overlaps an obstacle or sticks out of a solid edge. Touching is fine. `fixed.balls` do not
/// count. `pointer` names the disc in the error.
std::optional<Error> obstruction_error(const Scene& fixed, Vec2 position, double radius,
                                       std::string pointer);

/// check() without its limit: hands over every error, in the order of the keys in docs/formats.md.
/// O(balls + obstacles) as long as these do not lie in heaps.
void check(const Scene& scene, const std::function<void(Error)>& report);

/// The error of a scene that is sound otherwise, in which more than `most` pairs of balls overlap
/// or more than `most` pairs of a ball's centre and a hole.
Errors heap_errors(const Scene& scene, std::size_t most);

/// The last error of a list that was cut at max_errors.
Error more_errors(std::size_t count);

}  // namespace carom

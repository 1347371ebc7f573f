#pragma once

#include <span>
#include <string>

#include "carom/event.hpp"
#include "carom/public.hpp"
#include "carom/world.hpp"

namespace CAROM_PUBLIC carom {

/// Appends one line of a trace (docs/formats.md#traces-json-lines), newline included: the world's
/// state after its last step, and that step's events. Numbers in the shortest form that reads back
/// to the same bits.
void append_trace_line(std::string& out, const World& world, std::span<const Event> events);

/// A hash as a trace writes it: 16 hexadecimal digits, lower case.
std::string hash_text(std::uint64_t hash);

}  // namespace carom

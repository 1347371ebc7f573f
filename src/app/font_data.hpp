#pragma once

#include <span>

/// TrueType files, embedded by embed.cmake.
namespace app {

extern const std::span<const unsigned char> lato_regular;
extern const std::span<const unsigned char> lato_bold;
extern const std::span<const unsigned char> lato_black;

}  // namespace app

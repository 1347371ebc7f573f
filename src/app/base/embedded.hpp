#pragma once

#include <span>
#include <string_view>

/// Files that are part of the program, put there by embed.cmake.
namespace app {

struct Embedded {
  std::string_view name;
  std::span<const unsigned char> bytes;
};

extern const std::span<const Embedded> fonts;           ///< TrueType, by Face
extern const std::span<const Embedded> shipped_files;   ///< levels, in order
extern const std::span<const Embedded> embedded_texts;  ///< CODE.texts of po/compile.py

}  // namespace app

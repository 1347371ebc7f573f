#pragma once

#include <optional>
#include <string_view>

/// The part of a link to the page behind its address (docs/formats.md).
namespace app {

namespace links {
inline constexpr std::string_view replay = "#replay=";
inline constexpr std::string_view level = "#level=";
}  // namespace links

/// Returns the text behind `key` in a link; none if it is not in there.
inline std::optional<std::string_view> behind(std::string_view key, std::string_view link) {
  const std::size_t at = link.find(key);
  if (at == std::string_view::npos) return std::nullopt;
  return link.substr(at + key.size());
}

}  // namespace app

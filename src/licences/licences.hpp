#pragma once

#include <string_view>

namespace licences {

/// The licence of this program and those of what is built into it or linked with it, under a
/// heading each, as Debian's packages have them.
extern const std::string_view text;

}  // namespace licences

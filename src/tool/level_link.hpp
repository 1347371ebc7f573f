#pragma once

namespace CLI {
class App;
}

namespace tool {

/// Adds `carom level-link` to the command line; its exit status comes back in `status`.
void add_level_link(CLI::App& carom, int& status);

}  // namespace tool

#pragma once

namespace CLI {
class App;
}

namespace tool {

/// Adds `carom check` to the command line; its exit status comes back in `status`.
void add_check(CLI::App& carom, int& status);

}  // namespace tool

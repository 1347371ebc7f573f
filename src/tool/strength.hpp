#pragma once

namespace CLI {
class App;
}

namespace tool {

/// Adds `carom strength` to the command line; its exit status comes back in `status`.
void add_strength(CLI::App& carom, int& status);

}  // namespace tool

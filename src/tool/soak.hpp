#pragma once

namespace CLI {
class App;
}

namespace tool {

/// Adds `carom soak` to the command line; its exit status comes back in `status`.
void add_soak(CLI::App& carom, int& status);

}  // namespace tool

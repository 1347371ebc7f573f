#pragma once

namespace CLI {
class App;
}

namespace tool {

/// Adds `carom replay` to the command line; its exit status comes back in `status`.
void add_replay(CLI::App& carom, int& status);

}  // namespace tool

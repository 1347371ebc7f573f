#pragma once

namespace CLI {
class App;
}

namespace tool {

/// Adds `carom simulate` to the command line; its exit status comes back in `status`.
void add_simulate(CLI::App& carom, int& status);

}  // namespace tool

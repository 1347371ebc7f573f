#pragma once

namespace CLI {
class App;
}

namespace tool {

/// Adds `carom quadtree` to the command line; its exit status comes back in `status`.
void add_quadtree(CLI::App& carom, int& status);

}  // namespace tool

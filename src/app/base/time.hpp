#pragma once

#include <chrono>

namespace app {

using std::chrono::milliseconds;
using std::chrono::nanoseconds;
using std::chrono::seconds;

}  // namespace app

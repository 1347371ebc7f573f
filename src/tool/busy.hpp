#pragma once

#include <atomic>
#include <cstdio>
#include <string>
#include <unistd.h>
#include <utility>

#ifndef __EMSCRIPTEN__
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <thread>
#endif

namespace tool {

/// While it lives, and if standard error is a terminal, a line there says what is being done and
/// since when; from a tenth of a second on, so that short work says nothing. A thread of its own
/// draws it: no work needs to be divided for it.
class Busy {
 public:
  explicit Busy(std::string what) : what_(std::move(what)) {
#ifndef __EMSCRIPTEN__
    if (::isatty(STDERR_FILENO)) drawer_ = std::thread([this] { draw(); });
#endif
  }
  ~Busy() {
#ifndef __EMSCRIPTEN__
    if (!drawer_.joinable()) return;
    {
      const std::lock_guard lock(mutex_);
      done_ = true;
    }
    end_.notify_one();
    drawer_.join();
#endif
  }
  Busy(const Busy&) = delete;
  Busy& operator=(const Busy&) = delete;

  /// The part that is done, from 0 to 1, where that is known.
  void set_part(double part) { per_cent_ = static_cast<int>(part * 100); }

 private:
#ifndef __EMSCRIPTEN__
  void draw() {
    using Clock = std::chrono::steady_clock;
    const Clock::time_point start = Clock::now();
    bool shown = false;
    std::unique_lock lock(mutex_);
    while (!end_.wait_for(lock, std::chrono::milliseconds(100), [this] { return done_; })) {
      const std::chrono::duration<double> time = Clock::now() - start;
      std::string text = "\r\x1b[K" + what_;
      if (const int part = per_cent_; part >= 0) text += ", " + std::to_string(part) + " %";
      std::fprintf(stderr, "%s, %.1f s", text.c_str(), time.count());
      shown = true;
    }
    if (shown) std::fputs("\r\x1b[K", stderr);
  }

#endif

  std::string what_;
  std::atomic<int> per_cent_ = -1;
#ifndef __EMSCRIPTEN__
  std::mutex mutex_;
  std::condition_variable end_;
  bool done_ = false;
  std::thread drawer_;
#endif
};

}  // namespace tool

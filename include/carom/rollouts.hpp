#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <type_traits>
#include <vector>

#include "carom/public.hpp"
#include "carom/world.hpp"

namespace CAROM_PUBLIC carom {

class ThreadPool;

/// Many futures of one state, played on several threads: for searches, hints and studies.
class Rollouts {
 public:
  /// Threads, the caller's included: 1 to max_threads; other numbers are taken as the nearest of
  /// these. Where threads cannot be had, there are fewer.
  explicit Rollouts(int threads = 1);
  ~Rollouts();
  Rollouts(const Rollouts&) = delete;
  Rollouts& operator=(const Rollouts&) = delete;

  /// For each k < results.size() calls play(world, k), with a world that equals `start`, and puts
  /// what it returns into results[k]. Returns when all are done. The results are the same for every
  /// number of threads if play depends on nothing but the world and k. It is called by several
  /// threads at once, in any order, so it must write nothing that another call reads or writes, and
  /// it must not throw. Nothing is allocated for a single call of it.
  template <class Result, class Play>
  void run(const World& start, std::span<Result> results, const Play& play) {
    static_assert(!std::is_same_v<Result, bool>, "neighbouring bits would be written at once");
    struct Job {
      const World& start;
      std::span<Result> results;
      const Play& play;
    } job{start, results, play};
    run(
        start, results.size(),
        [](void* given, World& world, std::size_t begin, std::size_t end) {
          const Job& mine = *static_cast<Job*>(given);
          for (std::size_t k = begin; k < end; ++k) {
            world = mine.start;
            mine.results[k] = mine.play(world, k);
          }
        },
        &job);
  }

 private:
  using PlaySome = void (*)(void* job, World& world, std::size_t begin, std::size_t end);
  void run(const World& start, std::size_t count, PlaySome play_some, void* job);

  std::unique_ptr<ThreadPool> thread_pool_;
  std::vector<World> worlds_;  ///< one a thread, kept for its memory
};

}  // namespace carom

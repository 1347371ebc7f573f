#pragma once

#include <benchmark/benchmark.h>
#include <filesystem>
#include <nlohmann/json.hpp>

namespace bench {

/// Takes what Google Benchmark measured: tells the progress on stderr, keeps the figures, writes
/// them as JSON. No date, so that equal figures are equal files.
class Results final : public benchmark::BenchmarkReporter {
 public:
  bool ReportContext(const Context& context) override;
  void ReportRuns(const std::vector<Run>& runs) override;

  /// Benchmarks of our engine that failed. What another one fails in is noted in its row.
  int failures() const { return failures_; }

  /// False: could not.
  bool write(const std::filesystem::path& file) const;

 private:
  nlohmann::ordered_json machine_;
  nlohmann::ordered_json rows_ = nlohmann::ordered_json::array();
  int failures_ = 0;
};

}  // namespace bench

#include "results.hpp"

#include <algorithm>
#include <chipmunk/chipmunk.h>
#include <cstdio>
#include <fstream>
#include <string>

namespace bench {

namespace {

std::string processor() {
  std::ifstream info("/proc/cpuinfo");
  for (std::string line; std::getline(info, line);)
    if (line.starts_with("model name") && line.find(": ") != std::string::npos)
      return line.substr(line.find(": ") + 2);
  return "unknown";
}

}  // namespace

bool Results::ReportContext(const Context& context) {
  machine_ = {{"processor", processor()},    {"cores", context.cpu_info.num_cpus},
              {"compiler", BENCH_COMPILER},  {"flags", BENCH_FLAGS},
              {"chipmunk", cpVersionString}, {"box2d", BENCH_BOX2D}};
  return true;
}

// Called with all repetitions of a benchmark, then once more with their averages, which we leave.
void Results::ReportRuns(const std::vector<Run>& runs) {
  if (runs.front().run_type == Run::RT_Aggregate) return;
  const Run& first = runs.front();
  // SCENE/BALLS/CONTESTANT
  const std::string& name = first.run_name.function_name;
  const auto scene_end = name.find('/');
  const auto balls_end = name.find('/', scene_end + 1);
  const std::string contestant = name.substr(balls_end + 1);
  nlohmann::ordered_json row = {
      {"scene", name.substr(0, scene_end)},
      {"balls", std::stoi(name.substr(scene_end + 1, balls_end - scene_end - 1))},
      {"by", contestant}};
  const auto failed = std::ranges::find_if(runs, &Run::error_occurred);
  if (failed != runs.end()) {
    std::fprintf(stderr, "%-28s WRONG: %s\n", name.c_str(), failed->error_message.c_str());
    if (contestant.starts_with("carom")) ++failures_;
    row["wrong"] = failed->error_message;
    rows_.push_back(std::move(row));
    return;
  }
  std::vector<double> nanoseconds;
  nanoseconds.reserve(runs.size());
  for (const Run& run : runs) nanoseconds.push_back(run.counters.at("seconds").value * 1e9);
  std::ranges::sort(nanoseconds);
  row["nanoseconds"] = nanoseconds;  // of a run, one for each repetition, the fastest first
  for (const auto& [key, counter] : first.counters)
    if (key != "seconds") row[key] = counter.value;
  row["ns_per_ball_step"] = nanoseconds.front() / row["ball_steps"].get<double>();
  if (row.contains("shots"))
    row["shots_per_second"] = row["shots"].get<double>() / nanoseconds.front() * 1e9;
  std::fprintf(stderr, "%-28s %10.2f ns a ball and step\n", name.c_str(),
               row["ns_per_ball_step"].get<double>());
  rows_.push_back(std::move(row));
}

bool Results::write(const std::filesystem::path& file) const {
  std::ofstream out(file);
  out << nlohmann::ordered_json{{"machine", machine_}, {"rows", rows_}}.dump(1) << '\n';
  out.close();
  return out.good();
}

}  // namespace bench

// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Cases as benchmarks with times of their own; see harness.h.
#include "eval/bench/harness.h"

#include <benchmark/benchmark.h>

#include <cstdio>
#include <exception>
#include <fstream>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>

#include "eval/bench/allocations.h"
#include "eval/bench/memory.h"

namespace primitect::bench {
namespace {

using Json = nlohmann::ordered_json;

/// A case with its input and state, kept over all repetitions, and what was measured of it.
struct Bench {
  explicit Bench(const Case& of) : made_of(of) {}

  Case made_of;
  std::optional<Work> work;
  std::size_t next = 0;
  FrameClock clock;
  std::vector<double> cpu_ms, wall_ms;
  std::map<std::string, std::vector<double>> stages_ms;
  std::vector<std::string> stage_order;
  std::vector<std::size_t> allocations, allocated_bytes;

  void prepare() {
    if (work) return;
    made_of.make_input();
    work = made_of.make_work();
    if (made_of.warm_up) runAll();
  }

  /// Each input once, not recorded.
  void runAll() {
    for (std::size_t frame = 0; frame < work->frames; ++frame) run(frame);
  }

  Allocations run(std::size_t frame) {
    beginCounting();
    clock.begin();
    work->run(frame, clock);
    clock.end();
    return endCounting();
  }

  double measureNext() {
    const Allocations taken = run(next);
    next = (next + 1) % work->frames;
    cpu_ms.push_back(clock.cpuMs());
    wall_ms.push_back(clock.wallMs());
    for (const auto& [stage, milliseconds] : clock.stages()) {
      std::vector<double>& times = stages_ms[stage];
      if (times.empty()) stage_order.push_back(stage);
      times.push_back(milliseconds);
    }
    allocations.push_back(taken.count);
    allocated_bytes.push_back(taken.bytes);
    return clock.cpuMs();
  }

  Json json() const {
    Json stages = Json::object();
    for (const std::string& stage : stage_order) stages[stage] = stages_ms.at(stage);
    Json facts = Json::object();
    for (const auto& [name, value] : work->facts()) facts[name] = value;
    Json result = {
        {"cpu_ms", cpu_ms}, {"wall_ms", wall_ms}, {"stages_ms", stages}, {"frames", work->frames}, {"facts", facts}};
    if (canCountAllocations()) {
      result["allocations"] = allocations;
      result["allocated_bytes"] = allocated_bytes;
    }
    return result;
  }
};

struct Arguments {
  std::string times, memory, inputs = "8";
};

/// Takes ours out of the command line.
Arguments parse(int& argc, char** argv) {
  Arguments arguments;
  const std::map<std::string, std::string*> ours = {
      {"--times", &arguments.times}, {"--memory", &arguments.memory}, {"--inputs", &arguments.inputs}};
  int kept = 1;
  for (int k = 1; k < argc; ++k) {
    const auto option = ours.find(argv[k]);
    if (option == ours.end()) {
      argv[kept++] = argv[k];
      continue;
    }
    if (k + 1 == argc) throw std::invalid_argument(option->first + " needs a value");
    *option->second = argv[++k];
  }
  argc = kept;
  return arguments;
}

/// What is resident with the input alone, and at most while it is worked on.
int printMemory(const std::vector<Case>& cases, const std::string& name) {
  for (const Case& one : cases) {
    if (one.name != name) continue;
    constexpr int kRounds = 3;  // buffers have grown to their size by then
    one.make_input();
    const bool exact = forgetPeak();
    const long before = statusKilobytes("VmRSS");
    Bench bench(one);
    bench.work = one.make_work();
    for (int round = 0; round < kRounds; ++round) bench.runAll();
    const long peak = statusKilobytes("VmHWM");
    std::printf("%s\n", Json{{"case", name}, {"input_kb", before}, {"peak_kb", peak}, {"exact", exact}}.dump().c_str());
    return 0;
  }
  throw std::invalid_argument("--memory " + name + ": there is no such case, see --benchmark_list_tests");
}

void writeTimes(const std::string& path, const std::vector<std::unique_ptr<Bench>>& benches) {
  Json result = Json::object();
  for (const auto& bench : benches) {
    if (!bench->cpu_ms.empty()) result[bench->made_of.name] = bench->json();
  }
  std::ofstream file(path);
  file << result << "\n" << std::flush;
  if (!file) throw std::runtime_error("--times " + path + ": cannot be written");
}

void measure(benchmark::State& state, Bench& bench) {
  constexpr double kSecondsPerMillisecond = 1e-3;
  try {
    bench.prepare();
    for (auto _ : state) state.SetIterationTime(bench.measureNext() * kSecondsPerMillisecond);
  } catch (const std::exception& error) {
    state.SkipWithError(error.what());
  }
}

}  // namespace

int runCases(int argc, char** argv, std::vector<Case> (*make)(std::size_t inputs)) try {
  const Arguments arguments = parse(argc, argv);
  const std::vector<Case> cases = make(std::stoul(arguments.inputs));
  if (!arguments.memory.empty()) return printMemory(cases, arguments.memory);
  std::vector<std::unique_ptr<Bench>> benches;
  for (const Case& one : cases) {
    benches.push_back(std::make_unique<Bench>(one));
    benchmark::RegisterBenchmark(one.name.c_str(), measure, std::ref(*benches.back()))
        ->UseManualTime()
        ->Unit(benchmark::kMillisecond);
  }
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  benchmark::RunSpecifiedBenchmarks();
  if (!arguments.times.empty()) writeTimes(arguments.times, benches);
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s: %s\n", argv[0], error.what());
  return 1;
}

}  // namespace primitect::bench

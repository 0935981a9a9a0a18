#include "app/build_info.hpp"
#include "app/case_choice.hpp"
#include "app/commands.hpp"
#include "app/interrupt_watcher.hpp"
#include "app/pareto/pareto_study.hpp"
#include "app/pareto/peer_runs.hpp"
#include "app/progress.hpp"
#include "compare/plot.hpp"
#include "io/file_io.hpp"
#include "io/host.hpp"

#include <chrono>
#include <ostream>

#include <fmt/format.h>
#include <fmt/ostream.h>

namespace eisph {

namespace {

std::string subtitle(const ParetoOptions& options) {
  const BuildInfo build = build_info();
  const HostInfo host = host_info();
  return fmt::format("{}{}, {}, {}, {} runs of each setting, {}", software_name(),
                     build.commit.empty() ? "" : " (" + build.commit + ")", host.cpu_model,
                     build.instruction_set, options.repeats, iso_time(std::chrono::system_clock::now()));
}

void print_best(std::ostream& out, const ParetoResult& result) {
  for (std::size_t e = 0; e < result.chosen->errors.size(); ++e) {
    const auto costs = result.costs(e, false);
    fmt::print(out, "{}, {}: Pareto front\n", result.chosen->name, result.chosen->errors[e].name);
    for (const std::size_t k : pareto_front(costs)) {
      const ParetoPoint& point = result.points[k];
      fmt::print(out, "  {:9.3g} s/s {:8.2f} %  {}, {}, dx = {:g} m\n", costs[k].cost, costs[k].error,
                 point.scheme, point.step, point.spacing);
    }
  }
}

}  // namespace

int pareto_command(const ParetoOptions& options, std::ostream& out, std::ostream& progress) {
  if (options.list) {
    for (const ParetoCase& known : pareto_cases()) fmt::print(out, "{:<18}{}\n", known.name, known.title);
    return 0;
  }
  const InterruptWatcher interrupt;
  const auto cases = choose_cases("pareto", pareto_cases(), options.cases);
  const auto settings = choose_settings(options.only);
  std::vector<PeerRun> peers;
  if (!options.peers.empty()) peers = find_peer_runs(options.peers, cases, options.full);
  require_gnuplot();
  create_folder(options.out);
  Validator validator({options.out, 1, options.full, options.quiet}, progress,
                      [&interrupt] { return interrupt.requested(); });
  std::vector<ParetoResult> results;
  try {
    for (const ParetoCase* chosen : cases) {
      results.push_back(study(*chosen, settings, options.repeats, validator, peers));
      write_pareto_case(options.out, results.back());
      write_pareto_report(options.out, results, subtitle(options));
      if (!options.quiet) print_best(out, results.back());
    }
  } catch (const ValidationInterrupted&) {
    if (!options.quiet) fmt::print(out, "interrupted; finished cases are in {}\n", options.out.string());
    return kInterrupted;
  }
  if (!options.quiet) fmt::print(out, "report in {}\n", (options.out / "report.html").string());
  return 0;
}

}  // namespace eisph

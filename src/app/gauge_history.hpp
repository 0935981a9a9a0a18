#pragma once

#include "app/run_files.hpp"
#include "core/scene.hpp"
#include "core/table.hpp"
#include "render/gauge_plot.hpp"

#include <condition_variable>
#include <limits>
#include <map>
#include <mutex>
#include <span>
#include <string>
#include <vector>

namespace eisph {

/// Whether an image of the scene shows records of gauges.
[[nodiscard]] bool draws_gauges(const Scene& scene);

/// The records that a run has left of these gauges, in this order. Throws InputError naming the file that is
/// missing or wrong.
[[nodiscard]] std::vector<GaugeCurve> read_gauge_curves(const RunFiles& files,
                                                        const std::vector<std::string>& gauges);

/// The records of the gauges that images of a scene show, on their way from the thread that records to the
/// one that draws.
class GaugeHistory {
 public:
  explicit GaugeHistory(const Scene& scene);

  /// A sink that keeps what it has to and hands everything on to `next`, which must outlive it.
  class Tap : public TableSink {
   public:
    Tap(GaugeHistory* history, TableSink& next) : history_(history), next_(&next) {}
    std::size_t open_table(const TableHeader& header) override;
    void append_row(std::size_t table, std::span<const double> row) override;

   private:
    GaugeHistory* history_;  ///< may be null
    TableSink* next_;
    std::map<std::size_t, std::string> gauge_of_table_;
  };

  /// Everything due up to `time` (s) has been recorded.
  void advance(double time);
  /// No more records will come, for whatever reason.
  void close();
  /// The curves of these gauges up to `time` (s), in this order, once they are recorded or closed.
  [[nodiscard]] std::vector<GaugeCurve> up_to(double time, const std::vector<std::string>& gauges);

 private:
  void add(const std::string& gauge, double time, double surface);
  [[nodiscard]] bool keeps(const std::string& gauge) const { return curves_.contains(gauge); }

  std::mutex mutex_;
  std::condition_variable changed_;
  std::map<std::string, GaugeCurve> curves_;  ///< the keys do not change
  double recorded_ = -std::numeric_limits<double>::infinity();
  bool closed_ = false;
};

}  // namespace eisph

#pragma once

#include "app/comparison/photo_comparison.hpp"
#include "compare/report.hpp"
#include "render/comparison_picture.hpp"

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace eisph {

/// Writes what a comparison finds to one folder: pictures and depth maps time by time, then statistics,
/// plots, the report and, where ffmpeg is installed, videos. One object is used by one thread at a time.
class ComparisonWriter {
 public:
  /// `run` names the run in captions. With `other` the upper half of the run is drawn over its lower half.
  ComparisonWriter(const PhotoComparison& comparison, std::filesystem::path folder, std::string run,
                   std::optional<RunDepths> other);

  /// Makes the folder, and removes what an earlier comparison left in it.
  void begin();
  void write_time(const ComparedTime& time);
  /// Everything that needs all times. Without any time there is nothing to write.
  void write_end();

  [[nodiscard]] std::filesystem::path report() const { return folder_ / "report.html"; }

 private:
  [[nodiscard]] ComparisonHeading heading(const ComparedTime& time) const;
  void write_picture(const std::string& kind, const ComparedTime& time, const Image& image,
                     const std::string& caption);
  void write_videos();
  void write_grid_picture();
  std::vector<ReportFigure> write_plots_of_classes();
  ReportFigure write_calibration_plot();

  const PhotoComparison& comparison_;
  std::filesystem::path folder_;
  std::string run_;
  std::optional<RunDepths> other_;
  std::unique_ptr<ComparisonPainter> painter_;
  std::map<std::string, std::vector<std::filesystem::path>> pictures_;  ///< by kind, in the order of time
  std::map<std::size_t, std::vector<ReportFigure>> figures_;            ///< by photograph
};

}  // namespace eisph

#pragma once

#include "core/depth_grid.hpp"
#include "core/grey_picture.hpp"
#include "core/scene.hpp"
#include "render/colour_map.hpp"
#include "render/font.hpp"
#include "render/image.hpp"

#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include <Eigen/Core>

namespace eisph {

/// Headings of a picture.
struct ComparisonHeading {
  std::string title;
  std::string time;
};

/// Depth of one side of a comparison. Cells that do not count are hatched.
struct DepthSide {
  std::string label;
  const DepthGrid& grid;
  const std::vector<std::uint8_t>* valid = nullptr;  ///< by cell, 0: does not count; null: all do
};

/// A photograph with the place of the floor in it.
struct PhotographSide {
  std::string label;
  const GreyPicture& picture;
  std::function<Eigen::Vector2d(const Eigen::Vector2d& plane)> pixel_of;  ///< m to pixels
};

/// A point to be marked in a photograph, in its pixels.
struct PictureMark {
  std::string name;
  Eigen::Vector2d pixel;
};

/// Draws comparisons of water depth seen from above: x to the right, y up, all panels at the same scale, each
/// picture with headings, colour bar and length scale. Heights of pictures follow from their width.
class ComparisonPainter {
 public:
  /// `area` is x_min, y_min, x_max, y_max in m. The scene is a whole tank; its solids are drawn.
  ComparisonPainter(const Scene& scene, const std::array<double, 4>& area, int width);

  /// The photograph, made upright, and the simulation in the photograph's grey tones: `tones` over 0 to
  /// `depth`.
  [[nodiscard]] Image photograph_and_depth(const ComparisonHeading& heading, const PhotographSide& photograph,
                                           const DepthSide& simulation, const ColourMap& tones, double depth);
  /// Two depths in the same colours over 0 to `depth`, m.
  [[nodiscard]] Image depths(const ComparisonHeading& heading, const DepthSide& left, const DepthSide& right,
                             const ColourMap& map, double depth);
  /// The simulation in grey under the area that is wet (by `dry_depth`) on the other side, in transparent red
  /// with its outline.
  [[nodiscard]] Image overlay(const ComparisonHeading& heading, const DepthSide& simulation,
                              const DepthSide& photograph, const ColourMap& map, double depth,
                              double dry_depth);
  /// simulation - photograph from -range to range, m, in the colours of a diverging map.
  [[nodiscard]] Image deviation(const ComparisonHeading& heading, const DepthSide& simulation,
                                const DepthSide& photograph, const ColourMap& map, double range);
  /// One run above the line y = `middle`, another below it.
  [[nodiscard]] Image halves(const ComparisonHeading& heading, const DepthSide& upper, const DepthSide& lower,
                             double middle, const ColourMap& map, double depth);
  /// A photograph as it is, with the edge of the area, cells of `cells` (every n-th line, so that they stay
  /// apart) and marks.
  [[nodiscard]] Image grid_over_photograph(const ComparisonHeading& heading, const PhotographSide& photograph,
                                           const DepthGrid& cells, const std::vector<PictureMark>& marks);

 private:
  struct Panel;
  struct Sheet;

  Sheet make_sheet(const ComparisonHeading& heading, std::size_t panels, const std::string& legend_label);
  void paint(Sheet& sheet, const Panel& panel, double time) const;
  void label(Sheet& sheet, std::size_t panel, const std::string& text);
  void finish(Sheet& sheet, const std::string& legend_label, const ColourMap& map, double lower,
              double upper);

  Scene scene_;
  std::array<double, 4> area_;
  int width_;
  Typeface typeface_;
};

}  // namespace eisph

#include "compare/plot.hpp"

#include "compare/field_plot.hpp"
#include "compare/gnuplot.hpp"
#include "compare/picture.hpp"
#include "compare/plot_axes.hpp"
#include "compare/plot_size.hpp"
#include "compare/plot_style.hpp"
#include "io/temporary_folder.hpp"

#include <cmath>
#include <cstdlib>

#include <gmock/gmock.h>

namespace eisph {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

constexpr std::uint32_t kBlack = 0x000000;
constexpr std::uint32_t kBlue = 0x0072b2;
constexpr std::uint32_t kVermilion = 0xd55e00;

Plot line_plot() {
  return {.title = "Front",
          .x_label = "time t [s]",
          .y_label = "front x [m]",
          .series = {{.label = "model", .curve = {{0.0, 0.5, 1.0}, {0.0, 0.2, 1.0}}}}};
}

/// The PATH of this process while the object lives.
class PathVariable {
 public:
  explicit PathVariable(const std::string& value) : before_(std::getenv("PATH")) {
    ::setenv("PATH", value.c_str(), 1);
  }
  PathVariable(const PathVariable&) = delete;
  PathVariable& operator=(const PathVariable&) = delete;
  ~PathVariable() { ::setenv("PATH", before_.c_str(), 1); }

 private:
  std::string before_;
};

TEST(WritePlot, DrawsAPictureOfTheSizeAskedFor) {
  const TemporaryFolder folder;
  write_plot(folder / "a.png", line_plot(), {640, 480});
  const Picture picture = read_picture(folder / "a.png");
  EXPECT_EQ(picture.width, 640);
  EXPECT_EQ(picture.height, 480);
  EXPECT_GT(picture.count(0xffffff), 640U * 480U * 8U / 10U);
  // The line of 2 pixels runs from the lower left to the upper right.
  EXPECT_GT(picture.count(kBlue), 600U);
  EXPECT_GT(picture.count(kBlue, 0, 380, 150, 480), 10U);
  EXPECT_GT(picture.count(kBlue, 560, 0, 640, 120), 10U);
  EXPECT_EQ(folder.file_count(), 1U);
}

TEST(WritePlot, DrawsTheSamePictureAgain) {
  const TemporaryFolder folder;
  write_plot(folder / "a.png", line_plot());
  write_plot(folder / "b.png", line_plot());
  EXPECT_EQ(text_of(folder / "a.png"), text_of(folder / "b.png"));
  EXPECT_EQ(read_picture(folder / "a.png").width, 900);
}

TEST(WritePlot, DrawsPointsInBlackAndBandsShadedBelowLines) {
  const TemporaryFolder folder;
  Plot plot = line_plot();
  plot.series.push_back(
      {.label = "measured", .curve = {{0.25, 0.75}, {0.9, 0.1}}, .style = SeriesStyle::Points});
  plot.series.push_back({.label = "percentiles",
                         .curve = {{0.0, 1.0}, {0.3, 0.3}},
                         .style = SeriesStyle::Band,
                         .upper = {{0.0, 1.0}, {0.5, 0.5}}});
  write_plot(folder / "a.png", plot);
  const Picture picture = read_picture(folder / "a.png");
  EXPECT_GT(picture.count(0xc4e5f8, 0, 0, 900, 600, 4), 40000U);  // about a fifth of the axes' area
  // The line crosses the band and is not hidden by it: it has pixels in every 50 columns.
  for (int x = 150; x < 800; x += 50) EXPECT_GT(picture.count(kBlue, x, 0, x + 50, 600), 50U) << x;
}

TEST(WritePlot, BreaksLinesAtGaps) {
  const TemporaryFolder folder;
  Plot plot = line_plot();
  plot.legend = LegendPosition::None;
  plot.series = {
      {.label = "",
       .curve = {{0.0, 1.0, 2.0, 3.0, 4.0, 5.0}, {1.0, 1.0, std::nan(""), std::nan(""), 1.0, 1.0}}}};
  write_plot(folder / "a.png", plot);
  const Picture picture = read_picture(folder / "a.png");
  EXPECT_GT(picture.count(kBlue, 90, 0, 220, 600), 100U);
  EXPECT_EQ(picture.count(kBlue, 300, 0, 650, 600), 0U);
  EXPECT_GT(picture.count(kBlue, 740, 0, 860, 600), 100U);
}

TEST(WritePlot, HasLogarithmicAxesWithoutWhatTheyCannotShow) {
  const TemporaryFolder folder;
  Plot plot = line_plot();
  plot.x_log = plot.y_log = true;
  plot.series = {
      {.label = "error", .curve = {{0.0, 0.01, 0.02}, {1.0, 0.1, 0.2}}, .style = SeriesStyle::LinePoints}};
  write_plot(folder / "a.png", plot);
  EXPECT_GT(read_picture(folder / "a.png").count(kBlue), 500U);
}

TEST(WritePlot, RefusesAPlotWithoutValues) {
  const TemporaryFolder folder;
  Plot plot = line_plot();
  plot.series[0].curve.y = {std::nan(""), std::nan(""), std::nan("")};
  EXPECT_THAT(error_of<std::invalid_argument>([&] { write_plot(folder / "a.png", plot); }),
              HasSubstr("'Front' has no value"));
  plot.series.clear();
  EXPECT_THROW(write_plot(folder / "a.png", plot), std::invalid_argument);
  EXPECT_EQ(folder.file_count(), 0U);
}

TEST(WritePlot, RefusesABandWithEdgesThatDoNotFit) {
  const TemporaryFolder folder;
  Plot plot = line_plot();
  plot.series.push_back({.label = "band",
                         .curve = {{0.0, 1.0}, {0.0, 0.0}},
                         .style = SeriesStyle::Band,
                         .upper = {{0.0, 0.5}, {1.0, 1.0}}});
  EXPECT_THROW(write_plot(folder / "a.png", plot), std::invalid_argument);
}

TEST(WritePlot, NamesThePackageIfGnuplotIsMissing) {
  const TemporaryFolder folder;
  const PathVariable path(folder.path().string() + "::");
  EXPECT_FALSE(has_gnuplot());
  EXPECT_THAT(error_of<std::runtime_error>([&] { write_plot(folder / "a.png", line_plot()); }),
              HasSubstr("install the package gnuplot-nox"));
}

TEST(WritePlot, ReportsWhatGnuplotSays) {
  const TemporaryFolder folder;
  put_text(folder / "gnuplot", "#!/bin/sh\necho no fonts today >&2\nexit 3\n");
  std::filesystem::permissions(folder / "gnuplot", std::filesystem::perms::owner_all);
  const PathVariable path(folder.path().string());
  EXPECT_THAT(error_of<std::runtime_error>([&] { write_plot(folder / "a.png", line_plot()); }),
              AllOf(HasSubstr("a.png"), HasSubstr("(3)"), HasSubstr("no fonts today")));
  EXPECT_FALSE(std::filesystem::exists(folder / "a.png"));
}

TEST(WritePlot, NamesThePathThatCannotBeWritten) {
  const TemporaryFolder folder;
  EXPECT_THAT(error_of<std::runtime_error>([&] { write_plot(folder / "none" / "a.png", line_plot()); }),
              AllOf(HasSubstr((folder / "none" / "a.png").string()), HasSubstr("No such file")));
}

TEST(WritePlot, TakesTextAndPathsAsTheyAre) {
  const TemporaryFolder folder;
  const std::string mark = (folder / "mark").string();
  const std::vector<std::string> texts{"'; system('touch " + mark + "')",
                                       "\"; !touch " + mark,
                                       "`touch " + mark + "`",
                                       "\n!touch " + mark + "\n",
                                       "' . `touch " + mark + "` . '",
                                       "$(touch " + mark + ")",
                                       "@home _{a} ^b & {/Bold c} %s %d",
                                       "\\",
                                       "it's 'quoted'",
                                       "\xff\xc3",
                                       "'''"};
  for (const std::string& text : texts) {
    Plot plot = line_plot();
    plot.title = plot.x_label = plot.y_label = plot.series[0].label = text;
    write_plot(folder / "| touch mark.png", plot);
    EXPECT_GT(read_picture(folder / "| touch mark.png").count(kBlue), 800U) << text;
    EXPECT_EQ(folder.file_count(), 1U) << text;
    std::filesystem::remove(folder / "| touch mark.png");
  }
  EXPECT_FALSE(std::filesystem::exists("mark.png"));
}

TEST(GnuplotQuoted, HasNothingThatEndsTheString) {
  EXPECT_EQ(gnuplot_quoted("a \"b\" `c`"), "'a \"b\" `c`'");
  EXPECT_EQ(gnuplot_quoted("it's"), "'it\u2019s'");
  EXPECT_EQ(gnuplot_quoted("a\nb\tc"), "'a b c'");
  EXPECT_EQ(gnuplot_quoted("\xc3\xa9 \xc3 \xff \u221a"), "'\u00e9 ? ? \u221a'");
}

TEST(WritePlots, DrawsEveryPanelWithCommonLooks) {
  const TemporaryFolder folder;
  std::vector<Plot> plots(4, line_plot());
  for (Plot& plot : plots) {
    plot.series.push_back({.label = "theory", .curve = {{0.0, 1.0}, {0.5, 0.5}}, .style = SeriesStyle::Line});
  }
  write_plots(folder / "a.png", "Four panels", plots, 2, {800, 800});
  const Picture picture = read_picture(folder / "a.png");
  EXPECT_EQ(picture.width, 800);
  EXPECT_EQ(picture.height, 800);
  for (const int left : {0, 400}) {
    for (const int top : {40, 400}) {
      EXPECT_GT(picture.count(kBlue, left, top, left + 400, top + 320), 250U) << left << ' ' << top;
      EXPECT_GT(picture.count(kVermilion, left, top, left + 400, top + 320), 250U) << left << ' ' << top;
    }
  }
  EXPECT_GT(picture.count(kBlue, 0, 760, 800, 800), 20U);  // the legend
  EXPECT_THROW(write_plots(folder / "a.png", "", {}, 2), std::invalid_argument);
}

TEST(PlotAxes, LeaveRoomAndKeepZero) {
  Plot plot = line_plot();
  plot.series[0].curve = {{2.0, 4.0}, {0.0, 10.0}};
  const PlotAxes axes = plot_axes(plot);
  EXPECT_EQ(axes.x.least, 2.0);
  EXPECT_EQ(axes.x.most, 4.0);
  EXPECT_EQ(axes.y.least, 0.0);
  EXPECT_GT(axes.y.most, 10.0);
  EXPECT_LT(axes.y.most, 11.0);
}

TEST(PlotAxes, TakeWhatIsVisibleInTheRangeAskedFor) {
  Plot plot = line_plot();
  plot.series[0].curve = {{0.0, 1.0, 2.0}, {1.0, 2.0, 900.0}};
  plot.x_range = PlotRange{0.0, 1.5};
  EXPECT_LT(plot_axes(plot).y.most, 3.0);
  plot.y_range = PlotRange{-5.0, 5.0};
  EXPECT_EQ(plot_axes(plot).y.least, -5.0);
}

TEST(PlotAxes, HaveAWidthForAConstant) {
  Plot plot = line_plot();
  plot.series[0].curve = {{1.0, 1.0}, {3.0, 3.0}};
  const PlotAxes axes = plot_axes(plot);
  EXPECT_LT(axes.x.least, axes.x.most);
  EXPECT_LT(axes.y.least, 3.0);
  EXPECT_GT(axes.y.most, 3.0);
}

LegendPosition place_of(const Plot& plot) { return legend_position(plot, plot_axes(plot), {}); }

TEST(LegendPosition, IsAFreeCorner) {
  Plot plot = line_plot();
  plot.series[0].curve = {{0.0, 1.0}, {1.0, 0.0}};
  EXPECT_EQ(place_of(plot), LegendPosition::TopRight);
  plot.series[0].curve = {{0.0, 1.0}, {0.0, 1.0}};
  EXPECT_EQ(place_of(plot), LegendPosition::TopLeft);
  plot.series[0].curve = {{0.0, 1.0}, {1.0, 1.0}};
  plot.y_range = PlotRange{0.0, 1.05};
  EXPECT_EQ(place_of(plot), LegendPosition::BottomRight);
  plot.legend = LegendPosition::TopLeft;
  EXPECT_EQ(place_of(plot), LegendPosition::TopLeft);
}

TEST(LegendPosition, IsBelowAFullPlot) {
  Plot plot = line_plot();
  plot.series[0].curve = {};
  for (int k = 0; k <= 40; ++k) plot.series[0].curve.add(0.025 * k, k % 2);
  EXPECT_EQ(place_of(plot), LegendPosition::Below);
  plot.series[0].label = "";
  EXPECT_EQ(place_of(plot), LegendPosition::None);
}

TEST(SeriesLooks, DifferUnlessLabelsAreTheSame) {
  SeriesLooks looks;
  const SeriesLook first = looks.look_of({.label = "a", .curve = {}});
  EXPECT_EQ(first.colour, series_colour(1));
  EXPECT_EQ(looks.look_of({.label = "b", .curve = {}}).colour, series_colour(2));
  EXPECT_EQ(looks.look_of({.label = "a", .curve = {}}).colour, first.colour);
  EXPECT_EQ(looks.look_of({.label = "m", .curve = {}, .style = SeriesStyle::Points}).colour,
            series_colour(0));
  EXPECT_EQ(looks.look_of({.label = "c", .curve = {}, .colour = 5}).colour, series_colour(5));
  EXPECT_EQ(looks.look_of({.label = "d", .curve = {}}).colour, series_colour(3));
}

TEST(SeriesLooks, DashColoursThatComeAgain) {
  SeriesLooks looks;
  for (int k = 0; k < 7; ++k) {
    EXPECT_FALSE(looks.look_of({.label = "first " + std::to_string(k), .curve = {}}).is_repeated);
  }
  const SeriesLook eighth = looks.look_of({.label = "eighth", .curve = {}});
  EXPECT_TRUE(eighth.is_repeated);
  EXPECT_EQ(eighth.colour, series_colour(1));
}

TEST(FittingSize, GivesBothAxesTheSameScale) {
  const AxesRoom room{.left = 100, .right = 100, .above = 50, .below = 50};
  const PictureSize wide = fitting_size({0.0, 4.0}, {1.0, 2.0}, 1000, room);
  EXPECT_EQ(wide.width, 1000);
  EXPECT_EQ(wide.height, 200 + 100);
  // 800 by 1600 would be too high: 300 by 600.
  const PictureSize tall = fitting_size({0.0, 1.0}, {0.0, 2.0}, 1000, room);
  EXPECT_EQ(tall.width, 300 + 200);
  EXPECT_EQ(tall.height, 600 + 100);
}

TEST(MarkStep, IsRoundAndLeavesRoomForTheNumbers) {
  EXPECT_DOUBLE_EQ(mark_step({0.0, 1.0}, 640.0), 0.1);
  EXPECT_DOUBLE_EQ(mark_step({0.0, 1.0}, 400.0), 0.2);
  EXPECT_DOUBLE_EQ(mark_step({0.0, 0.15}, 240.0), 0.05);
  EXPECT_DOUBLE_EQ(mark_step({-100.0, 800.0}, 640.0), 100.0);
  EXPECT_DOUBLE_EQ(mark_step({0.0, 1.0}, 80.0), 1.0);
}

TEST(WritePlot, OfEqualAspectCanFitItsRanges) {
  const TemporaryFolder folder;
  Plot plot = line_plot();
  plot.equal_aspect = true;
  plot.x_range = PlotRange{0.0, 2.0};
  plot.y_range = PlotRange{0.0, 1.0};
  write_plot(folder / "a.png", plot, {900, 0});
  const Picture picture = read_picture(folder / "a.png");
  EXPECT_EQ(picture.width, 900);
  EXPECT_NEAR(picture.height, 0.5 * (900 - 126) + 124, 2.0);
}

FieldPlot slope_field() {
  FieldPlot plot{.title = "Pressure", .x_label = "x [m]", .y_label = "z [m]", .value_label = "p [Pa]"};
  plot.grid = {.origin_x = 0.05, .origin_y = 0.05, .spacing = 0.1, .columns = 20, .rows = 10, .values = {}};
  for (std::size_t j = 0; j < 10; ++j) {
    for (std::size_t i = 0; i < 20; ++i) {
      plot.grid.values.push_back(i < 10 ? static_cast<double>(i) : std::nan(""));
    }
  }
  plot.levels = {4.5};
  return plot;
}

TEST(WriteFieldPlot, FillsCellsWithColourAndLeavesThoseWithoutValueEmpty) {
  const TemporaryFolder folder;
  write_field_plot(folder / "a.png", slope_field());
  const Picture picture = read_picture(folder / "a.png");
  EXPECT_EQ(picture.width, 900);
  // 640 pixels for 2 m, so 320 for 1 m, and the room around the axes.
  EXPECT_NEAR(picture.height, 320 + 112, 2);
  EXPECT_GT(picture.count(0x440154, 110, 60, 128, 350), 4000U);        // dark at the left
  EXPECT_GT(picture.count(0xfde725, 395, 60, 415, 350), 4000U);        // bright in the middle
  EXPECT_EQ(picture.count(0xffffff, 430, 60, 730, 350), 300U * 290U);  // nothing at the right
  EXPECT_GT(picture.count(kBlack, 255, 60, 265, 350), 150U);           // the contour line between
}

TEST(WriteFieldPlot, DrawsOutlinesAndTakesRanges) {
  const TemporaryFolder folder;
  FieldPlot plot = slope_field();
  plot.outlines = {{{1.5, 1.5}, {0.0, 1.0}}};
  plot.y_range = PlotRange{0.0, 2.0};
  write_field_plot(folder / "a.png", plot, {600, 500});
  const Picture picture = read_picture(folder / "a.png");
  EXPECT_EQ(picture.width, 600);
  EXPECT_EQ(picture.height, 500);
  EXPECT_GT(picture.count(0x404040, 330, 200, 400, 500), 100U);
}

TEST(WriteFieldPlot, RefusesAGridThatDoesNotFitItsValues) {
  const TemporaryFolder folder;
  FieldPlot plot = slope_field();
  plot.grid.rows = 9;
  EXPECT_THROW(write_field_plot(folder / "a.png", plot), std::invalid_argument);
  plot.grid.rows = 10;
  plot.grid.values.assign(200, std::nan(""));
  EXPECT_THROW(write_field_plot(folder / "a.png", plot), std::invalid_argument);
}

TEST(WriteScatterPlot, DrawsDiscsOfTheSizeOfParticles) {
  const TemporaryFolder folder;
  ScatterPlot plot{.title = "Particles", .x_label = "x [m]", .y_label = "z [m]", .value_label = "p [Pa]"};
  plot.x = {0.5, 1.5};
  plot.y = {0.5, 0.5};
  plot.value = {0.0, 1.0};
  plot.point_size = 0.5;
  plot.x_range = PlotRange{0.0, 2.0};
  plot.y_range = PlotRange{0.0, 1.0};
  write_scatter_plot(folder / "a.png", plot);
  const Picture picture = read_picture(folder / "a.png");
  // Discs of 160 pixels: 20106 square pixels each.
  EXPECT_NEAR(static_cast<double>(picture.count(0x440154, 101, 50, 420, 360)), 20106.0, 500.0);
  EXPECT_NEAR(static_cast<double>(picture.count(0xfde725, 420, 50, 739, 360)), 20106.0, 500.0);
  plot.value.pop_back();
  EXPECT_THROW(write_scatter_plot(folder / "a.png", plot), std::invalid_argument);
}

}  // namespace
}  // namespace eisph

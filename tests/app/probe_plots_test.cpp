#include "app/view/probe_plots.hpp"

#include "io/temporary_folder.hpp"

#include <cmath>
#include <fstream>
#include <limits>

#include <gmock/gmock.h>

namespace eisph {
namespace {

constexpr double kAlways = std::numeric_limits<double>::infinity();

using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;

TEST(ProbePlots, PutColumnsOfOneUnitTogether) {
  const TableHeader header{"gauge_a", {{"time", "s"}, {"level", "m"}, {"pressure", "Pa"}, {"surface", "m"}}};
  const auto plots = plots_of({header, {{0.0, 1.0}, {0.1, 0.2}, {5.0, 6.0}, {0.3, 0.4}}}, kAlways);
  ASSERT_THAT(plots, SizeIs(2));
  EXPECT_EQ(plots[0].unit, "m");
  EXPECT_THAT(plots[0].x, ElementsAre(0.0, 1.0));
  ASSERT_THAT(plots[0].series, SizeIs(2));
  EXPECT_EQ(plots[0].series[1].name, "surface");
  EXPECT_THAT(plots[0].series[1].values, ElementsAre(0.3, 0.4));
  EXPECT_EQ(plots[1].unit, "Pa");
}

TEST(ProbePlots, KeepPureNumbersApart) {
  const TableHeader header{"ledger", {{"time", "s"}, {"compression_max", "-"}, {"penetrations", "-"}}};
  EXPECT_THAT(plots_of({header, {{0.0, 1.0}, {0.01, 0.02}, {0.0, 3.0}}}, kAlways), SizeIs(2));
}

TEST(ProbePlots, LeaveTablesOutThatHaveSeveralRowsAtATime) {
  const TableHeader header{"classes", {{"time", "s"}, {"class", "-"}}};
  EXPECT_THAT(plots_of({header, {{0.0, 0.0, 1.0}, {1.0, 2.0, 1.0}}}, kAlways), IsEmpty());
  EXPECT_THAT(plots_of({{"no_time", {{"class", "-"}}}, {{1.0}}}, kAlways), IsEmpty());
}

TEST(ProbePlots, ShowALineAtTheTimeOfTheState) {
  const TableHeader header{"line_a", {{"time", "s"}, {"distance", "m"}, {"pressure", "Pa"}}};
  const PlotTable table{header, {{0.0, 0.0, 1.0, 1.0}, {0.0, 0.1, 0.0, 0.1}, {1.0, 2.0, 3.0, 4.0}}};
  const auto first = plots_of(table, 0.5);
  ASSERT_THAT(first, SizeIs(1));
  EXPECT_TRUE(first[0].over_distance);
  EXPECT_EQ(first[0].title, "line_a at 0 s");
  EXPECT_THAT(first[0].x, ElementsAre(0.0, 0.1));
  EXPECT_THAT(first[0].series.at(0).values, ElementsAre(1.0, 2.0));
  EXPECT_THAT(plots_of(table, kAlways).at(0).series.at(0).values, ElementsAre(3.0, 4.0));
  EXPECT_THAT(plots_of({header, {{}, {}, {}}}, kAlways).at(0).x, IsEmpty());
}

TEST(ProbePlots, ReadTheTablesOfARun) {
  const TemporaryFolder folder;
  std::ofstream(folder.path() / "gauge_b.csv") << "time [s],level [m]\n0,0.1\n0.5,\n1,0.3\n";
  std::ofstream(folder.path() / "a_text.csv") << "who,what\nwater,falls\n";
  std::ofstream(folder.path() / "run.log") << "nothing\n";
  const auto plots = plots_of(read_plot_tables(folder.path()), kAlways);
  ASSERT_THAT(plots, SizeIs(1));
  EXPECT_EQ(plots[0].title, "gauge_b");
  EXPECT_THAT(plots[0].x, ElementsAre(0.0, 0.5, 1.0));
  EXPECT_TRUE(std::isnan(plots[0].series.at(0).values.at(1)));
}

TEST(PlotTables, GrowRowByRow) {
  PlotTables tables;
  const std::size_t table = tables.open_table({"front", {{"time", "s"}, {"front", "m"}}});
  EXPECT_THAT(*tables.plots(), IsEmpty());
  const double row[] = {0.5, 1.25};
  tables.append_row(table, row);
  const auto plots = tables.plots();
  ASSERT_THAT(*plots, SizeIs(1));
  EXPECT_THAT(plots->front().series.front().values, ElementsAre(1.25));
}

}  // namespace
}  // namespace eisph

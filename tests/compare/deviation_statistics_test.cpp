#include "compare/deviation_statistics.hpp"

#include "compare/reference_table.hpp"
#include "core/error.hpp"
#include "io/temporary_folder.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace eisph {
namespace {

using testing::HasSubstr;

DepthGrid grid_of(std::size_t columns, std::size_t rows, std::vector<float> depth) {
  DepthGrid grid;
  grid.cell_size = 0.1;
  grid.columns = columns;
  grid.rows = rows;
  grid.depth = std::move(depth);
  return grid;
}

TEST(DeviationStatistics, OfAFewCells) {
  DeviationSamples samples;
  const DepthGrid simulation = grid_of(3, 2, {0.10F, 0.02F, 0.0F, 0.05F, 0.004F, 0.9F});
  const DepthGrid photograph = grid_of(3, 2, {0.08F, 0.03F, 0.0F, 0.001F, 0.02F, 0.0F});
  add_samples(samples, simulation, photograph, {1, 1, 1, 1, 1, 0}, 0.005, false);
  const DeviationStatistics s = deviation_statistics(samples, 0.005);
  EXPECT_EQ(s.points, 5U);
  EXPECT_NEAR(s.maximum, 0.049, 1e-7);  // deviations 0.02, -0.01, 0, 0.049, -0.016
  EXPECT_NEAR(s.minimum, -0.016, 1e-7);
  EXPECT_NEAR(s.mean, 0.043 / 5.0, 1e-7);
  EXPECT_NEAR(s.median, 0.0, 1e-7);
  EXPECT_NEAR(s.percentile_15, -0.0124, 1e-7);  // 0.6 of the way from -0.016 to -0.010
  EXPECT_NEAR(s.percentile_85, 0.0316, 1e-7);   // 0.4 of the way from 0.020 to 0.049
  EXPECT_NEAR(s.rms, std::sqrt((0.0004 + 0.0001 + 0.002401 + 0.000256) / 5.0), 1e-7);
  EXPECT_NEAR(s.standard_deviation, std::sqrt(s.rms * s.rms - s.mean * s.mean), 1e-9);
  EXPECT_NEAR(s.wetted_overlap, 2.0 / 4.0, 1e-12);
}

TEST(DeviationStatistics, ShallowCellsMayCountAsDry) {
  DeviationSamples samples;
  add_samples(samples, grid_of(2, 1, {0.004F, 0.01F}), grid_of(2, 1, {0.003F, 0.002F}), {1, 1}, 0.005, true);
  EXPECT_EQ(samples.simulation, (std::vector<float>{0.0F, 0.01F}));
  EXPECT_EQ(samples.photograph, (std::vector<float>{0.0F, 0.0F}));
}

TEST(DeviationStatistics, CorrelationIsThatOfTheDepths) {
  DeviationSamples samples;
  for (int k = 0; k < 20; ++k) {
    samples.simulation.push_back(0.01F * static_cast<float>(k));
    samples.photograph.push_back(0.3F - 0.02F * static_cast<float>(k));
  }
  EXPECT_NEAR(deviation_statistics(samples, 0.0).correlation, -1.0, 1e-6);
  std::fill(samples.photograph.begin(), samples.photograph.end(), 0.1F);
  EXPECT_TRUE(std::isnan(deviation_statistics(samples, 0.0).correlation));
}

TEST(DeviationClasses, HoldEveryPointOnceFromLeastToLargest) {
  DeviationSamples samples;
  for (int k = 0; k <= 100; ++k) {
    samples.simulation.push_back(0.001F * static_cast<float>(k));
    samples.photograph.push_back(0.05F);
  }
  const auto classes = deviation_classes(samples, 10);
  ASSERT_EQ(classes.size(), 10U);
  std::size_t all = 0;
  for (const DeviationClass& one : classes) all += one.count;
  EXPECT_EQ(all, 101U);
  EXPECT_NEAR(classes[0].centre, -0.045, 1e-7);
  EXPECT_NEAR(classes[9].centre, 0.045, 1e-7);
  EXPECT_NEAR(classes[9].cumulative_share, 1.0, 1e-12);
  const auto narrow = deviation_classes(samples, 4, std::pair{-0.02, 0.02});
  EXPECT_NEAR(narrow[1].centre, -0.005, 1e-12);
  EXPECT_LE(narrow[0].count + narrow[1].count + narrow[2].count + narrow[3].count, 41U);
}

/// A table of the thesis with the statistics that it prints beside it, m.
struct PrintedTable {
  const char* name;
  std::size_t points;
  double median;
  double percentile_15;
  double percentile_85;
};

TEST(DeviationClasses, ReproduceTheTablesOfTheThesis) {
  // Tables 2 and 4. The mean of repeated measurements is printed there, classes are those of one.
  for (const PrintedTable& printed :
       {PrintedTable{"thesis_deviation_144k", 47200, -0.00168, -0.01842, 0.00840},
        PrintedTable{"thesis_deviation_576k", 188800, -0.00263, -0.00489, 0.00237}}) {
    const ReferenceTable table = reference_table(printed.name);
    std::vector<std::size_t> counts;
    for (const double count : table.column("count")) counts.push_back(static_cast<std::size_t>(count));
    const auto classes = classes_from_counts(table.column("deviation"), counts);
    ASSERT_EQ(classes.size(), 60U);
    for (std::size_t k = 0; k < classes.size(); ++k) {
      EXPECT_NEAR(classes[k].share, table.column("share")[k], 1.01e-5) << printed.name << " class " << k;
      EXPECT_NEAR(classes[k].cumulative_share, table.column("cumulative_share")[k], 1.01e-5)
          << printed.name << " class " << k;
    }
    const std::size_t points = std::accumulate(counts.begin(), counts.end(), std::size_t{0});
    EXPECT_EQ(points, printed.points);
    const double width = classes[1].centre - classes[0].centre;
    EXPECT_NEAR(percentile_of_classes(classes, 0.5), printed.median, width);
    EXPECT_NEAR(percentile_of_classes(classes, 0.15), printed.percentile_15, width);
    EXPECT_NEAR(percentile_of_classes(classes, 0.85), printed.percentile_85, width);
  }
}

TEST(FrontDistance, IsOfTheForemostCellsAndByRows) {
  const DepthGrid simulation = grid_of(5, 2, {1, 1, 1, 1, 0, 1, 1, 0, 0, 0});
  const DepthGrid photograph = grid_of(5, 2, {1, 1, 0, 0, 0, 1, 1, 1, 0, 0});
  const FrontDistance distance =
      front_distance(simulation, photograph, std::vector<std::uint8_t>(10, 1), 0.005);
  EXPECT_NEAR(distance.foremost, 0.1, 1e-12);
  EXPECT_NEAR(distance.rms, 0.1 * std::sqrt((4.0 + 1.0) / 2.0), 1e-12);
  EXPECT_EQ(distance.rows, 2U);
  const DepthGrid with_a_drop = grid_of(5, 2, {1, 1, 0, 0, 1, 1, 1, 1, 0, 0});
  EXPECT_NEAR(front_distance(simulation, with_a_drop, std::vector<std::uint8_t>(10, 1), 0.005).foremost, 0.1,
              1e-12);
  const FrontDistance none = front_distance(simulation, grid_of(5, 2, std::vector<float>(10, 0.0F)),
                                            std::vector<std::uint8_t>(10, 1), 0.005);
  EXPECT_TRUE(std::isnan(none.foremost));
  EXPECT_EQ(none.rows, 0U);
}

TEST(Mirrored, CompletesAHalfAboveOrBelow) {
  DepthGrid half = grid_of(2, 2, {1, 2, 3, 4});
  const DepthGrid whole = mirrored(half, 0.2);
  EXPECT_EQ(whole.rows, 4U);
  EXPECT_EQ(whole.depth, (std::vector<float>{1, 2, 3, 4, 3, 4, 1, 2}));
  EXPECT_DOUBLE_EQ(whole.origin_y, 0.0);
  const DepthGrid below = mirrored(half, 0.0);
  EXPECT_EQ(below.depth, (std::vector<float>{3, 4, 1, 2, 1, 2, 3, 4}));
  EXPECT_DOUBLE_EQ(below.origin_y, -0.2);
  EXPECT_THAT(error_of<InputError>([&] { (void)mirrored(half, 0.17); }), HasSubstr("plane of symmetry"));
}

TEST(DeviationFiles, HaveTheThesissColumns) {
  const TemporaryFolder folder;
  write_deviation_classes(folder / "classes.csv", classes_from_counts({-0.1, 0.1}, {1, 3}));
  EXPECT_EQ(text_of(folder / "classes.csv"),
            "deviation [m],count [-],share [-],cumulative_share [-]\n-0.1,1,0.25,0.25\n0.1,3,0.75,1\n");
  DeviationStatistics statistics;
  statistics.points = 7;
  statistics.mean = -0.001;
  write_deviation_statistics(folder / "statistics.csv", {{"surface, kept", statistics}});
  EXPECT_THAT(text_of(folder / "statistics.csv"), HasSubstr("\"surface, kept\",7,0,0,-0.001,"));
}

}  // namespace
}  // namespace eisph

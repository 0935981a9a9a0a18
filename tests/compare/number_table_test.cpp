#include "compare/number_table.hpp"

#include "compare/reference_table.hpp"
#include "core/assets.hpp"
#include "core/error.hpp"
#include "io/temporary_folder.hpp"

#include <cmath>
#include <limits>
#include <numeric>

#include <fmt/format.h>
#include <gmock/gmock.h>

namespace eisph {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::Gt;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::IsNan;
using ::testing::Not;

class NumberTableFile : public ::testing::Test {
 protected:
  std::filesystem::path file(const std::string& text) const {
    put_text(folder_ / "a.csv", text);
    return folder_ / "a.csv";
  }
  std::string error(const std::string& text) const {
    const std::filesystem::path path = file(text);
    return error_of<InputError>([&] { (void)read_number_table(path); });
  }
  std::string reference_error(const std::string& text) const {
    const std::filesystem::path path = file(text);
    return error_of<InputError>([&] { (void)read_reference_table(path); });
  }

  TemporaryFolder folder_;
};

TEST_F(NumberTableFile, HasNamesUnitsAndValues) {
  const NumberTable table = read_number_table(file("time [s],\"p, bed [Pa]\",share\n0,1e3,-0.5\n0.25,2,3\n"));
  EXPECT_THAT(table.names, ElementsAre("time", "p, bed", "share"));
  EXPECT_THAT(table.units, ElementsAre("s", "Pa", ""));
  EXPECT_EQ(table.rows(), 2U);
  EXPECT_THAT(table.column("p, bed"), ElementsAre(1000.0, 2.0));
  EXPECT_THAT(table.comments, IsEmpty());
}

TEST_F(NumberTableFile, HasGapsWhereFieldsAreEmpty) {
  const NumberTable table = read_number_table(file("time [s],level [m]\n0,\n1,0.5\n"));
  EXPECT_THAT(table.column("level"), ElementsAre(IsNan(), 0.5));
}

TEST_F(NumberTableFile, GivesACurveInOtherUnits) {
  const NumberTable table = read_number_table(file("# about\n\ntime [s],level [m]\r\n2,0.5\r\n1,0.25\r\n"));
  const Curve curve = table.curve("time", "level", 10.0, 100.0);
  EXPECT_THAT(curve.x, ElementsAre(10.0, 20.0));
  EXPECT_THAT(curve.y, ElementsAre(25.0, 50.0));
}

TEST_F(NumberTableFile, NamesWhatIsWrong) {
  EXPECT_THAT(error("time [s],level [m]\n0,1\n1\n"),
              AllOf(HasSubstr("a.csv:3: 1 fields"), HasSubstr("2 columns")));
  EXPECT_THAT(error("# one\ntime [s],level [m]\n0,1\n1,2,3\n"), HasSubstr("a.csv:4: 3 fields"));
  EXPECT_THAT(error("time [s],level [m]\n0,wet\n"),
              AllOf(HasSubstr("a.csv:2"), HasSubstr("'level'"), HasSubstr("'wet'")));
  EXPECT_THAT(error("time [s],level [m]\n0,1.5m\n"), HasSubstr("'1.5m' is not a number"));
  EXPECT_THAT(error("# only a comment\n"), HasSubstr("no header"));
  EXPECT_THAT(error_of<InputError>([&] { (void)read_number_table(folder_ / "none.csv"); }),
              AllOf(HasSubstr("none.csv"), HasSubstr("No such file")));
}

TEST_F(NumberTableFile, NamesTheColumnsThatThereAre) {
  const NumberTable table = read_number_table(file("time [s],level [m]\n0,1\n"));
  EXPECT_THAT(error_of<InputError>([&] { (void)table.column("depth"); }),
              AllOf(HasSubstr("a.csv"), HasSubstr("'depth'"), HasSubstr("time, level")));
}

TEST_F(NumberTableFile, OfAReferenceHasACitation) {
  const ReferenceTable table =
      read_reference_table(file("# Ann (1952), On dams\n# units\nx [m],z [m]\n1,2\n"));
  EXPECT_EQ(table.citation, "Ann (1952), On dams");
  EXPECT_THAT(table.notes, ElementsAre("units"));
  EXPECT_THAT(reference_error("x [m],z [m]\n1,2\n"), HasSubstr("no citation"));
}

TEST_F(NumberTableFile, OfAReferenceHasNoGaps) {
  EXPECT_THAT(reference_error("# Ann\nx [m],z [m]\n1,2\n3,\n"),
              AllOf(HasSubstr("a.csv:4"), HasSubstr("'z'"), HasSubstr("'' is not a number")));
  EXPECT_THAT(reference_error("# Ann\nx [m],z [m]\n1,nan\n"), HasSubstr("'nan' is not a number"));
  EXPECT_THAT(reference_error("# Ann\nx [m],z [m]\n"), HasSubstr("no rows"));
}

TEST(ReferenceTable, IsFoundByName) {
  const ReferenceTable front = reference_table("martin_moyce_front_n2_2");
  EXPECT_THAT(front.citation, HasSubstr("Martin & Moyce (1952)"));
  EXPECT_EQ(front.rows(), 15U);
  EXPECT_EQ(front.column("scaled_time").front(), 0.41);
  EXPECT_EQ(front.column("scaled_front").back(), 4.11);
  EXPECT_THAT(error_of<InputError>([] { (void)reference_table("nobody"); }), HasSubstr("nobody.csv"));
}

TEST(ReferenceTable, OfAFreeSurfaceIsInMetres) {
  const ReferenceTable surface = reference_table("janosi_d38_t156");
  EXPECT_EQ(surface.units, (std::vector<std::string>{"m", "m"}));
  EXPECT_EQ(surface.column("x").front(), 0.37897);
  EXPECT_EQ(surface.column("z").back(), 0.04443);
}

TEST(ReferenceTable, OfTheBandHasItsEdgesAroundTheMedian) {
  const ReferenceTable band = reference_table("lobovsky_h300_pressure_s2_band");
  for (std::size_t k = 0; k < band.rows(); ++k) {
    EXPECT_LE(band.column("lower_pressure")[k], band.column("median_pressure")[k]) << k;
    EXPECT_LE(band.column("median_pressure")[k], band.column("upper_pressure")[k]) << k;
  }
}

TEST(ReferenceTable, IsCompleteForEveryFile) {
  std::size_t files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(home_folder() / "assets" / "reference")) {
    const ReferenceTable table = read_reference_table(entry.path());
    EXPECT_THAT(table.citation, HasSubstr("(")) << entry.path();
    EXPECT_THAT(table.notes, Not(IsEmpty())) << entry.path();
    for (const std::string& unit : table.units) {
      EXPECT_THAT(unit, ::testing::AnyOf("-", "m", "s", "Pa", "N")) << entry.path();
    }
    EXPECT_THAT(table.rows(), Gt(7U)) << entry.path();
    ++files;
  }
  EXPECT_EQ(files, 29U);
}

TEST(ReferenceTable, OfTheBlockPushesLessTowardsItsTopAndAddsUpToItsForce) {
  const ReferenceTable block = reference_table("block_impact_pressure");
  constexpr double kSquare = 0.04 * 0.04;  // m^2
  double push = 0.0;
  for (int column = 1; column <= 3; ++column) {
    double below = std::numeric_limits<double>::infinity();
    for (int row = 1; row <= 4; ++row) {
      const std::vector<double>& pressure = block.column(fmt::format("p{}_{}", row, column));
      const double sum = std::accumulate(pressure.begin(), pressure.end(), 0.0);
      EXPECT_LT(sum, below) << row << ", " << column;
      EXPECT_GT(sum, 0.0) << row << ", " << column;
      below = sum;
      push += sum * kSquare;
    }
  }
  const std::vector<double>& along = block.column("force_x");
  const double force = std::accumulate(along.begin(), along.end(), 0.0);
  EXPECT_NEAR(push / force, 1.0, 0.02) << "there is hardly any pressure on the back";
}

TEST(ReferenceTable, OfTheThesisSumsItsShares) {
  for (const char* name : {"thesis_deviation_144k", "thesis_deviation_576k"}) {
    const ReferenceTable table = reference_table(name);
    double sum = 0.0;
    for (std::size_t k = 0; k < table.rows(); ++k) {
      sum += table.column("share")[k];
      EXPECT_NEAR(table.column("cumulative_share")[k], sum, 3e-4) << name << " row " << k;
    }
    EXPECT_NEAR(sum, 1.0, 3e-4);
  }
}

}  // namespace
}  // namespace eisph

#include "io/csv_table.hpp"

#include "core/error.hpp"
#include "io/temporary_folder.hpp"

#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <random>

#include <gmock/gmock.h>

namespace eisph {
namespace {

using testing::AllOf;
using testing::HasSubstr;

const std::vector<TableColumn> kColumns{{"time", "s"}, {"level", "m"}};

TEST(CsvTable, StartsWithNamesAndUnits) {
  const TemporaryFolder folder;
  const CsvTable table(folder / "a.csv", kColumns);
  EXPECT_EQ(text_of(folder / "a.csv"), "time [s],level [m]\n");
}

TEST(CsvTable, HasEveryRowInTheFileAsSoonAsItIsAppended) {
  const TemporaryFolder folder;
  CsvTable table(folder / "a.csv", kColumns);
  table.append(std::array{0.0, 0.15});
  EXPECT_EQ(text_of(folder / "a.csv"), "time [s],level [m]\n0,0.15\n");
  table.append(std::array{0.1, 1e-7});
  EXPECT_EQ(text_of(folder / "a.csv"), "time [s],level [m]\n0,0.15\n0.1,1e-07\n");
}

TEST(CsvTable, LeavesAFieldEmptyWhereThereIsNoValue) {
  const TemporaryFolder folder;
  CsvTable table(folder / "a.csv", {{"time", "s"}, {"p", "Pa"}, {"u", "m/s"}});
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  table.append(std::array{0.5, kNone, kNone});
  EXPECT_EQ(text_of(folder / "a.csv"), "time [s],p [Pa],u [m/s]\n0.5,,\n");
}

TEST(CsvTable, GivesBackTheSameBits) {
  const TemporaryFolder folder;
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> exponent(-300.0, 300.0);
  std::vector<double> values{0.1 + 0.2, -0.0, 5e-324, 1.7976931348623157e308, 9007199254740993.0};
  for (int k = 0; k < 1000; ++k) values.push_back(std::pow(10.0, exponent(random)));
  CsvTable table(folder / "a.csv", {{"value", "-"}});
  for (const double value : values) table.append(std::array{value});

  std::ifstream file(folder / "a.csv");
  std::string line;
  std::getline(file, line);
  for (const double value : values) {
    ASSERT_TRUE(std::getline(file, line));
    const double read = std::strtod(line.c_str(), nullptr);
    EXPECT_EQ(read, value);
    EXPECT_EQ(std::signbit(read), std::signbit(value));
  }
  EXPECT_FALSE(std::getline(file, line));
}

TEST(CsvTable, QuotesNamesThatHoldASeparator) {
  const TemporaryFolder folder;
  const CsvTable table(folder / "a.csv", {{"p, \"bed\"", "Pa"}});
  EXPECT_EQ(text_of(folder / "a.csv"), "\"p, \"\"bed\"\" [Pa]\"\n");
}

TEST(CsvTable, RefusesARowOfAnotherLength) {
  const TemporaryFolder folder;
  CsvTable table(folder / "a.csv", kColumns);
  EXPECT_THROW(table.append(std::array{1.0}), std::invalid_argument);
  EXPECT_EQ(text_of(folder / "a.csv"), "time [s],level [m]\n");
}

TEST(CsvTable, NamesThePathThatCannotBeWritten) {
  const TemporaryFolder folder;
  put_text(folder / "file", "");
  EXPECT_THAT(error_of<std::runtime_error>([&] { CsvTable(folder / "file" / "a.csv", kColumns); }),
              AllOf(HasSubstr((folder / "file" / "a.csv").string()), HasSubstr("Not a directory")));
  EXPECT_THAT(error_of<std::runtime_error>([&] { CsvTable("/dev/full", kColumns); }),
              AllOf(HasSubstr("/dev/full"), HasSubstr("No space left")));
}

TEST(CsvFolder, WritesOneFilePerTable) {
  const TemporaryFolder folder;
  CsvFolder tables(folder / "gauges");
  EXPECT_FALSE(std::filesystem::exists(folder / "gauges"));
  const std::size_t gauge = tables.open_table({"gauge_wall", kColumns});
  const std::size_t edge = tables.open_table({"leading_edge", {{"time", "s"}, {"front", "m"}}});
  tables.append_row(edge, std::array{0.5, 1.25});
  tables.append_row(gauge, std::array{0.5, 0.125});
  EXPECT_EQ(text_of(folder / "gauges" / "gauge_wall.csv"), "time [s],level [m]\n0.5,0.125\n");
  EXPECT_EQ(text_of(folder / "gauges" / "leading_edge.csv"), "time [s],front [m]\n0.5,1.25\n");
}

TEST(CsvFolder, KeepsFilesInTheFolderWhateverATableIsCalled) {
  const TemporaryFolder folder;
  CsvFolder tables(folder.path());
  tables.open_table({"gauge_../a b", kColumns});
  EXPECT_TRUE(std::filesystem::exists(folder / "gauge_.._a_b.csv"));
}

TEST(CsvFolder, RefusesTwoTablesForOneFile) {
  const TemporaryFolder folder;
  CsvFolder tables(folder.path());
  tables.open_table({"gauge_a b", kColumns});
  EXPECT_THAT(error_of<InputError>([&] {
                tables.open_table({"gauge_a_b", kColumns});
              }),
              AllOf(HasSubstr("'gauge_a b'"), HasSubstr("'gauge_a_b'"), HasSubstr("gauge_a_b.csv")));
}

}  // namespace
}  // namespace eisph

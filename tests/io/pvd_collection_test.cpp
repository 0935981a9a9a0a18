#include "io/pvd_collection.hpp"

#include "core/error.hpp"
#include "io/temporary_folder.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>

namespace eisph {
namespace {

using testing::AllOf;
using testing::HasSubstr;

TEST(PvdCollection, IsCompleteAfterEveryFile) {
  const TemporaryFolder folder;
  PvdCollection collection(folder / "particles.pvd");
  for (std::size_t k = 0; k < 20; ++k) {
    collection.add(0.1 * static_cast<double>(k), folder / "particles" / fmt::format("{:04}.vtp", k));
    const std::vector<PvdEntry> entries = read_pvd(folder / "particles.pvd");
    ASSERT_EQ(entries.size(), k + 1);
    EXPECT_EQ(entries.back().time, 0.1 * static_cast<double>(k));  // to the bit: 0.30000000000000004
    EXPECT_EQ(entries.back().file, folder / "particles" / fmt::format("{:04}.vtp", k));
  }
  EXPECT_EQ(folder.file_count(), 1U);
}

TEST(PvdCollection, NamesFilesRelativeToItsFolder) {
  const TemporaryFolder folder;
  PvdCollection(folder / "a.pvd").add(0.4, folder / "particles" / "0.vtp");
  EXPECT_EQ(text_of(folder / "a.pvd"),
            "<?xml version=\"1.0\"?>\n"
            "<VTKFile type=\"Collection\" version=\"1.0\" byte_order=\"LittleEndian\">\n"
            "  <Collection>\n"
            "    <DataSet timestep=\"0.4\" part=\"0\" file=\"particles/0.vtp\"/>\n"
            "  </Collection>\n"
            "</VTKFile>\n");
}

TEST(PvdCollection, KeepsNamesWithCharactersOfXml) {
  const TemporaryFolder folder;
  const std::string name = "a & \"b\" <c> d.vtp";
  PvdCollection(folder / "a.pvd").add(0.0, folder / name);
  EXPECT_EQ(read_pvd(folder / "a.pvd").front().file, folder / name);
}

TEST(PvdCollection, NamesThePathThatCannotBeWritten) {
  const TemporaryFolder folder;
  const auto path = folder / "missing" / "a.pvd";
  EXPECT_THAT(error_of<std::runtime_error>([&] { PvdCollection(path).add(0.0, folder / "0.vtp"); }),
              HasSubstr(path.string()));
}

TEST(ReadPvd, RefusesWhatIsNoCollection) {
  const TemporaryFolder folder;
  const auto path = folder / "a.pvd";
  const auto error = [&](const std::string& text) {
    put_text(path, text);
    return error_of<InputError>([&] { (void)read_pvd(path); });
  };
  PvdCollection(path).add(0.5, folder / "0.vtp");
  const std::string good = text_of(path);
  EXPECT_EQ(error(good), "");
  EXPECT_THAT(error(good.substr(0, good.size() / 2)), HasSubstr(path.string()));
  EXPECT_THAT(error(""), HasSubstr(path.string()));
  EXPECT_THAT(error("<VTKFile/>"), HasSubstr("no element Collection"));
  EXPECT_THAT(error("<VTKFile><Collection><DataSet timestep=\"1s\" file=\"a\"/></Collection></VTKFile>"),
              AllOf(HasSubstr("timestep = '1s'"), HasSubstr("must be a number")));
  EXPECT_THAT(error("<VTKFile><Collection><DataSet timestep=\"1\"/></Collection></VTKFile>"),
              HasSubstr("no file"));
}

TEST(ReadPvd, RefusesAMissingFile) {
  const TemporaryFolder folder;
  EXPECT_THAT(error_of<InputError>([&] { (void)read_pvd(folder / "none.pvd"); }),
              HasSubstr((folder / "none.pvd").string()));
}

}  // namespace
}  // namespace eisph

#include "io/file_io.hpp"

#include "core/error.hpp"
#include "io/temporary_folder.hpp"

#include <gmock/gmock.h>

namespace eisph {
namespace {

using testing::AllOf;
using testing::HasSubstr;

TEST(WriteFileAtomically, ReplacesTheContentAndLeavesNothingElse) {
  const TemporaryFolder folder;
  write_file_atomically(folder / "a.txt", "first, and longer");
  const std::string bytes("second\0\n\xff", 9);
  write_file_atomically(folder / "a.txt", bytes);
  EXPECT_EQ(text_of(folder / "a.txt"), bytes);
  EXPECT_EQ(folder.file_count(), 1U);
}

TEST(WriteFileAtomically, NamesThePathAndTheReasonWhenTheFolderIsMissing) {
  const TemporaryFolder folder;
  const auto path = folder / "missing" / "a.txt";
  EXPECT_THAT(error_of<std::runtime_error>([&] { write_file_atomically(path, "x"); }),
              AllOf(HasSubstr(path.string()), HasSubstr("No such file or directory")));
}

TEST(WriteFileAtomically, KeepsTheOldFileWhenTheDiskIsFull) {
  const TemporaryFolder folder;
  put_text(folder / "a.txt", "old");
  std::filesystem::create_symlink("/dev/full", folder / "a.txt.tmp");
  EXPECT_THAT(error_of<std::runtime_error>([&] { write_file_atomically(folder / "a.txt", "new"); }),
              HasSubstr("No space left"));
  EXPECT_EQ(text_of(folder / "a.txt"), "old");
  EXPECT_EQ(folder.file_count(), 1U);
}

TEST(AtomicFile, LeavesTheTargetAloneWithoutCommit) {
  const TemporaryFolder folder;
  put_text(folder / "a.txt", "old");
  {
    const AtomicFile atomic(folder / "a.txt");
    put_text(atomic.temporary_path(), "new");
    EXPECT_EQ(folder.file_count(), 2U);
  }
  EXPECT_EQ(text_of(folder / "a.txt"), "old");
  EXPECT_EQ(folder.file_count(), 1U);
}

TEST(AtomicFile, ReportsAMissingTemporaryFile) {
  const TemporaryFolder folder;
  AtomicFile atomic(folder / "a.txt");
  EXPECT_THAT(error_of<std::runtime_error>([&] { atomic.commit(); }), HasSubstr((folder / "a.txt").string()));
}

TEST(OutputFile, ShowsWhatWasAppendedAtOnce) {
  const TemporaryFolder folder;
  OutputFile file(folder / "a.txt");
  file.append("one\n");
  EXPECT_EQ(text_of(folder / "a.txt"), "one\n");
  OutputFile moved(std::move(file));
  moved.append("two\n");
  EXPECT_EQ(text_of(folder / "a.txt"), "one\ntwo\n");
}

TEST(ReadFile, ReturnsEveryByte) {
  const TemporaryFolder folder;
  const std::string bytes("\0\r\n\xff z", 6);
  put_text(folder / "a.bin", bytes);
  EXPECT_EQ(read_file(folder / "a.bin"), bytes);
}

TEST(ReadFile, RefusesMissingFilesAndFolders) {
  const TemporaryFolder folder;
  EXPECT_THAT(error_of<InputError>([&] { (void)read_file(folder / "none"); }),
              AllOf(HasSubstr((folder / "none").string()), HasSubstr("No such file")));
  EXPECT_THAT(error_of<InputError>([&] { (void)read_file(folder.path()); }), HasSubstr("directory"));
}

TEST(CreateFolder, MakesFoldersAboveAndAcceptsAnExistingOne) {
  const TemporaryFolder folder;
  create_folder(folder / "a" / "b");
  create_folder(folder / "a" / "b");
  EXPECT_TRUE(std::filesystem::is_directory(folder / "a" / "b"));
}

TEST(CreateFolder, NamesThePathWhereAFileIsInTheWay) {
  const TemporaryFolder folder;
  put_text(folder / "file", "");
  EXPECT_THAT(error_of<std::runtime_error>([&] { create_folder(folder / "file"); }),
              HasSubstr((folder / "file").string()));
  EXPECT_THAT(error_of<std::runtime_error>([&] { create_folder(folder / "file" / "a"); }),
              HasSubstr((folder / "file" / "a").string()));
}

}  // namespace
}  // namespace eisph

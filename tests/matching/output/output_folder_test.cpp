#include "matching/output/output_folder.h"

#include "matching/output/leftovers.h"
#include "matching/output/write_file.h"
#include "base/error.h"
#include "tests/matching/output/temporary_folder.h"

#include <gtest/gtest.h>

namespace shellmatch {
namespace {

using testing::contents_of;
using testing::message_of;
using testing::put;
using testing::TemporaryFolder;
using Names = std::vector<std::string>;

TEST(OutputFolderTest, NothingIsSeenBeforeCommitAndAllOfItAfterwards) {
  const TemporaryFolder tmp;
  OutputFolder out(tmp / "run", false);
  write_file(out.path_of("summary.json"), "{}");
  write_file(out.path_of("pictures/level_03.png"), "p");
  EXPECT_FALSE(std::filesystem::exists(tmp / "run"));
  out.commit();
  EXPECT_EQ(tmp.entries(), (Names{"run", "run/pictures", "run/pictures/level_03.png", "run/summary.json"}));
  EXPECT_EQ(contents_of(tmp / "run/summary.json"), "{}");
  EXPECT_EQ(out.final_path(), std::filesystem::canonical(tmp / "run").string());
}

TEST(OutputFolderTest, WithoutCommitNothingIsLeftNotEvenParents) {
  const TemporaryFolder tmp;
  {
    OutputFolder out(tmp / "a/b/run", false);
    write_file(out.path_of("pictures/x.png"), "x");
  }
  EXPECT_EQ(tmp.entries(), Names{});
  {
    OutputFolder out(tmp / "a/b/run/", false);  // a slash at the end means the same
    write_file(out.path_of("x"), "x");
    out.commit();
  }
  EXPECT_EQ(tmp.entries(), (Names{"a", "a/b", "a/b/run", "a/b/run/x"}));
}

TEST(OutputFolderTest, AFilledFolderIsReplacedOnlyByForceAndOnlyAtCommit) {
  const TemporaryFolder tmp;
  std::filesystem::create_directories(tmp / "run");
  put(tmp / "run/summary.json", "old");
  put(tmp / "run/deformed.ply", "old");
  const std::string message = message_of<InputError>([&] { OutputFolder(tmp / "run", false); });
  EXPECT_NE(message.find("not empty"), std::string::npos) << message;
  EXPECT_NE(message.find("--force"), std::string::npos) << message;

  {
    OutputFolder out(tmp / "run", true);
    write_file(out.path_of("summary.json"), "broken off");
  }
  EXPECT_EQ(tmp.entries(), (Names{"run", "run/deformed.ply", "run/summary.json"}));
  EXPECT_EQ(contents_of(tmp / "run/summary.json"), "old");

  OutputFolder out(tmp / "run", true);
  write_file(out.path_of("summary.json"), "new");
  EXPECT_EQ(contents_of(tmp / "run/summary.json"), "old");
  out.commit();
  EXPECT_EQ(tmp.entries(), (Names{"run", "run/summary.json"}));
  EXPECT_EQ(contents_of(tmp / "run/summary.json"), "new");
}

TEST(OutputFolderTest, ForceReplacesNoFolderThatNoRunHasWritten) {
  const TemporaryFolder tmp;
  std::filesystem::create_directories(tmp / "home");
  put(tmp / "home/thesis.tex", "years of work");
  EXPECT_THROW(OutputFolder(tmp / "home", true), InputError);
  EXPECT_EQ(tmp.entries(), (Names{"home", "home/thesis.tex"}));
}

// Whatever somebody has put beside what a run wrote stays, and is named.
TEST(OutputFolderTest, ForceReplacesNothingThatNoRunHasWritten) {
  struct Case {
    std::string file, told;
  };
  for (const auto& [file, told] : {Case{"thesis.tex", "thesis.tex"}, Case{"run2/summary.json", "run2"},
                                   Case{"pictures/mine.txt", "pictures/mine.txt"},
                                   Case{"pictures/more/level_03.png", "pictures/more"}, Case{"output.png", "output.png"}}) {
    const TemporaryFolder tmp;
    for (const std::string& path : {std::string("summary.json"), std::string("pictures/level_03.png"), file}) {
      const std::filesystem::path whole = std::filesystem::path(tmp / "run") / path;
      std::filesystem::create_directories(whole.parent_path());
      put(whole.string(), "years of work");
    }
    const Names before = tmp.entries();
    const std::string message = message_of<InputError>([&] { OutputFolder(tmp / "run", true); });
    EXPECT_NE(message.find("'" + told + "'"), std::string::npos) << message;
    EXPECT_EQ(tmp.entries(), before);
  }
}

TEST(OutputFolderTest, EmptyFoldersAreFilledAndFilesAreNot) {
  const TemporaryFolder tmp;
  std::filesystem::create_directories(tmp / "run");
  {
    OutputFolder out(tmp / "run", false);
    write_file(out.path_of("a"), "a");
    out.commit();
  }
  EXPECT_EQ(tmp.entries(), (Names{"run", "run/a"}));
  put(tmp / "file", "x");
  EXPECT_THROW(OutputFolder(tmp / "file", true), InputError);
  EXPECT_THROW(OutputFolder("", false), InputError);
  EXPECT_THROW(OutputFolder("/", true), InputError);
}

TEST(OutputFolderTest, ALinkStaysAndWhatItLeadsToIsReplaced) {
  const TemporaryFolder tmp;
  std::filesystem::create_directories(tmp / "disk/run");
  put(tmp / "disk/run/history.csv", "old");
  std::filesystem::create_directory_symlink(tmp / "disk/run", tmp / "run");
  OutputFolder out(tmp / "run", true);
  write_file(out.path_of("history.csv"), "new");
  out.commit();
  EXPECT_TRUE(std::filesystem::is_symlink(tmp / "run"));
  EXPECT_EQ(contents_of(tmp / "disk/run/history.csv"), "new");
}

TEST(OutputFolderTest, WhoComesSecondDoesNotOverwrite) {
  const TemporaryFolder tmp;
  {
    OutputFolder first(tmp / "run", false);
    write_file(first.path_of("summary.json"), "first");
    const std::string message = message_of<InputError>([&] { OutputFolder(tmp / "run", false); });
    EXPECT_NE(message.find("another run is writing there"), std::string::npos) << message;
    std::filesystem::create_directories(tmp / "run");
    put(tmp / "run/summary.json", "of a program that asks for no lock");
    EXPECT_THROW(first.commit(), InputError);
  }
  EXPECT_EQ(tmp.entries(), (Names{"run", "run/summary.json"}));
  EXPECT_EQ(contents_of(tmp / "run/summary.json"), "of a program that asks for no lock");
}

// What a kill leaves: the lock's file without a lock, and the hidden folder.
TEST(OutputFolderTest, LeftoversOfKilledRunsGoAndThoseOfLivingOnesStay) {
  const TemporaryFolder tmp;
  const auto leave = [&] {
    put(tmp / ".run.lock", "");
    std::filesystem::create_directories(tmp / ".run.partial-1/pictures");
    put(tmp / ".run.partial-1/pictures/a.png", "a");
    std::filesystem::create_directories(tmp / ".run.partial-2.old");
    std::filesystem::create_directories(tmp / ".runner.partial-1");
  };
  leave();
  { OutputFolder out(tmp / "run", false); }
  // An earlier result that was about to be replaced is all that there is: it stays.
  EXPECT_EQ(tmp.entries(), (Names{".run.partial-2.old", ".runner.partial-1"}));
  leave();
  {
    OutputFolder living(tmp / "run", false);
    write_file(living.path_of("a"), "a");
    remove_leftovers(tmp / "run");
    EXPECT_THROW(OutputFolder(tmp / "run", false), InputError);
    living.commit();
  }
  EXPECT_EQ(tmp.entries(), (Names{".run.partial-2.old", ".runner.partial-1", "run", "run/a"}));
  remove_leftovers(tmp / "run");
  EXPECT_EQ(tmp.entries(), (Names{".runner.partial-1", "run", "run/a"}));
}

TEST(OutputFolderTest, LeftoversGoForAllNamesInAFolder) {
  const TemporaryFolder tmp;
  put(tmp / ".a.lock", "");
  put(tmp / ".b.c.lock", "");
  std::filesystem::create_directories(tmp / ".b.c.partial-12");
  std::filesystem::create_directories(tmp / ".d.lock.partial-12");
  std::filesystem::create_directories(tmp / ".e.partial-3");
  for (const char* other : {".lock", ".partial-1", ".hidden", "f.lock", "g.partial-1"}) put(tmp / other, "");
  const Names others{".hidden", ".lock", ".partial-1", "f.lock", "g.partial-1"};
  {
    OutputFolder living(tmp / "e", false);
    put(tmp / ".e.partial-3", "of a run that is at work");
    remove_leftovers_in(tmp / "");
    for (const char* name : {".e.lock", ".e.partial-3"}) EXPECT_TRUE(std::filesystem::exists(tmp / name)) << name;
    EXPECT_FALSE(std::filesystem::exists(tmp / ".a.lock"));
  }
  remove_leftovers_in(tmp / "");
  EXPECT_EQ(tmp.entries(), others);
  remove_leftovers_in(tmp / "nowhere");
}

// The file of a lock can be removed by anybody, and the next process then makes another one.
TEST(OutputFolderTest, ALockLeavesTheFileOfItsSuccessor) {
  const TemporaryFolder tmp;
  {
    const FileLock first(tmp / "lock", FileLock::Kind::exclusive);
    std::filesystem::remove(tmp / "lock");
    std::optional<FileLock> second(std::in_place, tmp / "lock", FileLock::Kind::exclusive);
    EXPECT_EQ(second->state(), FileLock::State::held);
    {
      const FileLock third(tmp / "lock", FileLock::Kind::exclusive);
      EXPECT_EQ(third.state(), FileLock::State::taken);
    }
    second.reset();
    put(tmp / "lock", "");
  }
  EXPECT_EQ(tmp.entries(), Names{"lock"});
}

TEST(OutputFolderTest, PlacesThatCannotBeWrittenAreEnvironmentErrors) {
  const TemporaryFolder tmp;
  put(tmp / "file", "x");
  EXPECT_THROW(OutputFolder(tmp / "file/run", false), EnvironmentError);
  if (std::filesystem::exists("/proc/self")) {
    EXPECT_THROW(OutputFolder("/proc/shellmatch/run", false), EnvironmentError);
  }
  EXPECT_EQ(tmp.entries(), Names{"file"});
}

TEST(OutputFolderTest, AFullDiskIsAnEnvironmentErrorThatSaysSo) {
  ASSERT_TRUE(std::filesystem::exists("/dev/full"));
  const std::string message =
      message_of<EnvironmentError>([] { write_file("/dev/full", std::string(100000, 'x')); });
  EXPECT_NE(message.find("make room"), std::string::npos) << message;
}

}  // namespace
}  // namespace shellmatch

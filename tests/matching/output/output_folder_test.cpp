#include "matching/output/output_folder.h"

#include "matching/output/checksum.h"
#include "matching/output/hidden_names.h"
#include "matching/output/leftovers.h"
#include "matching/output/write_file.h"
#include "matching/output/written_files.h"
#include "base/error.h"
#include "base/stop.h"
#include "matching/write_result.h"
#include "tests/matching/output/temporary_folder.h"

#include <gtest/gtest.h>

namespace shellmatch {
namespace {

using testing::contents_of;
using testing::message_of;
using testing::put;
using testing::TemporaryFolder;
using Names = std::vector<std::string>;

// An output folder with these files, as a run leaves it.
void write_output(const std::string& path, const Names& files, const std::string& contents = "old") {
  OutputFolder out(path, false);
  for (const std::string& file : files) write_file(out.path_of(file), contents);
  out.commit();
}

TEST(OutputFolderTest, NothingIsSeenBeforeCommitAndAllOfItAfterwards) {
  const TemporaryFolder tmp;
  OutputFolder out(tmp / "run", false);
  write_file(out.path_of("summary.json"), "{}");
  write_file(out.path_of("pictures/level_03.png"), "p");
  EXPECT_FALSE(std::filesystem::exists(tmp / "run"));
  out.commit();
  EXPECT_EQ(tmp.entries(),
            (Names{"run", "run/files.json", "run/pictures", "run/pictures/level_03.png", "run/summary.json"}));
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
  EXPECT_EQ(tmp.entries(), (Names{"a", "a/b", "a/b/run", "a/b/run/files.json", "a/b/run/x"}));
}

TEST(OutputFolderTest, InputsThatARunWouldReplaceAreRefused) {
  const TemporaryFolder tmp;
  write_output(tmp / "run", {"deformed.ply", "pictures/x.png"});
  put(tmp / "run.ply", "beside it");
  std::filesystem::create_directory_symlink(tmp / "run", tmp / "link");
  const auto message = [&](const std::string& folder, const std::string& input) {
    const std::string inputs[] = {"", tmp / "nothing", input};
    return message_of<InputError>([&] { check_inputs_outlive(folder, inputs); });
  };
  for (const char* inside : {"run/deformed.ply", "run/pictures/x.png", "link/deformed.ply", "run"})
    EXPECT_TRUE(message(tmp / "run", tmp / inside).starts_with(tmp / inside)) << inside;
  EXPECT_NE(message(tmp / "link/", tmp / "run/deformed.ply"), "");
  EXPECT_EQ(message(tmp / "run", tmp / "run.ply"), "");
  EXPECT_EQ(message(tmp / "other", tmp / "run/deformed.ply"), "");
}

TEST(OutputFolderTest, AFilledFolderIsReplacedOnlyByForceAndOnlyAtCommit) {
  const TemporaryFolder tmp;
  write_output(tmp / "run", {"summary.json", "deformed.ply"});
  const std::string message = message_of<InputError>([&] { OutputFolder(tmp / "run", false); });
  EXPECT_NE(message.find("not empty"), std::string::npos) << message;
  EXPECT_NE(message.find("--force"), std::string::npos) << message;

  {
    OutputFolder out(tmp / "run", true);
    write_file(out.path_of("summary.json"), "broken off");
  }
  EXPECT_EQ(tmp.entries(), (Names{"run", "run/deformed.ply", "run/files.json", "run/summary.json"}));
  EXPECT_EQ(contents_of(tmp / "run/summary.json"), "old");

  OutputFolder out(tmp / "run", true);
  write_file(out.path_of("summary.json"), "new");
  EXPECT_EQ(contents_of(tmp / "run/summary.json"), "old");
  out.commit();
  EXPECT_EQ(tmp.entries(), (Names{"run", "run/files.json", "run/summary.json"}));
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
  for (const auto& [file, told] :
       {Case{"thesis.tex", "thesis.tex"}, Case{"run2/summary.json", "run2"},
        Case{"pictures/mine.txt", "pictures/mine.txt"}, Case{"pictures/more/level_03.png", "pictures/more"},
        Case{"output.png", "output.png"}, Case{"pictures/mine.png", "pictures/mine.png"},
        Case{"README.txt", "README.txt"}, Case{"summary.json", "summary.json"}}) {
    const TemporaryFolder tmp;
    write_output(tmp / "run", {"summary.json", "pictures/level_03.png"});
    const std::filesystem::path whole = std::filesystem::path(tmp / "run") / file;
    std::filesystem::create_directories(whole.parent_path());
    put(whole.string(), "years of work");
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
  EXPECT_EQ(tmp.entries(), (Names{"run", "run/a", "run/files.json"}));
  put(tmp / "file", "x");
  EXPECT_THROW(OutputFolder(tmp / "file", true), InputError);
  EXPECT_THROW(OutputFolder("", false), InputError);
  EXPECT_THROW(OutputFolder("/", true), InputError);
}

TEST(OutputFolderTest, ALinkStaysAndWhatItLeadsToIsReplaced) {
  const TemporaryFolder tmp;
  write_output(tmp / "disk/run", {"history.csv"});
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
  EXPECT_EQ(tmp.entries(), (Names{".run.partial-2.old", ".runner.partial-1", "run", "run/a", "run/files.json"}));
  remove_leftovers(tmp / "run");
  EXPECT_EQ(tmp.entries(), (Names{".runner.partial-1", "run", "run/a", "run/files.json"}));
}

TEST(OutputFolderTest, HiddenNamesWithoutANumberAreOfNoRun) {
  const TemporaryFolder tmp;
  std::filesystem::create_directories(tmp / ".run.partial-notes");
  put(tmp / ".run.partial-notes/thesis", "years of work");
  { OutputFolder out(tmp / "run", false); }
  EXPECT_EQ(tmp.entries(), (Names{".run.partial-notes", ".run.partial-notes/thesis"}));
}

// What was set aside in a replacement that was killed has been an output folder, into which anybody may have put
// something.
TEST(OutputFolderTest, OfAResultThatWasSetAsideOnlyFilesOfTheRunGo) {
  const TemporaryFolder tmp;
  write_output(tmp / "run", {"summary.json"});
  write_output(tmp / ".run.partial-1.old", {"summary.json", "pictures/a.png"});
  put(tmp / ".run.partial-1.old/thesis", "years of work");
  remove_leftovers(tmp / "run");
  EXPECT_EQ(tmp.entries(),
            (Names{".run.partial-1.old", ".run.partial-1.old/thesis", "run", "run/files.json", "run/summary.json"}));
}

// A kill while a folder was filled in place: some of the new result's files are there, and the earlier one is set
// aside.
TEST(OutputFolderTest, AnEarlierResultStaysUntilAWholeOneHasItsPlace) {
  const TemporaryFolder tmp;
  write_output(tmp / "run", {"summary.json", "pictures/a.png"});
  write_output(tmp / ".run.partial-1.old", {"summary.json"});
  std::filesystem::remove(tmp / "run/summary.json");
  EXPECT_FALSE(holds_result(tmp / "run"));
  remove_leftovers(tmp / "run");
  EXPECT_TRUE(std::filesystem::exists(tmp / ".run.partial-1.old/summary.json"));
  put(tmp / "run/summary.json", "whatever it holds");
  EXPECT_TRUE(holds_result(tmp / "run"));
  remove_leftovers(tmp / "run");
  EXPECT_FALSE(std::filesystem::exists(tmp / ".run.partial-1.old"));
}

TEST(OutputFolderTest, ALinkThatLeadsNowhereIsRefusedBeforeAnyWork) {
  const TemporaryFolder tmp;
  std::filesystem::create_symlink(tmp / "nowhere", tmp / "run");
  const std::string message = message_of<InputError>([&] { OutputFolder(tmp / "run", true); });
  EXPECT_NE(message.find("a link that leads nowhere"), std::string::npos) << message;
  EXPECT_EQ(tmp.entries(), Names{"run"});
}

TEST(OutputFolderTest, TheListNamesEveryFileWithItsChecksum) {
  const TemporaryFolder tmp;
  write_output(tmp / "run", {"summary.json", "pictures/a.png"});
  const auto list = read_file_list(tmp / "run");
  ASSERT_TRUE(list);
  ASSERT_EQ(list->size(), 2u);
  EXPECT_EQ((*list)[0].name, "pictures/a.png");
  EXPECT_EQ((*list)[1].checksum, file_checksum(tmp / "run/summary.json"));
  EXPECT_FALSE(first_foreign_thing(tmp / "run"));
  std::filesystem::remove(tmp / "run/pictures/a.png");
  EXPECT_FALSE(first_foreign_thing(tmp / "run")) << "what is missing is no obstacle";
  put(tmp / "run/summary.json", "mine");
  EXPECT_TRUE(first_foreign_thing(tmp / "run").has_changed);
  EXPECT_FALSE(first_foreign_thing(tmp / "run", ChangedFiles::are_written));
  // A link of a listed name is none of the run's files.
  std::filesystem::remove(tmp / "run/summary.json");
  std::filesystem::create_symlink("/etc/hostname", tmp / "run/summary.json");
  EXPECT_EQ(first_foreign_thing(tmp / "run").name, "summary.json");
  remove_written_files(tmp / "run");
  EXPECT_TRUE(std::filesystem::is_symlink(tmp / "run/summary.json"));
  for (const char* damaged : {"", "{}", "{\"format\": 2, \"files\": []}", "[1]"}) {
    put(tmp / "run/files.json", damaged);
    EXPECT_TRUE(first_foreign_thing(tmp / "run").no_list) << damaged;
  }
}

TEST(OutputFolderTest, LongNamesHaveShortHiddenOnes) {
  const std::string longest(255, 'a'), other = longest.substr(0, 254) + "b";
  for (const std::string& name : {lock_name("/x/" + longest), partial_folder_name("/x/" + longest)})
    EXPECT_LE(std::filesystem::path(name).filename().string().size(), 240u);
  EXPECT_NE(lock_name("/x/" + longest), lock_name("/x/" + other));
  EXPECT_EQ(lock_name("/x/run"), "/x/.run.lock");
  EXPECT_TRUE(is_hidden_name(std::filesystem::path(partial_folder_name("/x/" + longest)).filename().string() + "-1.old",
                             longest));
  EXPECT_FALSE(is_hidden_name(".run.partial-", "run"));
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
  const std::string message = message_of<EnvironmentError>([] { write_file("/dev/full", std::string(100000, 'x')); });
  EXPECT_NE(message.find("make room"), std::string::npos) << message;
}

TEST(OutputFolderTest, APictureThatCannotBeDrawnIsToldAndRemoved) {
  const TemporaryFolder tmp;
  OutputFolder folder(tmp / "out", false);
  struct Watcher final : Observer {
    std::string notes;
    void note(const std::string& text) override { notes += text + "\n"; }
  } watcher;
  draw(folder, "pictures/a.png", watcher, [](const std::string& path) {
    put(path, "a part");
    throw EnvironmentError("no ink");
  });
  draw(folder, "pictures/b.png", watcher, [](const std::string&) { throw std::bad_alloc(); });
  draw(folder, "pictures/c.png", watcher, [](const std::string& path) { put(path, "all"); });
  EXPECT_EQ(watcher.notes, "pictures/a.png is missing: no ink\npictures/b.png is missing: not enough memory\n");
  EXPECT_THROW(draw(folder, "pictures/d.png", watcher, [](const std::string&) { throw Stopped("now"); }), Stopped);
  folder.commit();
  EXPECT_EQ(tmp.entries(), (Names{"out", "out/files.json", "out/pictures", "out/pictures/c.png"}));
}

// A folder that is in no list would be of no run, and could not be replaced.
TEST(OutputFolderTest, WithoutAnyPictureThereIsNoFolderOfPictures) {
  const TemporaryFolder tmp;
  {
    OutputFolder folder(tmp / "out", false);
    Observer observer;
    draw(folder, "pictures/a.png", observer, [](const std::string&) { throw std::bad_alloc(); });
    write_file(folder.path_of("summary.json"), "{}");
    folder.commit();
  }
  EXPECT_EQ(tmp.entries(), (Names{"out", "out/files.json", "out/summary.json"}));
  EXPECT_NO_THROW(OutputFolder(tmp / "out", true));
}

}  // namespace
}  // namespace shellmatch

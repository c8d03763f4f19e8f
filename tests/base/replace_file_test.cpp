#include "base/replace_file.h"

#include "base/error.h"

#include <gtest/gtest.h>

#include <cerrno>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>
#include <set>

namespace shellmatch {
namespace {

namespace fs = std::filesystem;

class ReplaceFile : public ::testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::path(::testing::TempDir()) /
              (std::string("shellmatch_replace_") + ::testing::UnitTest::GetInstance()->current_test_info()->name());
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  std::string path(const std::string& name) const { return (folder_ / name).string(); }
  void put(const std::string& name, const std::string& text) const { std::ofstream(folder_ / name) << text; }
  std::string contents(const std::string& name) const {
    std::ifstream in(folder_ / name);
    return {std::istreambuf_iterator<char>(in), {}};
  }
  std::set<std::string> names() const {
    std::set<std::string> all;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder_))
      all.insert(entry.path().filename().string());
    return all;
  }

  fs::path folder_;
};

TEST_F(ReplaceFile, NothingIsSeenBeforeAllOfItIsThere) {
  put("a", "old");
  replace_file(path("a"), [&](const std::string& partial) {
    std::ofstream(partial) << "new";
    EXPECT_EQ(contents("a"), "old");
  });
  EXPECT_EQ(contents("a"), "new");
  replace_file(path("b"), std::string_view("text"));
  EXPECT_EQ(contents("b"), "text");
  EXPECT_EQ(names(), (std::set<std::string>{"a", "b"}));
}

// The name was free when it was checked, and is taken by the time the contents are there.
TEST_F(ReplaceFile, WhatCameIntoBeingMeanwhileIsKept) {
  const auto publish = [&](const std::function<void()>& meanwhile) {
    publish_file(path("a"), Existing::is_kept, [&](const std::string& partial) {
      std::ofstream(partial) << "mine";
      meanwhile();
    });
  };
  EXPECT_THROW(publish([&] { put("a", "another's"); }), InputError);
  EXPECT_EQ(contents("a"), "another's");
  fs::remove(path("a"));
  EXPECT_THROW(publish([&] { fs::create_symlink("nowhere", path("a")); }), InputError);
  EXPECT_TRUE(fs::is_symlink(path("a")));
  fs::remove(path("a"));
  EXPECT_THROW(publish([&] { fs::create_directory(path("a")); }), InputError);
  EXPECT_EQ(names(), std::set<std::string>{"a"});
  fs::remove(path("a"));
  publish([] {});
  EXPECT_EQ(contents("a"), "mine");
  EXPECT_EQ(names(), std::set<std::string>{"a"});
}

TEST_F(ReplaceFile, AllArePublishedOrNone) {
  put("old", "another's");
  const auto pending = [&](Existing existing) {
    std::vector<PendingFile> files;
    for (const char* name : {"a", "old", "b"}) files.emplace_back(path(name), existing, std::string_view("mine"));
    return files;
  };
  std::vector<PendingFile> files = pending(Existing::is_kept);
  EXPECT_EQ(names().size(), 4u) << "nothing has its name yet";
  EXPECT_THROW(publish_together(files), InputError);
  EXPECT_FALSE(fs::exists(path("a")));
  EXPECT_FALSE(fs::exists(path("b")));
  files.clear();
  EXPECT_EQ(names(), std::set<std::string>{"old"});
  EXPECT_EQ(contents("old"), "another's");
  files = pending(Existing::is_replaced);
  publish_together(files);
  files.clear();
  EXPECT_EQ(names(), (std::set<std::string>{"a", "b", "old"}));
  EXPECT_EQ(contents("old"), "mine");
}

TEST_F(ReplaceFile, FoldersAreRenamedToFreeNamesAlone) {
  fs::create_directory(path("from"));
  fs::create_directory(path("taken"));
  EXPECT_EQ(rename_to_new(path("from"), path("taken")), EEXIST);
  EXPECT_EQ(rename_to_new(path("from"), path("free")), 0);
  EXPECT_EQ(rename_to_new(path("from"), path("free")), ENOENT);
  EXPECT_EQ(names(), (std::set<std::string>{"free", "taken"}));
}

TEST_F(ReplaceFile, WhatFailsLeavesNothing) {
  EXPECT_THROW(replace_file(path("none/a"), std::string_view("text")), EnvironmentError);
  fs::create_directory(path("folder"));
  EXPECT_THROW(replace_file(path("folder"), std::string_view("text")), EnvironmentError);
  EXPECT_THROW(replace_file(path("a"), [](const std::string&) { throw InputError("no"); }), InputError);
  EXPECT_EQ(names(), std::set<std::string>{"folder"});
}

// A process that is killed releases its lock and leaves its file.
TEST_F(ReplaceFile, LeftoversOfTheNameGoUnlessSomebodyWrites) {
  const std::set<std::string> others{".a.csv.partial-mine", ".a.csv.partial-0123456789abcdeg.csv",
                                     ".b.csv.partial-0123456789abcdef.csv", ".partial-0123456789abcdef.csv",
                                     "a.csv.partial-0123456789abcdef.csv"};
  for (const std::string& name : others) put(name, "text");
  put(".a.csv.partial-0123456789abcdef.csv", "a part");
  put(".a.csv.partial-0123456789abcde0", "a part");
  fs::create_symlink("nowhere", path(".a.csv.partial-0123456789abcde1"));
  std::optional<PartialFile> writing(path("a.csv"));
  replace_file(path("a.csv"), std::string_view("text"));
  std::set<std::string> left = others;
  left.insert({"a.csv", ".a.csv.partial-0123456789abcde1", fs::path(writing->name()).filename().string()});
  EXPECT_EQ(names(), left);
  writing.reset();
  EXPECT_EQ(names().size(), left.size() - 1);
}

// Each file that is being written has a name that nothing had before, so that nothing is written through a link.
TEST_F(ReplaceFile, PartialNamesAreNew) {
  const std::string long_path = path(std::string(250, 'a') + ".ply");
  const PartialFile first(long_path), second(long_path);
  EXPECT_NE(first.name(), second.name());
  for (const PartialFile* file : {&first, &second}) {
    EXPECT_TRUE(fs::exists(file->name()) && file->name().ends_with(".ply"));
    EXPECT_TRUE(is_partial_file_name(fs::path(file->name()).filename().string()));
  }
}

}  // namespace
}  // namespace shellmatch

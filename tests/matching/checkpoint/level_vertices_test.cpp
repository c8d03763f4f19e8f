// The levels that a checkpoint keeps for the report: bit for bit, refused where they cannot be those of the run, and in
// the end the same report.

#include "matching/checkpoint/level_vertices.h"

#include "base/error.h"
#include "base/stop.h"
#include "geometry/bytes/inflate.h"
#include "matching/checkpoint/checkpoints.h"
#include "matching/json/json_text.h"
#include "matching/output/written_files.h"
#include "matching/run_matching.h"
#include "tests/matching/output/temporary_folder.h"
#include "tests/matching/report/page_element.h"

#include <gtest/gtest.h>

#include <limits>
#include <map>
#include <sstream>

namespace shellmatch {
namespace {

using testing::contents_of;
using testing::message_of;
using testing::put;
using testing::TemporaryFolder;

TEST(LevelVertices, AreReadBackBitForBit) {
  const TemporaryFolder tmp;
  const std::vector<LevelVertices<3>> levels = {
      {3, {{0.1, 1.0 / 3, 5e-324}, {-0.0, 1, 2}}}, {4, {{1e300, 0, 0}, {4, 5, 6}}}, {12, {{7, 8, 9}, {0, 0, 0}}}};
  write_level_vertices<3>(levels, tmp / "levels.bin");
  const auto read = read_level_vertices<3>(tmp / "levels.bin", 2);
  ASSERT_EQ(read.size(), 3u);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(read[i].level, levels[i].level);
    EXPECT_EQ(std::memcmp(read[i].vertices.data(), levels[i].vertices.data(), 2 * sizeof(Vec<3>)), 0);
  }
  write_level_vertices<2>({}, tmp / "none");
  EXPECT_TRUE(read_level_vertices<2>(tmp / "none", 77).empty());
}

TEST(LevelVertices, OthersAreRefused) {
  const TemporaryFolder tmp;
  const std::string file = tmp / "levels.bin";
  write_level_vertices<2>(std::vector<LevelVertices<2>>{{3, {{1, 2}, {3, 4}}}, {4, {{5, 6}, {7, 8}}}}, file);
  const std::string whole = contents_of(file), values = whole.substr(whole.find('\n') + 1);
  ASSERT_EQ(whole, "dimension 2, 2 vertices, levels [3, 4]\n" + values);
  EXPECT_THROW(read_level_vertices<2>(tmp / "missing", 2), InputError);
  EXPECT_THROW(read_level_vertices<2>(file, 3), InputError);
  EXPECT_THROW(read_level_vertices<3>(file, 2), InputError);
  std::string not_finite = whole;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  std::memcpy(not_finite.data() + whole.size() - 8, &nan, 8);
  const std::string head = "dimension 2, 2 vertices, levels ";
  for (const std::string& damaged :
       {std::string(), std::string("\n"), head, whole.substr(0, whole.size() - 1), whole + "x", not_finite, values,
        head + "[4, 3]\n" + values, head + "[3, 3]\n" + values, head + "[0, 3]\n" + values, head + "[3, 16]\n" + values,
        head + "[3]\n" + values, head + "[3, 4, 5]\n" + values, head + "[3,4]\n" + values, head + "[3, 4\n" + values,
        head + "[99999999999, 4]\n" + values, head + "[]\n", head + "[3, 4]" + values,
        head + "[1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16]\n" + std::string(512, '\0')}) {
    put(file, damaged);
    EXPECT_NE(message_of<InputError>([&] { read_level_vertices<2>(file, 2); }).find(file + ": does not hold"),
              std::string::npos)
        << damaged.substr(0, 60);
  }
  put(file, whole);
  EXPECT_EQ(read_level_vertices<2>(file, 2).size(), 2u);
}

// Ends the run as a level begins, or as the result is written (level 100).
struct Stopper : Observer {
  int at = 0;
  std::string notes;
  explicit Stopper(int level) : at(level) {}
  void note(const std::string& text) override { notes += text + "\n"; }
  void reached(int level) const {
    if (level == at) throw Stopped("now");
  }
  void stage(const std::string& name) override {
    if (name == "writing") reached(100);
  }
  void minimisation_started(const LevelStart& start) override { reached(start.level); }
};

// Returns what is told.
std::string run(const ExperimentOptions& options, const std::string& out, int stop_at = 0) {
  Stopper stopper(stop_at);
  if (stop_at == 0) run_matching(options, out, {}, stopper);
  else EXPECT_THROW(run_matching(options, out, {}, stopper), Stopped);
  return stopper.notes;
}

std::string decoded(const std::string& base64_text) {
  static constexpr std::string_view letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string bytes;
  std::uint32_t bits = 0;
  int n_bits = 0;
  for (const char c : base64_text) {
    const std::size_t value = letters.find(c);
    if (value == std::string_view::npos) continue;
    bits = (bits << 6) | static_cast<std::uint32_t>(value);
    if ((n_bits += 6) >= 8) bytes += static_cast<char>((bits >> (n_bits -= 8)) & 255);
  }
  return bytes;
}

// What the page of an output folder has of the deformed reference at the ends of levels, by name: how it is to be read,
// and its bytes.
std::map<std::string, std::string> levels_of_page(const std::string& folder) {
  const std::string page = contents_of(folder + "/report.html");
  std::istringstream text(testing::page_element(page, "data"));
  Json report = parse_json(text);
  const Json& last = report["arrays"].back();
  std::string bytes(last["offset"].get<std::size_t>() + last["bytes"].get<std::size_t>(), '\0');
  EXPECT_TRUE(inflate_exactly(decoded(testing::page_element(page, "arrays")), bytes.data(), bytes.size()));
  std::map<std::string, std::string> found = {{"levels", report["levels"].dump()}};
  for (Json& a : report["arrays"]) {
    const std::string name = a["name"];
    if (!name.starts_with("deformed")) continue;
    const std::string values = bytes.substr(a["offset"], a["bytes"]);
    a.erase("offset");
    found[name] = a.dump() + values;
  }
  return found;
}

ExperimentOptions experiment(const std::string& template_name = "generate:ellipse/long") {
  ExperimentOptions o = profile_defaults(Profile::standard);
  o.align.mode = AlignMode::none;
  o.input.reference = "generate:circle";
  o.input.template_file = template_name;
  o.cascade.max_level = 5;
  o.pictures = Pictures::none;
  o.resume.min_seconds = 0;
  return o;
}

void expect_report_of_unbroken_run(const ExperimentOptions& o) {
  const TemporaryFolder tmp;
  run(o, tmp / "whole");
  const auto whole = levels_of_page(tmp / "whole");
  ASSERT_EQ(whole.at("levels"), "[3,4]");
  ASSERT_TRUE(whole.contains("deformed.3") && whole.contains("deformed.4") && whole.contains("deformed"));
  for (const std::vector<int>& stops : {std::vector<int>{4}, {5}, {100}, {4, 5, 100}}) {
    for (const int level : stops) run(o, tmp / "out", level);
    run(o, tmp / "out");
    EXPECT_EQ(levels_of_page(tmp / "out"), whole) << "stopped at " << stops[0] << ", " << stops.size() << " times";
    std::filesystem::remove_all(tmp / "out");
  }
}

TEST(ResumedReport, HasTheLevelsOfAnUnbrokenRun) {
  expect_report_of_unbroken_run(experiment());
  ExperimentOptions backward = experiment("generate:leaf");
  backward.align.direction = MatchDirection::backward;
  expect_report_of_unbroken_run(backward);
}

TEST(ResumedReport, LacksLevelsOfRunsThatWereToWriteNone) {
  const TemporaryFolder tmp;
  ExperimentOptions o = experiment();
  o.report = false;
  run(o, tmp / "out", 4);
  o.report = true;
  run(o, tmp / "out");
  EXPECT_EQ(levels_of_page(tmp / "out").at("levels"), "[4]");
}

// Format 1 had other checksums, which this version does not know, format 3 no levels.bin.
TEST(ResumedReport, CheckpointsOfOtherFormatsBeginAnewAndSaySo) {
  const TemporaryFolder tmp;
  const ExperimentOptions o = experiment();
  run(o, tmp / "whole");
  const std::string kept = tmp / "out.unfinished";
  for (const int format : {1, 3, CheckpointManifest().format + 1}) {
    run(o, tmp / "out", 5);
    CheckpointManifest manifest = read_manifest(kept + "/state.json").value();
    manifest.format = format;
    put(kept + "/state.json", manifest_json(manifest));
    std::filesystem::remove(kept + "/levels.bin");
    const std::string notes = run(o, tmp / "out");
    EXPECT_NE(notes.find("another build of the program has written it; the run begins anew"), std::string::npos)
        << notes;
    EXPECT_EQ(levels_of_page(tmp / "out"), levels_of_page(tmp / "whole"));
    EXPECT_FALSE(std::filesystem::exists(kept));
    std::filesystem::remove_all(tmp / "out");
  }
}

// Whole to the last byte, and yet not of this reference.
TEST(ResumedReport, LevelsOfAnotherReferenceBeginAnew) {
  const TemporaryFolder tmp;
  const ExperimentOptions o = experiment();
  run(o, tmp / "out", 5);
  write_level_vertices<2>(std::vector<LevelVertices<2>>{{3, {{1, 2}}}}, tmp / "out.unfinished/levels.bin");
  write_file_list(tmp / "out.unfinished");
  const std::string notes = run(o, tmp / "out");
  EXPECT_NE(notes.find("it cannot be read"), std::string::npos) << notes;
  EXPECT_EQ(levels_of_page(tmp / "out").at("levels"), "[3,4]");
}

}  // namespace
}  // namespace shellmatch

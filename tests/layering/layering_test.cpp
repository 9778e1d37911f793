// tests/layering/layering_test.cpp: which folder may know which; the table is the rule.
#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include <gmock/gmock.h>

#include "tests/layering/source_tree.hpp"

namespace teamsight::layering {
namespace {

using Names = std::vector<std::string_view>;

// A folder may include its own headers, and those of the folders (or single headers) that are
// named.
struct Layer {
  std::string_view folder;
  Names may_include;
};

// clang-format off
const std::vector<Layer> kLayers = {
    // The core computes.
    {"geometry/",       {}},
    {"vision/",         {"geometry/"}},
    {"fusion/",         {"geometry/"}},
    // The shell communicates.
    {"settings/",       {"geometry/", "vision/"}},
    {"bus/",            {"geometry/"}},
    {"process/",        {"geometry/", "settings/", "bus/"}},
    {"agent/",          {"geometry/", "settings/", "bus/", "process/", "vision/"}},
    {"fusion/service/", {"geometry/", "settings/", "bus/", "process/", "fusion/"}},
    {"client/",         {"geometry/", "settings/", "bus/", "process/"}},
    {"recording/",      {"geometry/", "bus/"}},
    {"monitor/",        {"geometry/", "settings/", "bus/", "process/", "recording/", "fusion/",  // to ask "what if"
                         "fusion/service/clock_book.hpp"}},  // asks for the robots' time as a fusion does
    {"sim/match/",      {"geometry/"}},
    {"sim/render/",     {"geometry/", "sim/match/",
                         "vision/camera_parameters.hpp", "vision/image.hpp"}},  // numbers and formats: no geometry is shared
    {"sim/",            {"geometry/", "settings/", "bus/", "process/", "vision/",
                         "sim/match/", "sim/render/", "agent/frame_stream.hpp"}},  // the pipe's format
    {"tools/",          {"geometry/", "settings/", "bus/", "process/", "vision/", "fusion/", "sim/match/", "sim/render/",
                         "recording/",
                         "bench/locate_score/", "bench/fuse_score/", "bench/mrclam/", "bench/play/", "bench/camera_play/",
                         "bench/kept_play/"}},  // `score` counts with them
    {"examples/",       {"geometry/", "client/"}},
    {"bench/locate_rivals/", {"geometry/", "vision/"}},
    {"bench/locate_score/",  {"geometry/", "vision/", "sim/match/", "sim/render/", "bench/locate_rivals/"}},
    {"bench/play/",     {"geometry/", "fusion/"}},
    {"bench/camera_play/", {"geometry/", "vision/", "fusion/", "sim/", "sim/match/", "sim/render/", "bench/play/"}},
    {"bench/kept_play/", {"geometry/", "fusion/", "bus/", "recording/", "bench/play/", "bench/camera_play/"}},
    {"bench/peers/",    {"geometry/", "fusion/"}},
    {"bench/fuse_score/", {"geometry/", "fusion/", "bench/play/", "bench/peers/"}},
    {"bench/mrclam/",   {"geometry/", "fusion/", "bench/fuse_score/"}},
    {"bench/",          {"geometry/", "settings/", "bus/", "process/", "vision/", "fusion/", "sim/", "bench/play/",
                         "client/", "sim/match/", "sim/render/"}},
    {"tests/",          {""}},  // everything
};

// Headers without a folder are generated from idl/, and stop at these edges.
struct Edge {
  std::string_view header;
  Names folders;
};

const std::vector<Edge> kGenerated = {
    {"teamsight.h",     {"bus/", "bench/ping_cyclone.cpp", "tests/bus/"}},  // a bare ping, by the C API
    {"config.pb.h",     {"settings/", "tests/settings/"}},
    {"mirror.pb.h",     {"settings/", "tests/settings/"}},
    {"monitor.pb.h",    {"monitor/", "tests/monitor/", "tests/system/", "tests/realdata/"}},
    {"foxglove.pb.h",   {"recording/scene", "tests/recording/"}},
    {"google/protobuf/descriptor.pb.h", {"recording/", "monitor/", "tools/"}},
    {"recording.pb.h",  {"recording/", "monitor/", "tools/", "tests/recording/", "tests/monitor/",
                         "tests/tools/"}},
};

// What must not stand anywhere in a folder: the core has time as an argument, and neither sees
// nor says anything.
struct Ban {
  std::string_view folder;
  Names words;
};

const Names kShellWords = {"#include <iostream>", "#include <fstream>", "#include <spdlog/",
                           "#include <dds/",      "#include <thread>",  "::now()",
                           "std::getenv",         "std::rand",          "std::random_device"};

const std::vector<Ban> kBans = {
    {"geometry/", kShellWords},
    {"vision/",   kShellWords},
    {"fusion/",   kShellWords},
    {"geometry/", {"#include <opencv2/"}},
    {"fusion/",   {"#include <opencv2/"}},
    {"settings/", {"#include <dds/"}},
    {"agent/",    {"#include <dds/"}},
    {"recording/", {"#include <dds/"}},
    {"monitor/",  {"#include <dds/"}},
    {"client/",   {"#include <dds/"}},
    {"sim/",      {"#include <dds/"}},
    {"tools/",    {"#include <dds/"}},
};

// clang-format on

bool is_in(std::string_view path, const Names& folders) {
  return std::ranges::any_of(folders, [&](auto folder) { return path.starts_with(folder); });
}

// The most special layer that a file lies in: fusion/service/ before fusion/.
const Layer* layer_of(std::string_view path) {
  const Layer* best = nullptr;
  for (const Layer& layer : kLayers) {
    if (!path.starts_with(layer.folder)) continue;
    if (best == nullptr || layer.folder.size() > best->folder.size()) best = &layer;
  }
  return best;
}

bool is_allowed(const Layer& from, std::string_view header) {
  const Layer* to = layer_of(header);
  if (to == nullptr) return false;
  return to == &from || from.may_include == Names{""} ||
         std::ranges::any_of(from.may_include, [&](std::string_view allowed) {
           return allowed == to->folder || allowed == header;
         });
}

bool is_cpp(std::string_view path) {
  return path.ends_with(".cpp") || path.ends_with(".hpp");
}

// The includes of a file that follow no arrow.
std::vector<std::string> wrong_includes(const SourceFile& file) {
  const Layer* layer = layer_of(file.path);
  if (layer == nullptr) return {file.path + " lies in a folder that the table does not know"};
  std::vector<std::string> wrong;
  for (const Include& include : includes_of(file.text)) {
    const bool is_ours = include.in_quotes && include.header.find('/') != std::string::npos;
    if (is_ours && !is_allowed(*layer, include.header)) {
      wrong.push_back(file.path + " includes " + include.header);
    }
  }
  return wrong;
}

std::vector<std::string> wrong_generated(const SourceFile& file) {
  std::vector<std::string> wrong;
  for (const Include& include : includes_of(file.text)) {
    const auto edge = std::ranges::find(kGenerated, include.header, &Edge::header);
    const bool is_generated = include.header.ends_with(".pb.h") || edge != kGenerated.end();
    if (is_generated && (edge == kGenerated.end() || !is_in(file.path, edge->folders))) {
      wrong.push_back(file.path + " includes " + include.header);
    }
  }
  return wrong;
}

void add_banned(const SourceFile& file, const Ban& ban, std::vector<std::string>& found) {
  for (const std::string_view word : ban.words) {
    if (file.text.find(word) != std::string::npos) {
      found.push_back(file.path + " has " + std::string(word));
    }
  }
}

std::vector<std::string> banned_words(const SourceFile& file) {
  std::vector<std::string> found;
  const Layer* layer = layer_of(file.path);
  if (layer == nullptr) return found;
  for (const Ban& ban : kBans) {
    if (layer->folder == ban.folder) add_banned(file, ban, found);
  }
  return found;
}

template <class Check>
std::vector<std::string> findings(const Check& check) {
  std::vector<std::string> all;
  for (const SourceFile& file : source_tree()) {
    const std::vector<std::string> some =
        is_cpp(file.path) ? check(file) : std::vector<std::string>{};
    all.insert(all.end(), some.begin(), some.end());
  }
  return all;
}

TEST(Layering, ReadsTheWholeTree) {
  EXPECT_GT(source_tree().size(), 100U) << "TEAMSIGHT_SOURCE_DIR must be the repository";
}

TEST(Layering, EveryIncludeFollowsAnArrow) {
  EXPECT_THAT(findings(wrong_includes), testing::IsEmpty());
}

TEST(Layering, GeneratedMessagesStopAtTheirEdge) {
  EXPECT_THAT(findings(wrong_generated), testing::IsEmpty());
}

TEST(Layering, TheCoreComputesAndOnlyTheBusKnowsDds) {
  EXPECT_THAT(findings(banned_words), testing::IsEmpty());
}

// The checks themselves, on files that break each rule.

TEST(Layering, WouldSeeAnArrowThatPointsBack) {
  EXPECT_EQ(wrong_includes({"vision/a.cpp", "#include \"fusion/b.hpp\"\n"}).size(), 1U);
  EXPECT_EQ(wrong_includes({"geometry/a.cpp", "\n#include \"vision/b.hpp\"\n"}).size(), 1U);
  EXPECT_EQ(wrong_includes({"fusion/a.cpp", "#include \"fusion/service/b.hpp\"\n"}).size(), 1U);
  EXPECT_EQ(wrong_includes({"sim/a.cpp", "#include \"agent/agent.hpp\"\n"}).size(), 1U);
  EXPECT_EQ(wrong_includes({"novelty/a.cpp", ""}).size(), 1U);
  EXPECT_EQ(wrong_includes({"fusion/service/a.cpp", "#include \"fusion/b.hpp\"\n"}).size(), 0U);
}

TEST(Layering, WouldSeeAMessageOutsideItsEdge) {
  EXPECT_EQ(wrong_generated({"agent/a.cpp", "#include <teamsight.h>\n"}).size(), 1U);
  EXPECT_EQ(wrong_generated({"agent/a.cpp", "#include \"new.pb.h\"\n"}).size(), 1U);
  EXPECT_EQ(wrong_generated({"bus/a.cpp", "#include <teamsight.h>\n"}).size(), 0U);
}

TEST(Layering, WouldSeeAClockInTheCore) {
  EXPECT_EQ(banned_words({"fusion/a.cpp", "auto t = Clock::now();"}).size(), 1U);
  EXPECT_EQ(banned_words({"fusion/service/a.cpp", "auto t = Clock::now();"}).size(), 0U);
}

// ---- files -------------------------------------------------------------------------------------

TEST(Files, AreAtMost400LinesLong) {
  constexpr int kLimit = 400;
  for (const SourceFile& file : source_tree()) {
    EXPECT_LE(line_count(file.text), kLimit) << file.path;
  }
}

TEST(Files, BeginWithTheirPath) {
  for (const SourceFile& file : source_tree()) {
    EXPECT_THAT(std::string(first_line(file.text)), testing::HasSubstr(file.path)) << file.path;
  }
}

}  // namespace
}  // namespace teamsight::layering

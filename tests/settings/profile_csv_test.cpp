// tests/settings/profile_csv_test.cpp: a mirror's meridian, good and bad.
#include "settings/profile_csv.hpp"

#include <gmock/gmock.h>

#include "tests/settings/temporary_files.hpp"

namespace teamsight::settings {
namespace {

struct BadProfile {
  const char* name;
  const char* text;
  const char* complaint;
};

void PrintTo(const BadProfile& bad, std::ostream* out) {
  *out << bad.name;
}

class BadProfiles : public testing::TestWithParam<BadProfile> {};

TEST_P(BadProfiles, AreNamedWithTheirLine) {
  const TemporaryFolder folder;
  const auto path = folder.write("mirror.csv", GetParam().text);

  const std::string complaint = complaint_of([&] { std::ignore = read_profile(path); });

  EXPECT_EQ(complaint, path.string() + GetParam().complaint);
}

// clang-format off
INSTANTIATE_TEST_SUITE_P(Each, BadProfiles, testing::Values(
    BadProfile{"NoHead", "0,0.2\n",
               ":1:1: key 'x_m,y_m': found '0,0.2', expected the head x_m,y_m"},
    BadProfile{"Word", "# made by hand\nx_m,y_m\n0,high\n",
               ":3:1: key 'y_m': found 'high', expected a finite number"},
    BadProfile{"ColumnMissing", "x_m,y_m\n0,0.2\n0.1\n",
               ":3:1: key 'y_m': found '', expected a finite number"},
    BadProfile{"NotFinite", "x_m,y_m\n0,inf\n",
               ":2:1: key 'y_m': found 'inf', expected a finite number"},
    BadProfile{"BackAgain", "x_m,y_m\n0,0.2\n0.02,0.3\n0.01,0.4\n",
               ":4:1: key 'x_m': found 0.01, expected more than the row before, 0.02"},
    BadProfile{"TwoHeights", "x_m,y_m\n0,0.2\n0,0.3\n",
               ":3:1: key 'x_m': found 0, expected more than the row before, 0"},
    BadProfile{"LeftOfTheAxis", "x_m,y_m\n-0.1,0.2\n",
               ":2:1: key 'x_m': found -0.1, expected at least 0"},
    BadProfile{"TooShort", "x_m,y_m\n0,0.2\n0.1,0.3\n",
               ":1:1: key 'x_m,y_m': found 2 rows, expected at least 3 rows"}),
    [](const auto& test) { return test.param.name; });

// clang-format on

TEST(Profile, ReadsBackWhatWasWritten) {
  const TemporaryFolder folder;
  const std::vector<vision::ProfilePoint> profile{{0.0, 0.1}, {1.0 / 3.0, 0.2}, {0.5, 2.0 / 7.0}};

  const auto path = folder.write("mirror.csv", profile_csv(profile));

  EXPECT_EQ(read_profile(path), profile);
}

}  // namespace
}  // namespace teamsight::settings

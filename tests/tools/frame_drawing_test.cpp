// tests/tools/frame_drawing_test.cpp: pictures of classes, of verdicts, and sheets of pictures.
#include "tools/frame_drawing.hpp"

#include <array>
#include <cstddef>
#include <vector>

#include <gmock/gmock.h>

#include "tests/support/process.hpp"
#include "tools/contact_sheet.hpp"

namespace teamsight::tools {
namespace {

using ::testing::ElementsAre;
using Bgr = std::vector<int>;

Bgr pixel_at(const Picture& picture, int u, int v) {
  const std::size_t first = std::size_t{3} * static_cast<std::size_t>(v * picture.width_px + u);
  return {picture.bgr[first], picture.bgr[first + 1], picture.bgr[first + 2]};
}

Picture plain(int width, int height, std::uint8_t b, std::uint8_t g, std::uint8_t r) {
  Picture picture{width, height, {}};
  for (int i = 0; i < width * height; ++i) picture.bgr.insert(picture.bgr.end(), {b, g, r});
  return picture;
}

ImageFile grey_frame(std::uint32_t width, std::uint32_t height) {
  return {std::vector<std::uint8_t>(std::size_t{width} * height, 60),
          width,
          height,
          vision::PixelFormat::kGrey};
}

TEST(ClassPicture, PaintsEachPixelByItsClassBesideTheImage) {
  vision::ColourParameters colours;
  colours.samples = {{vision::ColourClass::kGreen, 100, 100, 10},
                     {vision::ColourClass::kBall, 90, 180, 10}};
  colours.black_max_y = 40;
  colours.white_min_y = 200;
  // Two pixels each: green, ball, black, white, nothing.
  const ImageFile frame{
      {90, 100, 90, 100, 90, 90, 90, 180, 20, 128, 20, 128, 250, 128, 250, 128, 100, 128, 100, 128},
      10,
      1,
      vision::PixelFormat::kYuyv};

  const Picture picture = class_picture(frame, vision::ColourClasses(colours));

  EXPECT_EQ(picture.width_px, 20);
  EXPECT_EQ(picture.height_px, 1);
  EXPECT_THAT(pixel_at(picture, 10, 0), ElementsAre(0, 150, 0));
  EXPECT_THAT(pixel_at(picture, 12, 0), ElementsAre(0, 140, 255));
  EXPECT_THAT(pixel_at(picture, 14, 0), ElementsAre(0, 0, 0));
  EXPECT_THAT(pixel_at(picture, 16, 0), ElementsAre(255, 255, 255));
  EXPECT_THAT(pixel_at(picture, 18, 0), ElementsAre(110, 110, 110));
  EXPECT_GT(pixel_at(picture, 7, 0)[1], 200) << "the image itself is on the left";
}

TEST(JudgedFrame, TellsWhatWasFoundMissedAndFalse) {
  vision::FrameObservation seen;
  seen.obstacle_pixels.resize(2);
  seen.obstacle_pixels[0].u_px = 52.0;
  seen.obstacle_pixels[0].v_px = 50.0;
  seen.obstacle_pixels[1].u_px = 50.0;
  seen.obstacle_pixels[1].v_px = 150.0;
  const ImageLabels labels{"x", {}, {{50, 50, true}, {150, 50, true}, {150, 150, false}}, {}};
  const ImageFile frame = grey_frame(200, 200);

  const Picture picture = judged_frame({"x", frame, {}}, seen, labels);

  EXPECT_EQ(picture.width_px, 400);
  // Ten pixels from the labels' places, and above the false one, at twice the size.
  EXPECT_THAT(pixel_at(picture, 101, 81), ElementsAre(0, 255, 0));
  EXPECT_THAT(pixel_at(picture, 301, 81), ElementsAre(0, 0, 255));
  EXPECT_THAT(pixel_at(picture, 301, 281), ElementsAre(160, 160, 160));
  EXPECT_THAT(pixel_at(picture, 101, 281), ElementsAre(0, 128, 255));
  EXPECT_THAT(pixel_at(picture, 201, 201), ElementsAre(60, 60, 60));
}

TEST(ContactSheets, BeginANewSheetWhenOneIsFull) {
  const test::TempDirectory folder;
  ContactSheets sheets(folder.path(), {2, 2, 40});

  for (int i = 0; i < 4; ++i) sheets.add(plain(40, 20, 0, 0, 200), "red");
  sheets.add(plain(80, 80, 200, 0, 0), "blue");
  sheets.finish();

  vision::CameraParameters size;
  size.width_px = 88;
  size.height_px = 128;
  const ImageFile first = read_image(folder.path() / "sheet-1.png", size);
  const ImageFile second = read_image(folder.path() / "sheet-2.png", size);
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "sheet-3.png"));
  const auto at = [&](const ImageFile& sheet, int u, int v) {
    return pixel_at({88, 128, sheet.bytes}, u, v);
  };
  EXPECT_THAT(at(first, 60, 70), ElementsAre(0, 0, 200)) << "the fourth, below on the right";
  EXPECT_THAT(at(first, 60, 100), ElementsAre(0, 0, 0)) << "only as high as it is";
  EXPECT_THAT(at(second, 20, 35), ElementsAre(200, 0, 0)) << "made half as large";
  EXPECT_THAT(at(second, 60, 35), ElementsAre(0, 0, 0));
}

}  // namespace
}  // namespace teamsight::tools

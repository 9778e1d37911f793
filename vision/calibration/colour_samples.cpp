// vision/calibration/colour_samples.cpp: medians, quantiles, gains.
#include "vision/calibration/colour_samples.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <optional>

#include <Eigen/Core>

#include "geometry/angle.hpp"
#include "geometry/expect.hpp"
#include "vision/field_colours.hpp"
#include "vision/light_gains.hpp"
#include "vision/pixel_reader.hpp"

namespace teamsight::vision {

namespace {

constexpr double kLeastRadius = 8.0;  // of a disc: chroma noise of any camera
constexpr double kMostRadius = 60.0;
constexpr double kMargin = 1.5;            // of the scatter
constexpr double kApart = 6.0;             // samples nearer than this are the same colour
constexpr std::size_t kOfEachPlace = 100;  // pixels
constexpr double kLeastChroma = 8.0;       // paler pixels have no hue
constexpr double kVivid = 0.5;             // of the typical chroma, and more
constexpr double kPalest = 0.5;            // of the palest tenth: in shade or far away
constexpr double kDegree = std::numbers::pi / 180.0;
constexpr double kHueMargin = 15.0 * kDegree;

template <class Get>
double quantile(const std::vector<SampledColour>& pixels, double share, const Get& get) {
  std::vector<double> values(pixels.size());
  std::ranges::transform(pixels, values.begin(), get);
  const auto at = static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), values.begin() + at, values.end());
  return values[static_cast<std::size_t>(at)];
}

std::uint8_t byte(double value) {
  return static_cast<std::uint8_t>(std::lround(std::clamp(value, 0.0, 255.0)));
}

SampledColour median(const std::vector<SampledColour>& pixels) {
  return {byte(quantile(pixels, 0.5, [](const SampledColour& p) { return double{1} * p.y; })),
          byte(quantile(pixels, 0.5, [](const SampledColour& p) { return double{1} * p.u; })),
          byte(quantile(pixels, 0.5, [](const SampledColour& p) { return double{1} * p.v; }))};
}

ColourSample disc_of(const LabelledColours& label) {
  const SampledColour middle = median(label.pixels);
  const double scatter = quantile(label.pixels, 0.9, [&](const SampledColour& p) {
    return std::hypot(p.u - middle.u, p.v - middle.v);
  });
  const double radius = std::clamp(kMargin * scatter, kLeastRadius, kMostRadius);
  return {label.colour, middle.u, middle.v, byte(radius)};
}

double chroma_of(const SampledColour& p) {
  return std::hypot(p.u - 128, p.v - 128);
}

double hue_of(const SampledColour& p) {
  return std::atan2(p.v - 128, p.u - 128);
}

/// The hues of a labelled colour: most of its pixels, and what other light may make of them.
struct Hues {
  ColourClass colour{ColourClass::kNone};
  double middle{0.0};                    // rad
  double core_low{0.0}, core_high{0.0};  // of nine tenths, from the middle; rad
  double low{0.0}, high{0.0};            // with the margin
  std::uint8_t min_chroma{0};
};

// Nothing for a colour that is mostly grey: it has no hue. Pale pixels say how pale it may be; of
// which hue it is, the vivid ones.
std::optional<Hues> hues_of(const LabelledColours& label) {
  const auto paleness = [&](double share) {
    return quantile(label.pixels, share, chroma_of);
  };
  const double typical = paleness(0.5);
  if (typical < kLeastChroma) return std::nullopt;
  std::vector<SampledColour> vivid;
  std::ranges::copy_if(label.pixels, std::back_inserter(vivid), [&](const SampledColour& p) {
    return chroma_of(p) >= std::max(kLeastChroma, kVivid * typical);
  });
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  for (const SampledColour& p : vivid) sum += Eigen::Vector2d(p.u - 128, p.v - 128);
  Hues hues;
  hues.colour = label.colour;
  hues.middle = std::atan2(sum.y(), sum.x());
  const auto off = [&](const SampledColour& p) {
    return angle_difference(hues.middle, hue_of(p));
  };
  hues.core_low = quantile(vivid, 0.05, off);
  hues.core_high = quantile(vivid, 0.95, off);
  hues.low = hues.core_low - kHueMargin;
  hues.high = hues.core_high + kHueMargin;
  hues.min_chroma = byte(std::max(kLeastChroma, kPalest * paleness(0.1)));
  return hues;
}

// Where the margins of two colours overlap, the border is half way between what was labelled.
void part(Hues& a, Hues& b) {
  const double way = angle_difference(a.middle, b.middle);
  if (way < 0.0) return part(b, a);
  if (a.high <= way + b.low) return;
  const double border = 0.5 * (a.core_high + way + b.core_low);
  a.high = border;
  b.low = border - way;
}

// In whole degrees, as people write them.
HueSector sector_of(const Hues& hues) {
  const auto rounded = [](double angle) {
    return std::round(angle / kDegree) * kDegree;
  };
  const double from = rounded(wrap_angle(hues.middle + hues.low));
  return {hues.colour, from, from + rounded(hues.high - hues.low), hues.min_chroma, 255};
}

bool is_chromatic(ColourClass colour) {
  return colour != ColourClass::kWhite && colour != ColourClass::kBlack;
}

std::optional<ColourConflict> first_conflict(const std::vector<ColourSample>& samples) {
  for (std::size_t i = 0; i < samples.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const double distance = std::hypot(samples[i].u - samples[j].u, samples[i].v - samples[j].v);
      if (samples[i].colour == samples[j].colour || distance >= kApart) continue;
      return ColourConflict{samples[j].colour, samples[i].colour, distance};
    }
  }
  return std::nullopt;
}

// A disc of a class that was not labelled leaves out what now belongs to another one.
void give_way(ColourSample& disc, const LabelledColours& label) {
  const double nearest = quantile(label.pixels, 0.05, [&](const SampledColour& p) {
    return std::hypot(p.u - disc.u, p.v - disc.v);
  });
  disc.radius = std::min(disc.radius, byte(std::max(0.0, std::floor(nearest) - 1.0)));
}

// One label per class, of as many pixels of each place.
std::vector<LabelledColours> pooled(const std::vector<LabelledColours>& labels) {
  std::vector<LabelledColours> pools;
  for (const LabelledColours& label : labels) {
    TEAMSIGHT_EXPECT(!label.pixels.empty());
    auto pool = std::ranges::find(pools, label.colour, &LabelledColours::colour);
    if (pool == pools.end()) pool = pools.insert(pool, {label.colour, {}});
    for (std::size_t i = 0; i < kOfEachPlace; ++i) {
      pool->pixels.push_back(label.pixels[i * label.pixels.size() / kOfEachPlace]);
    }
  }
  return pools;
}

const LabelledColours* labelled(const std::vector<LabelledColours>& labels, ColourClass colour) {
  const auto found = std::ranges::find(labels, colour, &LabelledColours::colour);
  return found == labels.end() ? nullptr : &*found;
}

// Half way between the carpet and white (or black), if both were labelled.
void set_luminance(const std::vector<LabelledColours>& labels, ColourParameters& colours) {
  const auto y = [](const SampledColour& p) {
    return static_cast<double>(p.y);
  };
  const LabelledColours* green = labelled(labels, ColourClass::kGreen);
  if (green == nullptr) return;
  if (const LabelledColours* white = labelled(labels, ColourClass::kWhite)) {
    colours.white_min_y =
        byte(0.5 * (quantile(green->pixels, 0.9, y) + quantile(white->pixels, 0.1, y)));
  }
  if (const LabelledColours* black = labelled(labels, ColourClass::kBlack)) {
    colours.black_max_y =
        byte(0.5 * (quantile(green->pixels, 0.1, y) + quantile(black->pixels, 0.9, y)));
  }
}

// ---- light -------------------------------------------------------------------------------------

constexpr double kTypicalChroma = 50.0;  // of a ball or a shirt

Eigen::Vector2d chroma_of(const Eigen::Vector3d& rgb) {
  return {128.0 - 0.168736 * rgb.x() - 0.331264 * rgb.y() + 0.5 * rgb.z(),
          128.0 + 0.5 * rgb.x() - 0.418688 * rgb.y() - 0.081312 * rgb.z()};
}

// A colour of that chroma that a camera can show: as bright as the middle, moved into the cube.
Eigen::Vector3d typical_rgb(double u, double v) {
  Eigen::Vector3d rgb = rgb_of(128.0, u, v);
  rgb.array() -= std::min(0.0, rgb.minCoeff());
  rgb.array() -= std::max(0.0, rgb.maxCoeff() - 255.0);
  return rgb.cwiseMax(0.0);
}

std::vector<SampledColour> floor_pixels(const ImageView& image,
                                        const Pixel& centre,
                                        double inner_px,
                                        double outer_px) {
  const PixelReader pixels(image);
  std::vector<SampledColour> floor;
  for (std::uint32_t v = 0; v < image.height_px; ++v) {
    for (std::uint32_t u = 0; u < image.width_px; ++u) {
      const double radius = std::hypot(u - centre.u, v - centre.v);
      if (radius < inner_px || radius > outer_px) continue;
      const std::size_t i = std::size_t{v} * image.width_px + u;
      const Chroma chroma = pixels.chroma(i);
      floor.push_back({pixels.luminance(i), chroma.u, chroma.v});
    }
  }
  return floor;
}

}  // namespace

std::vector<SampledColour> colours_around(const ImageView& image,
                                          const Pixel& place,
                                          double radius_px) {
  const PixelReader pixels(image);
  const auto reach = static_cast<int>(std::ceil(radius_px));
  const auto middle_u = static_cast<int>(std::lround(place.u));
  const auto middle_v = static_cast<int>(std::lround(place.v));
  std::vector<SampledColour> found;
  for (int v = middle_v - reach; v <= middle_v + reach; ++v) {
    for (int u = middle_u - reach; u <= middle_u + reach; ++u) {
      const bool is_inside = u >= 0 && v >= 0 && u < static_cast<int>(image.width_px) &&
                             v < static_cast<int>(image.height_px) &&
                             std::hypot(u - place.u, v - place.v) <= radius_px + 0.5;
      if (!is_inside) continue;
      const std::size_t i =
          static_cast<std::size_t>(v) * image.width_px + static_cast<std::size_t>(u);
      const Chroma chroma = pixels.chroma(i);
      found.push_back({pixels.luminance(i), chroma.u, chroma.v});
    }
  }
  return found;
}

Result<ColourParameters, ColourConflict> colours_from(const ColourParameters& before,
                                                      const std::vector<LabelledColours>& places) {
  const std::vector<LabelledColours> labels = pooled(places);
  ColourParameters colours = before;
  std::vector<ColourSample> discs;
  std::vector<Hues> hues;
  for (const LabelledColours& label : labels) {
    if (!is_chromatic(label.colour)) continue;
    const auto is_same = [&](const auto& known) {
      return known.colour == label.colour;
    };
    std::erase_if(colours.samples, is_same);
    std::erase_if(colours.sectors, is_same);
    discs.push_back(disc_of(label));
    if (auto found = hues_of(label)) hues.push_back(*found);
  }
  std::vector<ColourSample> all = colours.samples;
  all.insert(all.end(), discs.begin(), discs.end());
  if (const auto conflict = first_conflict(all)) return failure(*conflict);
  for (const LabelledColours& label : labels) {
    if (!is_chromatic(label.colour)) continue;
    for (ColourSample& disc : colours.samples) give_way(disc, label);
  }
  for (std::size_t i = 0; i < hues.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) part(hues[i], hues[j]);
  }
  std::ranges::transform(hues, std::inserter(colours.sectors, colours.sectors.begin()), sector_of);
  std::ranges::copy_if(discs, std::back_inserter(colours.samples), [&](const ColourSample& disc) {
    return std::ranges::find(hues, disc.colour, &Hues::colour) == hues.end();
  });
  set_luminance(labels, colours);
  if (colours.black_max_y >= colours.white_min_y) {
    return failure(ColourConflict{ColourClass::kBlack, ColourClass::kWhite, 0.0});
  }
  return colours;
}

std::optional<FieldColours> field_colours(const ImageView& image,
                                          const Pixel& centre,
                                          double inner_px,
                                          double outer_px) {
  const auto found = FieldColourMeter().measure(floor_pixels(image, centre, inner_px, outer_px));
  return found && !is_saturated(found->white) ? found : std::nullopt;
}

ColourParameters balanced(const ColourParameters& before, const FieldColours& now) {
  const Eigen::Vector3d white = rgb_of(now.white.y, now.white.u, now.white.v).cwiseMax(1.0);
  const Eigen::Vector3d gains = white / white.mean();
  const auto carried = [&](double u, double v) -> Eigen::Vector2d {
    return chroma_of(typical_rgb(u, v).cwiseProduct(gains));
  };
  const auto turned = [&](double hue) {
    const Eigen::Vector2d chroma =
        carried(128.0 + kTypicalChroma * std::cos(hue), 128.0 + kTypicalChroma * std::sin(hue));
    return std::atan2(chroma.y() - 128.0, chroma.x() - 128.0);
  };
  ColourParameters colours = before;
  for (ColourSample& sample : colours.samples) {
    const Eigen::Vector2d chroma = carried(sample.u, sample.v);
    sample.u = byte(chroma.x());
    sample.v = byte(chroma.y());
  }
  for (HueSector& sector : colours.sectors) {
    const double from = sector.from + angle_difference(sector.from, turned(sector.from));
    sector.to += angle_difference(sector.to, turned(sector.to));
    sector.from = std::min(from, sector.to);
  }
  const auto is_green = [](const ColourSample& sample) {
    return sample.colour == ColourClass::kGreen;
  };
  const auto green = std::ranges::find_if(colours.samples, is_green);
  ColourSample carpet{ColourClass::kGreen, now.green.u, now.green.v, 20};
  if (green != colours.samples.end()) carpet.radius = green->radius;
  std::erase_if(colours.samples, is_green);
  colours.samples.insert(colours.samples.begin(), carpet);
  colours.white_min_y = byte(0.5 * (now.green.y + now.white.y));
  colours.black_max_y = std::min(colours.black_max_y, byte(0.6 * now.green.y));
  return colours;
}

}  // namespace teamsight::vision

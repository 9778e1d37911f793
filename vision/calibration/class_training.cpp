// vision/calibration/class_training.cpp: densities on the table's own grid.
#include "vision/calibration/class_training.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <set>

#include "geometry/expect.hpp"
#include "vision/colour_classes.hpp"

namespace teamsight::vision {

namespace {

constexpr std::size_t kSide = 64;  // cells of each axis
constexpr double kCell = 4.0;      // grey levels

using Density = std::vector<float>;  // of each cell

/// Half of a normal distribution's bell, from its middle on; its sum over both sides is 1.
std::vector<float> bell_of(double sigma_cells) {
  std::vector<float> bell;
  const auto reach = static_cast<int>(std::ceil(3.0 * sigma_cells));
  double sum = 0.0;
  for (int i = 0; i <= reach; ++i) {
    const double value = std::exp(-0.5 * i * i / (sigma_cells * sigma_cells));
    sum += i == 0 ? value : 2.0 * value;
    bell.push_back(static_cast<float>(value));
  }
  for (float& value : bell) value /= static_cast<float>(sum);
  return bell;
}

/// Of the bell around cell `centre` of a line; what lies outside counts as nothing.
float blurred(const std::vector<float>& line, std::size_t centre, const std::vector<float>& bell) {
  float sum = bell[0] * line[centre];
  for (std::size_t k = 1; k < bell.size(); ++k) {
    if (centre >= k) sum += bell[k] * line[centre - k];
    if (centre + k < line.size()) sum += bell[k] * line[centre + k];
  }
  return sum;
}

// Along one axis; `stride` is the step between its cells.
void blur(Density& density, std::size_t stride, const std::vector<float>& bell) {
  std::vector<float> line(kSide);
  for (std::size_t start = 0; start < density.size(); ++start) {
    if (start / stride % kSide != 0) continue;
    for (std::size_t i = 0; i < kSide; ++i) line[i] = density[start + i * stride];
    for (std::size_t i = 0; i < kSide; ++i) density[start + i * stride] = blurred(line, i, bell);
  }
}

/// Of a class; every place counts alike, however many pixels it has.
Density density_of(ColourClass colour,
                   const std::vector<LabelledColours>& places,
                   const std::vector<float>& bell) {
  Density density(kClassCells, 0.0F);
  const auto count = std::ranges::count(places, colour, &LabelledColours::colour);
  for (const LabelledColours& place : places) {
    if (place.colour != colour) continue;
    TEAMSIGHT_EXPECT(!place.pixels.empty());
    const float each = 1.0F / static_cast<float>(place.pixels.size()) / static_cast<float>(count);
    for (const SampledColour& pixel : place.pixels) density[class_cell(pixel)] += each;
  }
  for (const std::size_t stride : {std::size_t{1}, kSide, kSide * kSide}) {
    blur(density, stride, bell);
  }
  return density;
}

ClassTable table_of(const ColourParameters& before) {
  const ColourClasses colours(before);
  ClassTable table(kClassCells);
  for (std::size_t cell = 0; cell < table.size(); ++cell) {
    const auto middle = [&](unsigned shift) {
      return static_cast<std::uint8_t>((cell >> shift) % kSide * 4 + 2);
    };
    table[cell] = colours.of(SampledColour{middle(12), middle(6), middle(0)});
  }
  return table;
}

ColourClass table_class(ColourClass labelled) {
  const bool has_none = labelled == ColourClass::kWhite || labelled == ColourClass::kBlack;
  return has_none ? ColourClass::kNone : labelled;
}

}  // namespace

ClassTable train_classes(const ColourParameters& before,
                         const std::vector<LabelledColours>& places,
                         const ClassTrainingRules& rules) {
  const std::vector<float> bell = bell_of(rules.reach / kCell);
  ClassTable table = table_of(before);
  // Of one colour alone, the middle of the bell in all three directions.
  Density densest(kClassCells, static_cast<float>(rules.least) * bell[0] * bell[0] * bell[0]);
  std::set<ColourClass> labelled;
  for (const LabelledColours& place : places) labelled.insert(place.colour);
  for (const ColourClass colour : labelled) {
    const Density density = density_of(colour, places, bell);
    for (std::size_t cell = 0; cell < table.size(); ++cell) {
      if (density[cell] <= densest[cell]) continue;
      densest[cell] = density[cell];
      table[cell] = table_class(colour);
    }
  }
  return table;
}

}  // namespace teamsight::vision

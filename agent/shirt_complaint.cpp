// agent/shirt_complaint.cpp: see agent/shirt_complaint.hpp.
#include "agent/shirt_complaint.hpp"

namespace teamsight::agent {

namespace {

using vision::ColourClass;

std::string name_of(ColourClass colour) {
  switch (colour) {
    case ColourClass::kRed:
      return "RED";
    case ColourClass::kBlue:
      return "BLUE";
    case ColourClass::kMagenta:
      return "MAGENTA";
    case ColourClass::kCyan:
      return "CYAN";
    default:
      return "another colour";
  }
}

}  // namespace

std::string shirt_complaint(const vision::TeamShirts& shirts,
                            const vision::ColourParameters& colours) {
  const auto missing = [&](ColourClass colour) {
    return colour != ColourClass::kNone && !can_tell(colours, colour);
  };
  std::string names;
  if (missing(shirts.own)) names = name_of(shirts.own) + " (shirt)";
  if (missing(shirts.theirs)) {
    names += (names.empty() ? "" : " and ") + name_of(shirts.theirs) + " (opponent_shirt)";
  }
  if (names.empty()) return {};
  return "the camera file has no class " + names +
         " of the team file: add it to colours, or nobody is known by it";
}

}  // namespace teamsight::agent

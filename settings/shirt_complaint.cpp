// settings/shirt_complaint.cpp: see settings/shirt_complaint.hpp.
#include "settings/shirt_complaint.hpp"

#include "settings/camera_names.hpp"

namespace teamsight::settings {

namespace {

using vision::ColourClass;

// As a camera file names it.
std::string name_of(ColourClass colour) {
  return config::CameraFile::Colours::Class_Name(file_class_of(colour).value());
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

}  // namespace teamsight::settings

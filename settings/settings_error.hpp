// settings/settings_error.hpp: the one way a settings file refuses to load.
#pragma once

#include <stdexcept>

namespace teamsight::settings {

/// A settings file that cannot be used. what() is one line that names the file, the place, the
/// key, what was found and what was expected; `main` prints it and exits with 2.
class SettingsError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace teamsight::settings

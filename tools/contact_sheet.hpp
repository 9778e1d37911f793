// tools/contact_sheet.hpp: many pictures side by side, to look at all of them at once.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "tools/picture.hpp"

namespace teamsight::tools {

/// How a sheet is laid out.
struct SheetLayout {
  int columns{4};
  int rows{3};
  int tile_px{480};  ///< the larger side of each picture
};

/// Writes DIR/sheet-1.png, sheet-2.png and so on, row by row, with each picture's name under it.
class ContactSheets {
 public:
  /// @throws std::runtime_error if the folder cannot be made
  explicit ContactSheets(std::filesystem::path folder, const SheetLayout& layout = {});

  /// Makes the picture smaller if need be; a full sheet is written at once.
  ///
  /// @throws std::runtime_error if the file cannot be written
  void add(const Picture& picture, const std::string& name);

  /// Writes the last sheet, if anything is on it.
  ///
  /// @throws std::runtime_error if the file cannot be written
  void finish();

 private:
  std::filesystem::path folder_;
  SheetLayout layout_;
  Picture sheet_;
  int on_sheet_{0};
  int written_{0};
};

}  // namespace teamsight::tools

// settings/class_table_file.hpp: a camera's trained colour classes as a file.
#pragma once

#include <filesystem>
#include <string>

#include "vision/camera_parameters.hpp"

namespace teamsight::settings {

/// Reads a line that says what it is, then one byte per cell.
///
/// @throws SettingsError naming the file and what was found
[[nodiscard]] vision::ClassTable read_class_table(const std::filesystem::path& path);

/// The bytes that read_class_table reads back.
///
/// @pre table.size() is vision::kClassCells
[[nodiscard]] std::string class_table_bytes(const vision::ClassTable& table);

}  // namespace teamsight::settings

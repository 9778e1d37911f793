// tests/realdata/zip_file.hpp: takes real data out of a ZIP file.
#pragma once

#include <filesystem>

namespace teamsight::test {

/// Writes every file of an archive (stored or deflated) into a folder, under its own name without
/// folders.
///
/// @throws std::runtime_error if it cannot be read, or is packed in another way
void unzip(const std::filesystem::path& archive, const std::filesystem::path& folder);

}  // namespace teamsight::test

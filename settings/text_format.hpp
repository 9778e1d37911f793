// settings/text_format.hpp: protobuf text files, parsed and checked against the schema's ranges.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

#include <google/protobuf/message.h>
#include <google/protobuf/text_format.h>

#include "settings/settings_error.hpp"

namespace teamsight::settings {

/// A settings file whose message was read, and which still knows on which line each key stands.
class TextFile {
 public:
  /// Parses `path` into `message` and checks that every required key is there, every number finite
  /// and within the (range) of its field in idl/config.proto.
  ///
  /// @param message  empty, of the file's type; must outlive the TextFile
  /// @throws SettingsError at the first thing that is wrong
  [[nodiscard]] static TextFile read(const std::filesystem::path& path,
                                     google::protobuf::Message& message);

  /// The complaint about one key that makes no sense although it is well formed.
  ///
  /// @param key  path of the key, e.g. `radial_table.row[2].radius_px`; the nearest enclosing key
  ///             that stands in the file gives the line
  [[nodiscard]] SettingsError error(std::string_view key,
                                    std::string_view found,
                                    std::string_view expected) const;

  /// The absolute path of a file that is named relative to this one.
  ///
  /// @throws SettingsError if there is no such file
  [[nodiscard]] std::filesystem::path resolve(std::string_view key,
                                              const std::string& relative) const;

  /// The same for a folder.
  [[nodiscard]] std::filesystem::path resolve_folder(std::string_view key,
                                                     const std::string& relative) const;

 private:
  TextFile(std::filesystem::path path, const google::protobuf::Message& message);

  std::filesystem::path path_;
  const google::protobuf::Message* message_;
  std::unique_ptr<google::protobuf::TextFormat::ParseInfoTree> places_;
};

/// `[index]` behind a key: `key_of("row", 2)` is `row[2]`.
[[nodiscard]] std::string key_of(std::string_view name, int index);

/// A number as a person would write it.
[[nodiscard]] std::string text_of(double number);

}  // namespace teamsight::settings

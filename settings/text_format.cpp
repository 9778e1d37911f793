// settings/text_format.cpp: reads a text file, and finds the line of a key for a complaint.
#include "settings/text_format.hpp"

#include <array>
#include <charconv>
#include <fstream>
#include <iterator>
#include <optional>
#include <sstream>
#include <utility>

#include <google/protobuf/io/tokenizer.h>

#include "settings/schema_check.hpp"
#include "settings/syntax_fault.hpp"

namespace teamsight::settings {

namespace {

using google::protobuf::TextFormat;
using Place = TextFormat::ParseLocation;

SettingsError complaint(const std::filesystem::path& path, Place place, const SchemaFault& fault) {
  const std::string key = fault.key.empty() ? "" : "key '" + fault.key + "': ";
  return SettingsError(path.string() + ":" + std::to_string(place.line + 1) + ":" +
                       std::to_string(place.column + 1) + ": " + key + "found " + fault.found +
                       ", expected " + fault.expected);
}

// Keeps the parser's first complaint; those that follow are mostly its consequences.
class FirstError : public google::protobuf::io::ErrorCollector {
 public:
  void AddError(int line, int column, const std::string& message) override {
    if (!first_) first_ = SyntaxFault{{{}, message, {}}, line, column};
  }

  [[nodiscard]] const std::optional<SyntaxFault>& first() const { return first_; }

 private:
  std::optional<SyntaxFault> first_;
};

std::string text_in(const std::filesystem::path& path) {
  std::error_code ignored;
  std::ifstream file(path, std::ios::binary);
  if (!file || !std::filesystem::is_regular_file(path, ignored)) {
    throw complaint(
        path, {0, 0}, {"", "no readable file", "a settings file in protobuf text format"});
  }
  std::ostringstream text;  // not istreambuf_iterator: GCC 12 warns of its inside at -O2
  text << file.rdbuf();
  return text.str();
}

// Splits `row[2]` into name and index; -1 for a key that stands alone.
std::pair<std::string, int> name_and_index(std::string_view step) {
  const std::size_t bracket = step.find('[');
  if (bracket == std::string_view::npos) return {std::string(step), -1};
  int index = 0;
  std::from_chars(step.data() + bracket + 1, step.data() + step.size(), index);
  return {std::string(step.substr(0, bracket)), index};
}

// The place of one key; a list in brackets has only one place, that of its first value.
Place place_in(const TextFormat::ParseInfoTree& tree,
               const google::protobuf::FieldDescriptor& field,
               int index) {
  Place place = tree.GetLocation(&field, index);
  while (place.line < 0 && index > 0) place = tree.GetLocation(&field, --index);
  return place;
}

// The place of the deepest key on the way to `key` that stands in the file.
Place place_of(const google::protobuf::Descriptor* type,
               TextFormat::ParseInfoTree* tree,
               std::string_view key) {
  Place best{0, 0};
  while (!key.empty() && tree != nullptr && type != nullptr) {
    const std::size_t dot = key.find('.');
    const auto [name, index] = name_and_index(key.substr(0, dot));
    key.remove_prefix(dot == std::string_view::npos ? key.size() : dot + 1);
    const google::protobuf::FieldDescriptor* field = type->FindFieldByName(name);
    if (field == nullptr || field->is_repeated() != (index >= 0)) break;
    const Place place = place_in(*tree, *field, index);
    if (place.line < 0) break;
    best = place;
    type = field->message_type();
    tree = type == nullptr ? nullptr : tree->GetTreeForNested(field, index);
  }
  return best;
}

}  // namespace

TextFile::TextFile(std::filesystem::path path, const google::protobuf::Message& message)
    : path_(std::move(path)),
      message_(&message),
      places_(std::make_unique<TextFormat::ParseInfoTree>()) {}

TextFile TextFile::read(const std::filesystem::path& path, google::protobuf::Message& message) {
  const std::string text = text_in(path);
  TextFile file(path, message);
  FirstError errors;
  TextFormat::Parser parser;
  parser.RecordErrorsTo(&errors);
  parser.WriteLocationsTo(file.places_.get());
  parser.AllowPartialMessage(true);  // first_fault names the missing key and its place
  const bool parsed = parser.ParseFromString(text, &message);
  if (errors.first()) {
    const SyntaxFault fault = syntax_fault(*message.GetDescriptor(), text, *errors.first());
    throw complaint(path, {fault.line, fault.column}, fault);
  }
  if (!parsed) throw complaint(path, {0, 0}, {"", "something else", "protobuf text format"});
  if (const auto fault = first_fault(message)) {
    throw file.error(fault->key, fault->found, fault->expected);
  }
  return file;
}

SettingsError TextFile::error(std::string_view key,
                              std::string_view found,
                              std::string_view expected) const {
  return complaint(path_,
                   place_of(message_->GetDescriptor(), places_.get(), key),
                   {std::string(key), std::string(found), std::string(expected)});
}

std::filesystem::path TextFile::resolve(std::string_view key, const std::string& relative) const {
  std::filesystem::path full =
      std::filesystem::absolute(path_.parent_path() / relative).lexically_normal();
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(full, ignored)) {
    throw error(key, "no file " + full.string(), "the path of a file, relative to this one");
  }
  return full;
}

std::filesystem::path TextFile::resolve_folder(std::string_view key,
                                               const std::string& relative) const {
  std::filesystem::path full =
      std::filesystem::absolute(path_.parent_path() / relative).lexically_normal();
  std::error_code ignored;
  if (!std::filesystem::is_directory(full, ignored)) {
    throw error(key, "no folder " + full.string(), "the path of a folder, relative to this file");
  }
  return full;
}

std::string key_of(std::string_view name, int index) {
  return std::string(name) + "[" + std::to_string(index) + "]";
}

std::string text_of(double number) {
  std::array<char, 32> digits{};
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), number);
  return {digits.data(), end.ptr};
}

}  // namespace teamsight::settings

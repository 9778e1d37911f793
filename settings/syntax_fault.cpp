// settings/syntax_fault.cpp: finds the key at a place in a text file, and rewords the parser.
#include "settings/syntax_fault.hpp"

#include <algorithm>
#include <cctype>
#include <optional>
#include <regex>
#include <string_view>
#include <vector>

namespace teamsight::settings {

namespace {

using google::protobuf::Descriptor;
using google::protobuf::FieldDescriptor;

// Offset of a place that the parser names by line and column, both from 0.
std::size_t offset_of(const std::string& text, int line, int column) {
  constexpr int kTab = 8;
  std::size_t at = 0;
  for (int i = 0; i < line && at < text.size(); ++i) {
    at = std::min(text.find('\n', at), text.size() - 1) + 1;
  }
  for (int i = 0; i < column && at < text.size(); ++at) {
    i += text[at] == '\t' ? kTab - i % kTab : 1;
  }
  return at;
}

bool is_word(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

// Behind the comment or quoted text that starts at `at`; `at` itself if none does.
std::size_t skip_opaque(std::string_view text, std::size_t at) {
  if (text[at] == '#') return std::min(text.find('\n', at), text.size());
  if (text[at] != '"' && text[at] != '\'') return at;
  std::size_t end = at + 1;
  while (end < text.size() && text[end] != text[at] && text[end] != '\n') {
    end += text[end] == '\\' ? 2U : 1U;
  }
  return std::min(end + 1, text.size());
}

// Keeps account of the blocks that are open and of the key that was named last.
class KeyTrail {
 public:
  // Reads the text up to `end`; the word that starts there belongs to it.
  void read(std::string_view text, std::size_t end) {
    for (std::size_t at = 0; at < text.size() && at <= end;) {
      const std::size_t behind = skip_opaque(text, at);
      at = behind != at ? behind : read_token(text, at, end);
    }
  }

  [[nodiscard]] const std::vector<std::string>& open() const { return open_; }

  [[nodiscard]] const std::string& key() const { return key_; }

 private:
  std::size_t read_token(std::string_view text, std::size_t at, std::size_t end) {
    const char c = text[at];
    if (is_word(c)) return read_word(text, at);
    if (at == end) return at + 1;  // the complaint is about this sign: it opens or closes nothing
    if (c == ':') after_colon_ = true;
    if (c == '{' || c == '<') open_.push_back(key_);
    if ((c == '}' || c == '>') && !open_.empty()) open_.pop_back();
    if (c == '{' || c == '<' || c == '}' || c == '>') {
      key_.clear();
      after_colon_ = false;
    }
    return at + 1;
  }

  std::size_t read_word(std::string_view text, std::size_t at) {
    std::size_t behind = at;
    while (behind < text.size() && (is_word(text[behind]) || text[behind] == '.')) ++behind;
    if (!after_colon_) key_ = text.substr(at, behind - at);
    after_colon_ = false;
    return behind;
  }

  std::vector<std::string> open_;
  std::string key_;
  bool after_colon_{false};
};

const Descriptor* type_inside(const Descriptor& type, const std::vector<std::string>& keys) {
  const Descriptor* here = &type;
  for (const std::string& key : keys) {
    const FieldDescriptor* field = here->FindFieldByName(key);
    if (field == nullptr || field->message_type() == nullptr) return nullptr;
    here = field->message_type();
  }
  return here;
}

std::string expected_of(const Descriptor* type, const std::string& key, const char* otherwise) {
  const FieldDescriptor* field = type == nullptr ? nullptr : type->FindFieldByName(key);
  return field == nullptr ? otherwise : expected_value(*field);
}

struct Wording {
  const char* pattern;   // of protobuf's message
  const char* found;     // $1 is the first group
  const char* expected;  // empty: what the key takes
};

// The first that matches counts.
constexpr Wording kWordings[] = {
    {R"re(Non-repeated field "(.*)" is specified multiple times\.)re",
     "a second value",
     "one value"},
    {R"re(Field "(.*)" is specified along with field "(.*)", another member of oneof.*)re",
     "'$1' besides '$2'",
     "only one of the two"},
    {R"re(Unknown enumeration value of "(.*)" for field .*)re", "'$1'", ""},
    {R"re(Integer out of range \((.*)\).*)re", "$1", ""},
    {R"re(Invalid value for boolean field .* Value: "(.*)"\.)re", "'$1'", ""},
    {R"re(Expected (?:integer|double|string|identifier), got: (.+))re", "'$1'", ""},
    {R"re(Expected (.*), found "(.*)"\.)re", "'$2'", "$1"},
    {R"re(Expected (.*), got: (.*))re", "'$2'", "$1"},
};

std::optional<SchemaFault> reworded(const std::string& message,
                                    const Descriptor* type,
                                    const std::string& key) {
  for (const Wording& wording : kWordings) {
    std::smatch match;
    if (!std::regex_match(message, match, std::regex(wording.pattern))) continue;
    const std::string expected = match.format(wording.expected);
    return SchemaFault{{},
                       match.format(wording.found),
                       expected.empty() ? expected_of(type, key, "a key") : expected};
  }
  return std::nullopt;
}

}  // namespace

SchemaFault syntax_fault(const Descriptor& type,
                         const std::string& text,
                         int line,
                         int column,
                         const std::string& message) {
  KeyTrail trail;
  trail.read(text, offset_of(text, line, column));
  const Descriptor* here = type_inside(type, trail.open());
  std::smatch unknown;
  static const std::regex kUnknownKey(R"re(Message type ".*" has no field named "(.*)"\.)re");
  const bool is_unknown = std::regex_match(message, unknown, kUnknownKey);

  SchemaFault fault{{}, message, "protobuf text format"};
  if (is_unknown) {
    fault = {{}, "an unknown key", "one of " + (here ? expected_keys(*here) : "the keys above")};
  } else if (auto words = reworded(message, here, trail.key())) {
    fault = *std::move(words);
  }
  for (const std::string& outer : trail.open()) fault.key += outer + ".";
  fault.key += is_unknown ? unknown[1].str() : trail.key();
  if (!fault.key.empty() && fault.key.back() == '.') fault.key.pop_back();
  return fault;
}

}  // namespace teamsight::settings

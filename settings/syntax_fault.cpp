// settings/syntax_fault.cpp: finds the key at a place in a text file, and rewords the parser.
#include "settings/syntax_fault.hpp"

#include <algorithm>
#include <cctype>
#include <regex>
#include <string_view>
#include <vector>

namespace teamsight::settings {

namespace {

using google::protobuf::Descriptor;
using google::protobuf::FieldDescriptor;

constexpr int kTab = 8;  // protobuf counts a tab up to the next multiple

// Offset of a place that the parser names by line and column, both from 0.
std::size_t offset_of(const std::string& text, int line, int column) {
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

// Keeps account of the blocks that are open, of the key named last, and of where the last word is.
class KeyTrail {
 public:
  // Reads up to where the parser complained; what starts there is not read any more.
  explicit KeyTrail(std::string_view text) {
    for (std::size_t at = 0; at < text.size();) {
      const std::size_t behind = skip_opaque(text, at);
      if (behind != at && text[at] != '#') after_colon_ = false;  // a quoted value
      at = behind != at ? behind : read_token(text, at);
    }
  }

  [[nodiscard]] const std::vector<std::string>& open() const { return open_; }

  [[nodiscard]] const std::string& key() const { return key_; }

  [[nodiscard]] std::size_t last_word() const { return last_word_; }

 private:
  std::size_t read_token(std::string_view text, std::size_t at) {
    const char c = text[at];
    if (is_word(c)) return read_word(text, at);
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
    last_word_ = at;
    return behind;
  }

  std::vector<std::string> open_;
  std::string key_;
  std::size_t last_word_{0};
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

struct Wording {
  const char* pattern;   // of protobuf's message
  const char* found;     // $1 is the first group
  const char* expected;  // empty: what the key takes
  bool is_late;          // the parser had already gone on to the next word
};

// The first that matches counts.
constexpr Wording kWordings[] = {
    {R"re(Message type ".*" has no field named "(.*)"\.)re", "an unknown key", "keys", true},
    {R"re(Non-repeated field "(.*)" is specified multiple times\.)re",
     "a second value",
     "one value",
     true},
    {R"re(Field "(.*)" is specified along with field "(.*)", another member of oneof.*)re",
     "'$1' besides '$2'",
     "only one of the two",
     true},
    {R"re(Unknown enumeration value of "(.*)" for field .*)re", "'$1'", "", true},
    {R"re(Invalid value for boolean field .* Value: "(.*)"\.)re", "'$1'", "", true},
    {R"re(Integer out of range \((.*)\).*)re", "$1", "", false},
    {R"re(Expected (?:integer|double|string|identifier), got: (.+))re", "'$1'", "", false},
    {R"re(Expected (.*), found "(.*)"\.)re", "'$2'", "$1", false},
    {R"re(Expected (.*), got: (.*))re", "'$2'", "$1", false},
};

constexpr std::string_view kKeys = "keys";  // in place of the keys that the block takes

std::string expected_of(const std::string& wanted, const Descriptor* type, const std::string& key) {
  if (!wanted.empty() && wanted != kKeys) return wanted;
  if (type == nullptr) return "a key of this block";
  const FieldDescriptor* field = type->FindFieldByName(key);
  return field == nullptr || wanted == kKeys ? "one of " + expected_keys(*type)
                                             : expected_value(*field);
}

// Sets line and column to a place in the text.
void move_to(SyntaxFault& fault, std::string_view text, std::size_t at) {
  const std::string_view before = text.substr(0, at);
  fault.line = static_cast<int>(std::ranges::count(before, '\n'));
  const std::size_t line_start = before.rfind('\n') + 1;  // 0 if there is none
  fault.column = 0;
  for (const char c : before.substr(line_start)) {
    fault.column += c == '\t' ? kTab - fault.column % kTab : 1;
  }
}

}  // namespace

SyntaxFault syntax_fault(const Descriptor& type,
                         const std::string& text,
                         const SyntaxFault& complaint) {
  const std::size_t at = offset_of(text, complaint.line, complaint.column);
  const KeyTrail trail(std::string_view(text).substr(0, at));
  const Descriptor* here = type_inside(type, trail.open());
  SyntaxFault fault = complaint;
  fault.found = "what the parser refuses (" +
                complaint.found.substr(0, complaint.found.find_last_not_of('.') + 1) + ")";
  fault.expected = "protobuf text format";
  for (const Wording& wording : kWordings) {
    std::smatch match;
    if (!std::regex_match(complaint.found, match, std::regex(wording.pattern))) continue;
    fault.found = match.format(wording.found);
    fault.expected = expected_of(match.format(wording.expected), here, trail.key());
    if (wording.is_late) move_to(fault, text, trail.last_word());
    break;
  }
  for (const std::string& outer : trail.open()) fault.key += outer + ".";
  fault.key += trail.key();
  if (!fault.key.empty() && fault.key.back() == '.') fault.key.pop_back();
  return fault;
}

}  // namespace teamsight::settings

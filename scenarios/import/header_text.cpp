#include "scenarios/import/header_text.h"

namespace cusp::scenarios {
namespace {

constexpr std::string_view kBlanks = " \t";

/// By table 3-7 of the Unicode standard: no overlong form, no surrogate, nothing beyond U+10FFFF.
bool is_utf8(std::string_view t) {
  std::size_t i = 0;
  const auto byte = [&](std::size_t at) { return at < t.size() ? static_cast<unsigned char>(t[at]) : 0u; };
  while (i < t.size()) {
    const unsigned first = byte(i), second = byte(i + 1);
    if ((first >= 0x80 && first < 0xc2) || first >= 0xf5) return false;
    const std::size_t length = first < 0x80 ? 1 : first < 0xe0 ? 2 : first < 0xf0 ? 3 : 4;
    for (std::size_t k = 1; k < length; ++k)
      if ((byte(i + k) & 0xc0) != 0x80) return false;
    if ((first == 0xe0 && second < 0xa0) || (first == 0xed && second >= 0xa0)) return false;
    if ((first == 0xf0 && second < 0x90) || (first == 0xf4 && second >= 0x90)) return false;
    i += length;
  }
  return true;
}

}  // namespace

std::string_view trimmed(std::string_view t) {
  const auto first = t.find_first_not_of(kBlanks);
  if (first == t.npos) return {};
  return t.substr(first, t.find_last_not_of(kBlanks) - first + 1);
}

std::string lower(std::string_view t) {
  std::string out(t);
  for (char& c : out)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return out;
}

std::vector<std::string_view> tokens(std::string_view t) {
  std::vector<std::string_view> out;
  std::size_t i = 0;
  while ((i = t.find_first_not_of(kBlanks, i)) != t.npos) {
    std::size_t end = t[i] == '(' ? t.find(')', i) : t.find_first_of(kBlanks, i);
    if (end == t.npos) end = t.size();
    else if (t[i] == '(') ++end;
    out.push_back(t.substr(i, end - i));
    i = end;
  }
  return out;
}

std::optional<double> number(std::string_view t) {
  t = trimmed(t);
  if (t.starts_with('+')) t.remove_prefix(1);
  double value = 0;
  const auto [end, error] = std::from_chars(t.data(), t.data() + t.size(), value);
  if (error != std::errc{} || end != t.data() + t.size()) return std::nullopt;
  return value;
}

std::string utf8_name(std::string_view t) {
  if (is_utf8(t)) return std::string(t);
  std::string out;
  for (const char c : t) {
    const auto code = static_cast<unsigned char>(c);
    if (code < 0x80) {
      out += c;
    } else {
      out += static_cast<char>(0xc0 | code >> 6);
      out += static_cast<char>(0x80 | (code & 0x3f));
    }
  }
  return out;
}

std::string exact(double value) {
  char buffer[32];
  const auto end = std::to_chars(buffer, buffer + sizeof buffer, value).ptr;
  return std::string(buffer, end);
}

}  // namespace cusp::scenarios

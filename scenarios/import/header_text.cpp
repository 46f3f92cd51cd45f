#include "scenarios/import/header_text.h"

namespace cusp::scenarios {
namespace {

constexpr std::string_view kBlanks = " \t";

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

std::string exact(double value) {
  char buffer[32];
  const auto end = std::to_chars(buffer, buffer + sizeof buffer, value).ptr;
  return std::string(buffer, end);
}

}  // namespace cusp::scenarios

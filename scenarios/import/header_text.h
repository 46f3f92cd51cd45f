/// Parts of text headers: tokens and numbers, independent of the locale.
#pragma once

#include <charconv>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace cusp::scenarios {

/// Without blanks and tabs at both ends.
std::string_view trimmed(std::string_view t);
/// ASCII letters only.
std::string lower(std::string_view t);
/// Parts between blanks; a parenthesis is one token.
std::vector<std::string_view> tokens(std::string_view t);
/// A leading + is read; "nan" in any case is a NaN, and nothing but a number may stand there.
std::optional<double> number(std::string_view t);
/// Whole, with nothing behind it.
template <class Whole>
std::optional<Whole> whole_number(std::string_view t) {
  Whole value{};
  const auto [end, error] = std::from_chars(t.data(), t.data() + t.size(), value);
  if (error != std::errc{} || end != t.data() + t.size()) return std::nullopt;
  return value;
}
/// A name as UTF-8: one that is not is taken for ISO 8859-1, as older programs write it.
std::string utf8_name(std::string_view t);
/// The shortest text that reads back as the same number.
std::string exact(double value);

}  // namespace cusp::scenarios

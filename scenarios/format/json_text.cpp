#include "scenarios/format/json_text.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <charconv>
#include <cmath>
#include <set>
#include <vector>

#include <nlohmann/json.hpp>

#include "scenarios/format/read.h"

namespace cusp::scenarios::json_text {
namespace {

/// "line:column" of a byte, both from 1; the column counts characters, not bytes of UTF-8.
std::string place_of(std::string_view text, std::size_t byte) {
  const std::string_view before = text.substr(0, std::min(byte, text.size()));
  std::size_t line = 1;
  std::size_t column = 1;
  for (const char c : before) {
    if (c == '\n') {
      ++line;
      column = 1;
    } else if ((static_cast<unsigned char>(c) & 0xc0) != 0x80) {
      ++column;
    }
  }
  return std::to_string(line) + ":" + std::to_string(column);
}

/// True if the token at this byte is NaN or an infinity as other languages spell them.
bool names_non_finite(std::string_view text, std::size_t byte) {
  const auto letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
  std::size_t begin = std::min(byte, text.size());
  while (begin > 0 && letter(text[begin - 1])) --begin;
  std::size_t end = begin;
  while (end < text.size() && letter(text[end])) ++end;
  std::string token(text.substr(begin, end - begin));
  std::transform(token.begin(), token.end(), token.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  return token == "nan" || token == "inf" || token == "infinity";
}

/// An object or array that is being parsed.
struct Level {
  bool object = false;
  std::string key{};      // last one seen
  std::size_t items = 0;  // values begun
  std::set<std::string> keys{};
};

std::string pointer_of(const std::vector<Level>& levels) {
  std::string out;
  for (const Level& level : levels) {
    out += level.object ? pointer_step(level.key) : "/" + std::to_string(level.items - 1);
  }
  return out;
}

struct Refused {
  FormatError code;
  std::string where;
};

}  // namespace

Result<nlohmann::json, FormatFailure> parse(std::string_view text) {
  if (text.size() > kMaxScenarioBytes) return fail(FormatError::too_large, "1:1");
  using nlohmann::json;
  std::vector<Level> levels;
  const json::parser_callback_t look = [&levels](int, json::parse_event_t event, json& parsed) {
    using Event = json::parse_event_t;
    if (event == Event::object_end || event == Event::array_end) {
      levels.pop_back();
    } else if (event == Event::key) {
      levels.back().key = parsed.get_ref<const std::string&>();
      if (!levels.back().keys.insert(levels.back().key).second)
        throw Refused{FormatError::duplicate_key, pointer_of(levels)};
    } else {
      if (!levels.empty()) ++levels.back().items;
      if (event == Event::value) return true;
      if (levels.size() >= kMaxDepth) throw Refused{FormatError::too_large, pointer_of(levels)};
      levels.push_back({.object = event == Event::object_start});
    }
    return true;
  };
  try {
    return json::parse(text.begin(), text.end(), look);
  } catch (const Refused& refused) {
    return fail(refused.code, refused.where);
  } catch (const json::parse_error& error) {
    const std::size_t byte = error.byte > 0 ? error.byte - 1 : 0;
    const FormatError code = names_non_finite(text, byte) ? FormatError::not_finite : FormatError::broken_json;
    return fail(code, place_of(text, byte), error.what());
  } catch (const json::exception& error) {
    // The only other one: a number beyond double; its text stands between quotes in the message.
    const std::string what = error.what();
    const std::size_t open = what.find('\'');
    const std::size_t close = what.rfind('\'');
    std::size_t at = 0;
    if (open != std::string::npos && close > open) {
      at = text.find(what.substr(open + 1, close - open - 1));
    }
    return fail(FormatError::not_finite, place_of(text, at == std::string_view::npos ? 0 : at), what);
  }
}

void append_number(std::string& out, double value) {
  assert(std::isfinite(value));
  std::array<char, 32> digits;
  // Below 2^53 every whole double is exactly that integer.
  const bool whole = std::abs(value) < 9007199254740992.0 && value == std::floor(value);
  const auto end = whole ? std::to_chars(digits.data(), digits.data() + digits.size(), static_cast<long long>(value))
                         : std::to_chars(digits.data(), digits.data() + digits.size(), value);
  out.append(digits.data(), end.ptr);
}

void append_string(std::string& out, const std::string& value) {
  out += nlohmann::json(value).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

std::string pointer_step(std::string_view key) {
  std::string out = "/";
  for (const char c : key) {
    if (c == '~') {
      out += "~0";
    } else if (c == '/') {
      out += "~1";
    } else {
      out += c;
    }
  }
  return out;
}

}  // namespace cusp::scenarios::json_text

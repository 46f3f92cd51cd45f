/// JSON text <-> nlohmann document, with places and limits. Inside of scenarios/format.
#pragma once

#include <algorithm>
#include <string>
#include <string_view>

#include <nlohmann/json_fwd.hpp>

#include "engine/base/result.h"
#include "scenarios/format/format_error.h"

namespace cusp::scenarios::json_text {

/// Parses; refuses duplicate keys, nesting beyond kMaxDepth and texts above kMaxScenarioBytes. Never throws.
Result<nlohmann::json, FormatFailure> parse(std::string_view text);

/// Shortest text that reads back the same; whole numbers without a point. Pre: finite.
void append_number(std::string& out, double value);

/// Escapes as JSON, UTF-8 as it is.
void append_string(std::string& out, const std::string& value);

/// One step of a JSON pointer, with ~ and / escaped (RFC 6901).
std::string pointer_step(std::string_view key);

/// Levels of arrays; an object counts as more than any line should hold.
template <class Json>
int array_depth(const Json& node) {
  if (node.is_object()) return 100;
  if (!node.is_array()) return 0;
  int deepest = 0;
  for (const Json& item : node) deepest = std::max(deepest, array_depth(item));
  return deepest + 1;
}

/// `indent` < 0: one line without blanks. Otherwise two blanks a level; a list of numbers, or of points, on one line.
template <class Json>
void append(std::string& out, const Json& node, int indent) {
  const bool pretty = indent >= 0;
  const auto line = [&out](int level) {
    out += '\n';
    out.append(static_cast<std::size_t>(level) * 2, ' ');
  };
  if (node.is_object()) {
    out += '{';
    bool first = true;
    for (auto it = node.begin(); it != node.end(); ++it) {
      if (!first) out += ',';
      first = false;
      if (pretty) line(indent + 1);
      append_string(out, it.key());
      out += pretty ? ": " : ":";
      append(out, it.value(), pretty ? indent + 1 : indent);
    }
    if (pretty && !first) line(indent);
    out += '}';
  } else if (node.is_array()) {
    const bool split = pretty && array_depth(node) > 2;
    out += '[';
    bool first = true;
    for (const Json& item : node) {
      if (!first) out += pretty && !split ? ", " : ",";
      first = false;
      if (split) line(indent + 1);
      append(out, item, pretty ? indent + 1 : indent);
    }
    if (split && !first) line(indent);
    out += ']';
  } else if (node.is_string()) {
    append_string(out, node.template get_ref<const std::string&>());
  } else if (node.is_number_float()) {
    append_number(out, node.template get<double>());
  } else {
    out += node.dump();
  }
}

}  // namespace cusp::scenarios::json_text

/// A sound scenario with one place changed, and the failure that it meets. For tests of the reader.
#pragma once

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "scenarios/format/read.h"
#include "scenarios/format/write.h"
#include "tests/modules.h"
#include "tests/scenarios/format/make_scenario.h"

namespace cusp::test {

using nlohmann::json;

inline json sound() { return json::parse(write_scenario(sound_scenario())); }

/// The failure that `text` meets; a scenario that reads is a failure of the test.
inline FormatFailure failure_of(const std::string& text) {
  const auto scenario = read_scenario(text);
  if (!scenario) return scenario.error();
  ADD_FAILURE() << "it was accepted: " << text;
  return {FormatError::unreadable, ""};
}

/// The sound scenario with one place changed.
inline FormatFailure with(const char* pointer, const json& value) {
  json document = sound();
  document[json::json_pointer(pointer)] = value;
  return failure_of(document.dump());
}

inline FormatFailure without(const char* parent, const char* key) {
  json document = sound();
  document[json::json_pointer(parent)].erase(key);
  return failure_of(document.dump());
}

}  // namespace cusp::test

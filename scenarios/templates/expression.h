/// Arithmetic in the templates' JSON: "central.z + mouth - depth", "max(cej.mesial.z + above_cej, floor - step)".
/// Thread: any.
#pragma once

#include <map>
#include <string>
#include <string_view>

#include "engine/base/result.h"
#include "scenarios/modules.h"

namespace cusp::scenarios {

/// Names to values: parameters of a template, landmarks of a tooth.
using Scope = std::map<std::string, double, std::less<>>;

enum class ExpressionError : std::uint8_t {
  syntax,        // where: the rest that was not understood
  unknown_name,  // where: the name
  not_finite,    // a division by zero, or a number beyond doubles
};

/// Numbers, names (letters, digits, '_' and '.'), + - * / and parentheses, min(a, b), max(a, b), and at_least(a, b): 1 or 0.
/// At most kMostNested deep.
[[nodiscard]] Result<double, Failure<ExpressionError>> evaluate(std::string_view text, const Scope& scope);
inline constexpr int kMostNested = 32;

}  // namespace cusp::scenarios

/// The drawing in a module's README, compared with the arrows that the includes make.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "tests/architecture/arrows.h"

namespace cusp::test {

/// The first fenced block of a README that holds an arrow; empty if there is none.
std::string drawing_of(std::string_view readme);

/// One sentence for each folder of `arrows` that `drawing` does not name, and for each include that runs against it. A
/// row with ▼ parts what includes (above) from what is included (below), a row with ▲ the other way round. Between two
/// folders of one row, ─► leads to what is included, ◄─ comes from what includes. A folder stands where its name occurs
/// first; `own` is the name under which the module's own files (".") are drawn, empty if there are none.
std::vector<std::string> against_drawing(const Arrows& arrows, std::string_view drawing, std::string_view own);

}  // namespace cusp::test

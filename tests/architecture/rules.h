/// The house's rules about includes, as a function of one file's path and text, so that tests can plant a violation.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace cusp::test {

/// One sentence for each include of `text` that the file at `path` (relative to the root) may not have.
std::vector<std::string> forbidden_includes(std::string_view path, std::string_view text);

}  // namespace cusp::test

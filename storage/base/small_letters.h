/// Small letters for capital ones, so that names are found whatever their case. Pure; any thread.
#pragma once

#include <string>
#include <string_view>

namespace cusp::storage {

/// Of Latin (Basic, Latin-1, Extended-A), Greek and Cyrillic, in UTF-8; both small sigmas become one. Everything else stays, also
/// bytes that are no UTF-8.
std::string small_letters(std::string_view text);

}  // namespace cusp::storage

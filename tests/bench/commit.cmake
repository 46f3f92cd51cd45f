# Writes OUT, a header with the commit of ROOT and a "+" if its files differ from it, unless OUT says so already.
cmake_path(GET ROOT PARENT_PATH above)
set(ENV{GIT_CEILING_DIRECTORIES} ${above})  # an unpacked archive is none of the repository about it
execute_process(COMMAND git -C ${ROOT} --no-optional-locks describe --always --abbrev=40 --exclude=* --dirty=+
                OUTPUT_VARIABLE commit OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
if(NOT commit)
  set(commit unknown)
endif()
file(CONFIGURE OUTPUT ${OUT} CONTENT [[
#pragma once

namespace cusp::bench {
inline constexpr const char* kCommit = "@commit@";
}
]] @ONLY)

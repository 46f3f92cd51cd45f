/// The rules about includes and about who opens a database's file, as functions of one file's path and text, so that
/// tests can plant a violation.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace cusp::test {

/// One sentence for each include of `text` that the file at `path` (relative to the root) may not have.
std::vector<std::string> forbidden_includes(std::string_view path, std::string_view text);

/// One sentence for each place of `text` that opens, copies, moves or removes a database's file, its log or its index
/// other than through SQLite. While a connection of the process stands, closing such a file drops the connection's locks,
/// and the next program deletes the live log ("How To Corrupt An SQLite Database File", 2.2). Below storage/ every
/// opening counts, whatever its file is called, except in the two files that name another; elsewhere those whose words
/// speak of a database, directly or by a variable that was set from such words in the same file.
std::vector<std::string> forbidden_openings(std::string_view path, const std::string& text);

}  // namespace cusp::test

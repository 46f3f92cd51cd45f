#include <algorithm>
#include <cctype>
#include <regex>
#include <set>

#include "tests/architecture/rules.h"

namespace cusp::test {
namespace {

bool word_letter(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

/// Comments become spaces; the lines stay.
std::string without_comments(std::string text) {
  bool quoted = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '"' && (i == 0 || (text[i - 1] != '\\' && text[i - 1] != '\''))) quoted = !quoted;
    if (text[i] == '\n') quoted = false;
    if (quoted || text[i] != '/' || i + 1 >= text.size() || (text[i + 1] != '/' && text[i + 1] != '*')) continue;
    const bool line = text[i + 1] == '/';
    const std::size_t end = std::min(line ? text.find('\n', i) : text.find("*/", i), text.size());
    std::fill(text.begin() + static_cast<std::ptrdiff_t>(i), text.begin() + static_cast<std::ptrdiff_t>(end), ' ');
    i = end;
  }
  return text;
}

/// The text between the bracket at `open` and its partner.
std::string bracketed(const std::string& text, std::size_t open) {
  int depth = 0;
  for (std::size_t i = open; i < text.size(); ++i) {
    depth += text[i] == '(' || text[i] == '{';
    depth -= text[i] == ')' || text[i] == '}';
    if (depth == 0) return text.substr(open, i - open + 1);
  }
  return text.substr(open);
}

/// Whether words speak of a database: database_, plan.database, db, "station.db", "-wal", or one of `set_from_one`.
bool speaks_of_database(const std::string& words, const std::set<std::string>& set_from_one) {
  static const std::regex kNames(R"((^|[^A-Za-z])(db|DB|[Dd]atabase)(_?$|_?[^A-Za-z_]|_(file|path|name))|\.db|-(wal|shm|journal)\b)");
  if (std::regex_search(words, kNames)) return true;
  static const std::regex kWord(R"([A-Za-z_]\w*)");
  for (std::sregex_iterator it(words.begin(), words.end(), kWord), end; it != end; ++it) {
    if (set_from_one.contains(it->str())) return true;
  }
  return false;
}

/// Variables of paths and texts that were set from words that speak of a database.
std::set<std::string> variables_of(const std::string& text) {
  static const std::regex kSet(
      R"((?:path|string|QString|auto|QByteArray)\s*[&*]?\s+([A-Za-z_]\w*)\s*(?:=\s*([^;]*);|[({]([^;]*)[)}]\s*;))");
  std::set<std::string> out;
  for (std::sregex_iterator it(text.begin(), text.end(), kSet), end; it != end; ++it) {
    const std::string value = (*it)[2].matched ? (*it)[2].str() : (*it)[3].str();
    // A connection, a store, a folder or a name for people is no file's name.
    static const std::regex kOther(R"(::open\(|Store|folder\(|tr\(|describe\(|\bshow|\[)");
    if (!std::regex_search(value, kOther) && speaks_of_database(value, out)) out.insert((*it)[1].str());
  }
  return out;
}

}  // namespace

std::vector<std::string> forbidden_openings(std::string_view path, const std::string& source) {
  const bool storage = path.starts_with("storage/");
  // The station's key, what the kernel says of processes and drives, folders alone, and key states, which have a folder of their own.
  static const std::set<std::string, std::less<>> kOthers = {"storage/base/files_linux.cpp", "storage/base/locked_folder_linux.cpp",
                                                             "storage/base/process_linux.cpp", "storage/cache/cache_files_linux.cpp"};
  if (kOthers.contains(path)) return {};
  // Whatever reads, writes, copies, moves, links or removes a file by its name.
  static const std::regex kCall(
      R"(\b([io]?fstream|fopen|freopen|QFile|QSaveFile|QFileDevice|copy_file|copy|rename|remove|resize_file|create_hard_link|sendfile|mmap|creat|openat|open|truncate|unlink|link)\b(::copy|::rename|::remove)?(\s+\w+)?\s*([({]))");
  std::vector<std::string> out;
  const std::string text = without_comments(source);
  const std::set<std::string> variables = storage ? std::set<std::string>{} : variables_of(text);
  for (std::sregex_iterator it(text.begin(), text.end(), kCall), end; it != end; ++it) {
    const std::string name = (*it)[1].str();
    const auto at = static_cast<std::size_t>(it->position(0));
    const auto open = static_cast<std::size_t>(it->position(4));
    // open(), copy() and so on are also members and functions of our own: only the system's and the library's count.
    static const std::set<std::string> kTypes = {"ifstream", "ofstream", "fstream", "QFile", "QSaveFile", "QFileDevice"};
    const bool type = kTypes.contains(name);
    if (!type) {
      const bool member = at > 0 && (text[at - 1] == '.' || text[at - 1] == '>');
      const bool scoped = at > 1 && text[at - 1] == ':' && text[at - 2] == ':';
      const bool library = scoped && (text.compare(at - std::min<std::size_t>(at, 4), 4, "fs::") == 0 ||
                                      text.compare(at - std::min<std::size_t>(at, 12), 12, "filesystem::") == 0 ||
                                      (at > 2 && !word_letter(text[at - 3])) ||
                                      text.compare(at - std::min<std::size_t>(at, 5), 5, "std::") == 0);
      if (member || (scoped && !library) || (*it)[3].matched) continue;
    }
    const std::string words = bracketed(text, open);
    // std::copy of elements takes iterators.
    if (name == "copy" && words.find("begin()") != std::string::npos) continue;
    // Below storage, SQLite alone opens files; what it left empty may be removed by name.
    const bool bad = storage ? type || name.find("open") != std::string::npos || name.find("copy") != std::string::npos
                             : speaks_of_database(words, variables);
    if (!bad || (storage && name == "open" && words.find("O_") == std::string::npos)) continue;
    const auto line = std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), '\n') + 1;
    out.push_back(std::string(path) + ":" + std::to_string(line) + ": " + name + words.substr(0, 60) +
                  " goes past SQLite to a database's file");
  }
  return out;
}

}  // namespace cusp::test

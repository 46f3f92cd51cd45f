#include "tests/architecture/rules.h"

#include <array>
#include <cctype>

namespace cusp::test {

namespace {

bool starts(std::string_view text, std::string_view with) { return text.substr(0, with.size()) == with; }
bool ends(std::string_view text, std::string_view with) {
  return text.size() >= with.size() && text.substr(text.size() - with.size()) == with;
}

/// What each module may include of the others; the longest matching folder counts.
struct ModuleRule {
  std::string_view folder;
  std::array<std::string_view, 6> may;
};
constexpr ModuleRule kRules[] = {
    {"engine/base/", {"engine/base/"}},
    {"engine/", {"engine/"}},
    {"device/", {"device/", "engine/base/"}},
    {"scenarios/", {"scenarios/", "engine/"}},
    {"storage/", {"storage/", "scenarios/", "engine/"}},
    {"ui/render/", {"ui/render/", "ui/modules.h", "scenarios/", "engine/"}},
    {"ui/session/", {"ui/session/", "ui/modules.h", "storage/", "scenarios/", "engine/", "device/"}},
    {"ui/", {"ui/", "storage/", "scenarios/", "engine/", "device/"}},
};

constexpr std::string_view kPlatform[] = {"unistd.h", "sched.h",  "pthread.h", "fcntl.h",  "dirent.h", "poll.h",
                                          "spawn.h",  "dlfcn.h",  "signal.h",  "termios.h", "mntent.h"};

bool is_qt(std::string_view header) {
  return (header.size() > 1 && header[0] == 'Q' && std::isupper(static_cast<unsigned char>(header[1]))) ||
         starts(header, "Qt");
}

}  // namespace

std::vector<std::string> forbidden_includes(std::string_view path, std::string_view text) {
  std::vector<std::string> out;
  const ModuleRule* rule = nullptr;
  for (const ModuleRule& r : kRules)
    if (starts(path, r.folder) && (rule == nullptr || r.folder.size() > rule->folder.size())) rule = &r;
  if (rule == nullptr) return out;
  const auto report = [&out, path](std::string_view header, std::string_view why) {
    out.push_back(std::string(path) + " includes " + std::string(header) + ": " + std::string(why));
  };

  std::size_t at = 0;
  while (at < text.size()) {
    std::size_t end = text.find('\n', at);
    if (end == std::string_view::npos) end = text.size();
    std::string_view line = text.substr(at, end - at);
    at = end + 1;
    while (!line.empty() && std::isspace(static_cast<unsigned char>(line.front()))) line.remove_prefix(1);
    if (line.empty() || line.front() != '#') continue;
    line.remove_prefix(1);
    while (!line.empty() && std::isspace(static_cast<unsigned char>(line.front()))) line.remove_prefix(1);
    if (!starts(line, "include")) continue;
    const std::size_t open = line.find_first_of("<\"");
    if (open == std::string_view::npos) continue;
    const bool quoted = line[open] == '"';
    const std::size_t close = line.find(quoted ? '"' : '>', open + 1);
    if (close == std::string_view::npos) continue;
    const std::string_view header = line.substr(open + 1, close - open - 1);

    if (quoted) {
      bool allowed = false;
      for (const std::string_view may : rule->may) allowed = allowed || (!may.empty() && starts(header, may));
      const bool ours = starts(header, "engine/") || starts(header, "device/") || starts(header, "scenarios/") ||
                        starts(header, "storage/") || starts(header, "ui/") || starts(header, "tests/");
      if (ours && !allowed) report(header, "an arrow that points the wrong way");
      continue;
    }
    if (is_qt(header) && (!starts(path, "ui/") || starts(path, "ui/session/") || starts(path, "ui/render/")))
      report(header, "Qt lives in ui alone, and not in ui/session and ui/render");
    if (header == "sqlite3.h" && !starts(path, "storage/sqlite/")) report(header, "only storage/sqlite speaks to SQLite");
    if (header.find("libusb") != std::string_view::npos && !starts(path, "device/falcon/transport_"))
      report(header, "only the Falcon's transport speaks to libusb");
    if (header.find("hidapi") != std::string_view::npos && !starts(path, "device/hid/transport_"))
      report(header, "only the HID transport speaks to hidapi");
    bool platform = starts(header, "sys/") || starts(header, "linux/");
    for (const std::string_view p : kPlatform) platform = platform || header == p;
    if (platform && !ends(path, "_linux.cpp") && path.find("/transport_") == std::string_view::npos)
      report(header, "platform headers stay in *_linux.cpp and transport files");
  }
  return out;
}

}  // namespace cusp::test

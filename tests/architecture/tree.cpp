// The tree as it stands: arrows, top level, READMEs, the licence, and the flags that determinism needs.
#include <gtest/gtest.h>

#include <cctype>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "tests/architecture/file_text.h"
#include "tests/architecture/rules.h"
#include "tests/source_dir.h"

namespace cusp::test {
namespace {

namespace fs = std::filesystem;

const fs::path kRoot = source_dir();

std::vector<fs::path> sources(const std::vector<std::string>& modules) {
  std::vector<fs::path> out;
  for (const std::string& module : modules)
    for (const auto& entry : fs::recursive_directory_iterator(kRoot / module)) {
      const std::string kind = entry.path().extension().string();
      if (entry.is_regular_file() && (kind == ".h" || kind == ".cpp" || kind == ".in")) out.push_back(entry.path());
    }
  return out;
}

bool letter(const std::string& text, std::size_t at) {
  return at < text.size() && std::isalpha(static_cast<unsigned char>(text[at])) != 0;
}

TEST(Includes, no_file_points_upward) {
  int files = 0;
  for (const fs::path& path : sources({"engine", "device", "scenarios", "storage", "ui"})) {
    ++files;
    for (const std::string& what : forbidden_includes(fs::relative(path, kRoot).string(), text_of(path)))
      ADD_FAILURE() << what;
  }
  EXPECT_GT(files, 50);
}

TEST(Includes, a_planted_violation_is_found) {
  EXPECT_EQ(forbidden_includes("engine/step/step.cpp", "#include \"scenarios/format/scenario.h\"\n").size(), 1u);
  EXPECT_EQ(forbidden_includes("engine/base/vec.h", "#include \"engine/volume/volume.h\"\n").size(), 1u);
  EXPECT_EQ(forbidden_includes("device/pointer/pointer_port.cpp", "#include \"engine/step/step.h\"\n").size(), 1u);
  EXPECT_EQ(forbidden_includes("engine/loop/loop.cpp", "  #  include <QString>\n").size(), 1u);
  EXPECT_EQ(forbidden_includes("ui/session/run.cpp", "#include <QtCore/QObject>\n").size(), 1u);
  EXPECT_EQ(forbidden_includes("storage/records/chain.cpp", "#include <sqlite3.h>\n").size(), 1u);
  EXPECT_EQ(forbidden_includes("engine/loop/loop.cpp", "#include <sys/resource.h>\n").size(), 1u);
  EXPECT_TRUE(forbidden_includes("engine/loop/realtime_linux.cpp", "#include <pthread.h>\n").empty());
  EXPECT_TRUE(forbidden_includes("ui/drill/drill_screen.cpp", "#include <QWidget>\n#include \"storage/base/rights.h\"\n").empty());
}

TEST(Openings, nothing_but_sqlite_opens_or_copies_a_database) {
  int files = 0;
  for (const fs::path& path : sources({"engine", "device", "scenarios", "storage", "ui"})) {
    ++files;
    for (const std::string& what : forbidden_openings(fs::relative(path, kRoot).string(), text_of(path))) ADD_FAILURE() << what;
  }
  EXPECT_GT(files, 500);
}

TEST(Openings, a_planted_violation_is_found) {
  for (const char* planted :
       {"std::ifstream in(database_, std::ios::binary);", "std::ofstream(plan.database) << text;",
        "QFile file(QString::fromStdString(database.string()));", "QSaveFile file(folder + u\"/station.db\"_qs);",
        "fs::copy_file(from, to / \"cusp.db\");", "std::filesystem::copy(o.db, place);", "std::FILE* f = std::fopen(o.db.c_str(), \"rb\");",
        "const int d = ::open(db_path.c_str(), O_RDONLY);", "const int d = open((file + \"-wal\").c_str(), O_RDONLY);",
        "QFile::copy(database_name, backup);", "fs::rename(part, store->database().file());", "fs::remove(name + \"-shm\", ignored);",
        "const fs::path from = o.db;\nstd::ifstream in(from);", "const std::string name = database.string();\nQFile file(name);"}) {
    EXPECT_EQ(forbidden_openings("ui/cli/backup.cpp", planted).size(), 1u) << planted;
  }
  for (const char* planted : {"std::ifstream in(file, std::ios::binary);", "const int d = open(name, O_RDONLY);", "fs::copy_file(a, b);"}) {
    EXPECT_EQ(forbidden_openings("storage/sqlite/database.cpp", planted).size(), 1u) << planted;
  }
  for (const char* fine : {"auto store = Store::open(database_);", "// std::ifstream in(database_);", "port->open(db);",
                           "std::ifstream in(file);", "QFile file(u\":/cusp/theme.qss\"_qs);", "const auto store = Store::open(o.db);\nstd::ofstream out(file);"}) {
    EXPECT_TRUE(forbidden_openings("ui/cli/backup.cpp", fine).empty()) << fine;
  }
}

TEST(Tree, HasTheFixedTopLevel) {
  const std::set<std::string> folders = {"ui", "engine", "device", "scenarios", "storage", "translations", "package", "tests", "build", "shared"};
  for (const auto& entry : fs::directory_iterator(kRoot)) {
    const std::string name = entry.path().filename().string();
    if (entry.is_directory() && !name.starts_with('.')) {  // an editor keeps hidden ones
      EXPECT_TRUE(folders.contains(name)) << entry.path();
    }
  }
  for (const char* file : {"README.md", "LICENSE", "CMakePresets.json", "run", "check", "packages.txt", ".clang-format",
                           ".clang-tidy", ".gitignore", ".ci/run"})
    EXPECT_TRUE(fs::exists(kRoot / file)) << file;
}

TEST(Tree, EveryModuleSaysWhatLivesInIt) {
  for (const char* module : {"ui", "engine", "device", "scenarios", "storage", "translations", "package", "tests"})
    EXPECT_TRUE(fs::exists(kRoot / module / "README.md")) << module;
  for (const auto& entry : fs::directory_iterator(kRoot / "ui")) {
    const std::string name = entry.path().filename().string();
    if (entry.is_regular_file()) {
      EXPECT_TRUE(name == "README.md" || name == "CMakeLists.txt" || name == "modules.h") << name << " lies directly in ui";
    } else if (entry.is_directory()) {
      EXPECT_NE(text_of(kRoot / "ui/README.md").find(name), std::string::npos) << "ui/README.md does not name " << name;
    }
  }
}

TEST(Tree, EveryFolderOfAModuleHasAReadme) {
  for (const char* module : {"ui", "engine", "device", "scenarios", "storage"}) {
    std::set<fs::path> folders;
    for (const fs::path& source : sources({module})) folders.insert(source.parent_path());
    for (const fs::path& folder : folders) {
      EXPECT_NE(text_of(folder / "README.md").find("ay not enter"), std::string::npos)
          << folder << " has no README that says what may not enter";
    }
  }
}

TEST(Tree, IsLicensedUnderGpl3OrLater) {
  const std::string text = text_of(kRoot / "LICENSE");
  EXPECT_NE(text.find("GNU GENERAL PUBLIC LICENSE"), std::string::npos);
  EXPECT_NE(text.find("Version 3, 29 June 2007"), std::string::npos);
  EXPECT_GT(text.size(), 30000u);
}

TEST(Tree, SetsTheTimeLimitOfATestInOnePlace) {
  int limits = 0;
  for (const auto& entry : fs::recursive_directory_iterator(kRoot / "tests")) {
    if (entry.path().filename() != "CMakeLists.txt") continue;
    const std::string text = text_of(entry.path());
    for (std::size_t at = text.find("PROPERTIES TIMEOUT"); at != std::string::npos; at = text.find("PROPERTIES TIMEOUT", at + 1)) {
      ++limits;
      EXPECT_EQ(entry.path(), kRoot / "tests/CMakeLists.txt") << "cusp_time_limit() has the factor for a busy machine";
    }
  }
  EXPECT_EQ(limits, 1);
}

TEST(Tree, WritesTextsInTheLocaleThatEveryThreadMayRead) {
  int read = 0;
  for (const fs::path& path : sources({"ui/text", "ui/report", "ui/widgets"})) {
    const std::string name = path.filename().string(), text = text_of(path);
    if (name == "number_field.cpp") continue;  // of the window alone
    ++read;
    for (const char* asked : {"QLocale()", "QLocale locale;", "QLocale& locale = {}"}) {
      // format.cpp begins with it.
      const bool own = name == "format.cpp" && asked == std::string_view("QLocale locale;");
      EXPECT_TRUE(own || text.find(asked) == std::string::npos) << path << ": " << asked << "; write installed_locale()";
    }
  }
  EXPECT_GT(read, 60);
}

TEST(Tree, HasSqlInStorageAlone) {
  constexpr std::string_view kBegins[] = {"SELECT", "INSERT", "UPDATE", "DELETE", "PRAGMA", "CREATE", "ALTER", "DROP"};
  int read = 0;
  for (const fs::path& path : sources({"engine", "device", "scenarios", "ui"})) {
    ++read;
    const std::string text = text_of(path);
    for (const std::string_view begins : kBegins)
      EXPECT_EQ(text.find('"' + std::string(begins) + ' '), std::string::npos) << path << ": " << begins << "; ask a function of storage";
  }
  EXPECT_GT(read, 500);
}

TEST(Tree, LeavesNothingUnfinishedInTheCode) {
  const std::string words[] = {std::string("TO") + "DO", std::string("FIX") + "ME", std::string("XX") + "X"};
  for (const fs::path& path : sources({"engine", "device", "scenarios", "storage", "ui", "tests"})) {
    const std::string text = text_of(path);
    for (const std::string& word : words) {
      std::size_t at = text.find(word);
      while (at != std::string::npos && (letter(text, at - 1) || letter(text, at + word.size()))) at = text.find(word, at + 1);
      EXPECT_EQ(at, std::string::npos) << path << ": " << word;
    }
  }
}

TEST(Determinism, everything_the_step_reaches_is_built_without_contraction_and_fast_math) {
  const nlohmann::json commands = nlohmann::json::parse(text_of(fs::path(CUSP_BINARY_DIR) / "compile_commands.json"));
  int seen = 0;
  for (const auto& entry : commands) {
    const std::string file = fs::relative(entry["file"].get<std::string>(), kRoot).string();
    if (!(file.starts_with("engine/step/") || file.starts_with("engine/contact/") ||
          file.starts_with("engine/removal/") || file.starts_with("engine/volume/") ||
          file.starts_with("engine/tool/")))
      continue;
    ++seen;
    const std::string command = entry["command"].get<std::string>();
    EXPECT_NE(command.find("-ffp-contract=off"), std::string::npos) << file;
    for (const char* flag : {"-ffast-math", "-Ofast", "-funsafe-math", "-fassociative-math", "-mfma"})
      EXPECT_EQ(command.find(flag), std::string::npos) << file << ": " << flag;
  }
  EXPECT_GT(seen, 12);
}

TEST(Determinism, the_step_calls_nothing_of_libm_but_what_is_exact) {
  // sin, exp, pow ... differ between processors; sqrt, floor, ceil and fabs do not.
  for (const char* folder : {"engine/scene", "engine/step", "engine/contact", "engine/removal", "engine/volume"})
    for (const fs::path& path : sources({folder})) {
      const std::string name = path.filename().string();
      if (name.starts_with("cut_volume")) continue;  // metrics: not reached by the step
      const std::string text = text_of(path);
      for (const char* call : {"std::sin(", "std::cos(", "std::tan(", "std::exp(", "std::pow(", "std::log(", "std::acos(",
                               "std::asin(", "std::atan2(", "std::hypot(", "std::fma(", "glm::inversesqrt(",
                               "glm::normalize(", "unordered_map", "std::chrono"})
        EXPECT_EQ(text.find(call), std::string::npos) << path << ": " << call;
    }
}

}  // namespace
}  // namespace cusp::test

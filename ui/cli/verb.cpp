#include "ui/cli/verb.h"

#include <cstdio>
#include <fstream>
#include <nlohmann/json.hpp>

#include "engine/base/ids.h"
#include "ui/cli/text.h"

namespace cusp::ui {

void warn(const QString& what) { std::fprintf(stderr, "cusp: %s\n", plain(what).c_str()); }
int failed(const QString& what) {
  warn(what);
  return kFailed;
}
int failed(const Message& message) { return failed(message.line()); }

int wrong_usage(const QString& what) {
  std::fprintf(stderr, "cusp: %s\n", plain(what).c_str());
  return kWrongUsage;
}

void print_line(const std::string& line) {
  std::fprintf(stdout, "%s\n", line.c_str());
  std::fflush(stdout);
}

void JsonOption::add_to(CLI::App& verb) {
  verb.add_option("--json", file, help(CliText::tr("Write the result as JSON to FILE, or to stdout for -")))->type_name("FILE");
}

bool JsonOption::write(const nlohmann::ordered_json& value) const {
  if (!wanted()) return true;
  const std::string text = value.dump(2) + '\n';
  if (on_stdout()) {
    return std::fwrite(text.data(), 1, text.size(), stdout) == text.size() && std::fflush(stdout) == 0;
  }
  if (write_whole(file, text)) return true;
  failed(CliText::tr("%1 cannot be written.").arg(QString::fromStdString(file)));
  return false;
}

bool write_whole(const std::filesystem::path& file, const std::string& bytes) {
  std::filesystem::path beside = file;
  beside += '.' + Uuid::v7().text();
  std::error_code error;
  {
    std::ofstream out(beside, std::ios::binary);
    out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    out.close();
    if (!out) {
      std::filesystem::remove(beside, error);
      return false;
    }
  }
  std::filesystem::rename(beside, file, error);
  if (!error) return true;
  std::filesystem::remove(beside, error);
  return false;
}

bool writable_folder(const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) return false;
  const std::filesystem::path probe = folder / (".cusp-" + Uuid::v7().text());
  const bool written = write_whole(probe, "cusp");
  std::filesystem::remove(probe, error);
  return written;
}

}  // namespace cusp::ui

#include "ui/cli/outputs.h"

#include <algorithm>
#include <span>

#include "ui/cli/text.h"
#include "ui/session/database_files.h"

namespace cusp::ui {
namespace {

namespace fs = std::filesystem;

bool is_name(const fs::path& file) { return !file.empty() && file != "-"; }

/// Whether writing to `file` replaces `other`.
bool replaced_by(const fs::path& other, const fs::path& file) {
  std::error_code error;
  if (!is_name(other) || (fs::exists(file, error) && !fs::is_regular_file(file, error))) return false;
  return same_file(other, file);
}

bool named_before(const fs::path& file, std::span<const fs::path> others) {
  return std::ranges::any_of(others, [&](const fs::path& other) { return replaced_by(other, file); });
}

QString shown_path(const fs::path& file) { return QString::fromStdString(file.string()); }

}  // namespace

std::vector<fs::path> scenario_files(const fs::path& named) { return {named, named / "scenario.json"}; }

std::optional<Message> refuse_outputs(const std::vector<fs::path>& outputs, const fs::path& database, const std::vector<fs::path>& inputs) {
  const QString other_name = CliText::tr("Nothing was written. Give another name.");
  for (std::size_t i = 0; i < outputs.size(); ++i) {
    const fs::path& file = outputs[i];
    if (!is_name(file)) continue;
    if (const auto records = database_of_file(file, database))
      return Message{CliText::tr("%1 belongs to the database %2.").arg(shown_path(file), shown_path(*records)), other_name};
    if (named_before(file, std::span(outputs).first(i)) || named_before(file, inputs))
      return Message{CliText::tr("%1 is named twice.").arg(shown_path(file)), other_name};
  }
  return std::nullopt;
}

}  // namespace cusp::ui

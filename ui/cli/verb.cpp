#include "ui/cli/verb.h"

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <nlohmann/json.hpp>

#include "engine/base/ids.h"
#include "scenarios/import/whole_file.h"
#include "storage/base/files.h"
#include "ui/cli/text.h"
#include "ui/modules.h"

namespace cusp::ui {

namespace {

/// errno of the first write to stdout that failed; 0: none has.
int g_output_error = 0;

void note_output_error() {
  if (g_output_error == 0) g_output_error = errno != 0 ? errno : EIO;
}

/// The number that all of the text is; nullopt: it is none, or the type does not hold it.
template <class Number>
std::optional<Number> number_typed(const std::string& typed) {
  Number value{};
  const char* const past = typed.data() + typed.size();
  const auto [end, error] = std::from_chars(typed.data(), past, value);
  return error == std::errc{} && end == past ? std::optional<Number>(value) : std::nullopt;
}

QString shown_typed(const std::string& typed) { return QString::fromStdString(typed); }
QString value_is_empty() { return CliText::tr("the value is empty"); }
QString no_file_name() { return CliText::tr("it is written to a file, and - is none"); }
QString no_number_from_0(const QString& typed) { return CliText::tr("%1 is no number from 0 on").arg(typed); }
QString no_number_above_0(const QString& typed) { return CliText::tr("%1 is no number above 0").arg(typed); }
QString no_whole_number_from_0(const QString& typed) { return CliText::tr("%1 is no whole number from 0 on").arg(typed); }
QString no_whole_number_from_1(const QString& typed) { return CliText::tr("%1 is no whole number from 1 on").arg(typed); }

}  // namespace

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

bool write_out(std::string_view text) {
  errno = 0;
  if (std::fwrite(text.data(), 1, text.size(), stdout) == text.size() && std::fflush(stdout) == 0) return true;
  note_output_error();
  return g_output_error == EPIPE;
}

int after_output(int status) {
  errno = 0;
  if (g_output_error == 0 && (std::fflush(stdout) != 0 || std::ferror(stdout) != 0)) note_output_error();
  if (g_output_error == 0 || g_output_error == EPIPE) return status;
  return failed(CliText::tr("The standard output cannot be written: %1.").arg(QString::fromLocal8Bit(std::strerror(g_output_error))));
}

std::string check_not_negative(const std::string& typed) {
  const auto value = number_typed<double>(typed);
  if (value && std::isfinite(*value) && *value >= 0) return {};
  return help(no_number_from_0(shown_typed(typed)));
}

std::string check_positive(const std::string& typed) {
  const auto value = number_typed<double>(typed);
  if (value && std::isfinite(*value) && *value > 0) return {};
  return help(no_number_above_0(shown_typed(typed)));
}

std::string check_whole(const std::string& typed) {
  if (number_typed<std::uint64_t>(typed)) return {};
  return help(no_whole_number_from_0(shown_typed(typed)));
}

std::string check_counting(const std::string& typed) {
  if (number_typed<std::uint64_t>(typed).value_or(0) > 0) return {};
  return help(no_whole_number_from_1(shown_typed(typed)));
}

std::string decimal(const std::string& typed) {
  if (typed.empty() || typed.find_first_not_of("0123456789") != std::string::npos) return typed;
  return typed.substr(std::min(typed.find_first_not_of('0'), typed.size() - 1));
}

std::string check_not_empty(const std::string& typed) {
  if (!typed.empty()) return {};
  return help(value_is_empty());
}

std::string check_file_name(const std::string& typed) {
  if (typed != "-") return check_not_empty(typed);
  return help(no_file_name());
}

void print_line(const std::string& line) { write_out(line + '\n'); }

void JsonOption::add_to(CLI::App& verb) {
  verb.add_option("--json", file, help(CliText::tr("Write the result as JSON to FILE, or to stdout for -")))->type_name("FILE")->check(check_not_empty);
}

void ClockOption::add_to(CLI::App& verb) {
  verb.add_flag("--clock-is-right", is_right, help(CliText::tr("The dates are right, although for more than half a year nothing was recorded")));
}

int failed_by_age(const StorageFailure& failure) {
  Message message = describe(failure);
  if (failure.code == StorageError::clock_ahead) {
    message.more += u' ' + (failure.where == "pause" ? CliText::tr("If these dates are right, add --clock-is-right.") : CliText::tr("If that date is right, add --clock-is-right."));
  }
  return failed(message);
}

std::string JsonOption::text_of(const nlohmann::ordered_json& value) {
  // A file's name may be no UTF-8.
  return value.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + '\n';
}

bool JsonOption::write(const nlohmann::ordered_json& value) const {
  if (!wanted()) return true;
  const std::string text = text_of(value);
  if (on_stdout()) return write_out(text);
  const auto written = write_whole(file, text);
  if (!written) failed(cannot_write(file, written.error().detail));
  return written.has_value();
}

Stored<void> write_whole(const std::filesystem::path& file, const std::string& bytes) {
  if (auto done = write_whole_file(file, bytes); !done) return std::unexpected(failure_from(done.error(), file));
  return {};
}

Stored<void> can_begin(const std::filesystem::path& file) {
  if (auto begun = WholeFile(file).write({}); !begun) return std::unexpected(failure_from(begun.error(), file));
  return {};
}

Stored<void> writable_folder(const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) return std::unexpected(failure_from(error, folder));
  const std::filesystem::path probe = folder / (".cusp-" + Uuid::v7().text());
  auto written = write_whole(probe, "cusp");
  std::filesystem::remove(probe, error);
  return written;
}

Message cannot_write(const std::filesystem::path& file, const std::string& why) {
  return {CliText::tr("%1 cannot be written: %2.").arg(QString::fromStdString(file.string()), QString::fromStdString(why)), {}};
}

std::optional<Message> unreadable(const StorageFailure& failure, const std::filesystem::path& input) {
  const std::string name = input.has_filename() ? input.string() : input.parent_path().string();
  const bool of_input = failure.where == name || failure.where.starts_with(name + '/');
  if (failure.code != StorageError::read_only || !of_input) return std::nullopt;
  return Message{CliText::tr("%1 cannot be read.").arg(QString::fromStdString(failure.where)),
                 CliText::tr("Its permissions or those of its folder refuse it. Nothing was changed.")};
}

Message nothing_written_to(const std::filesystem::path& folder, const std::string& why) {
  return {CliText::tr("Nothing can be written to %1: %2.").arg(QString::fromStdString(folder.string()), QString::fromStdString(why)), {}};
}

}  // namespace cusp::ui

/// What the verbs share: how one joins the command line, how it fails, and where its JSON goes.
#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>

#include "storage/base/error.h"
#include "storage/retention/clock_doubt.h"
#include "ui/modules.h"
#include "ui/text/failure_text.h"
#include "ui/text/plain.h"

namespace cusp::ui {

/// Exit statuses of every verb.
inline constexpr int kDone = 0, kFailed = 1, kWrongUsage = 2;

/// What was chosen on the command line; run after all of it has been read.
using Job = std::function<int()>;

// Each adds its verb to the program.
void add_play(CLI::App& program, Job& job);
void add_replay(CLI::App& program, Job& job);
void add_grade(CLI::App& program, Job& job);
void add_validate(CLI::App& program, Job& job);
void add_audit(CLI::App& program, Job& job);
void add_import(CLI::App& program, Job& job);
void add_specimen(CLI::App& program, Job& job);
void add_history(CLI::App& program, Job& job);
void add_template(CLI::App& program, Job& job);
void add_erase(CLI::App& program, Job& job);
void add_export(CLI::App& program, Job& job);
void add_thin(CLI::App& program, Job& job);
void add_retain(CLI::App& program, Job& job);
/// appeal and verify.
void add_appeal(CLI::App& program, Job& job);
void add_exchange(CLI::App& program, Job& job);
/// backup and restore.
void add_backup(CLI::App& program, Job& job);

/// One line on stderr, "cusp: …", and kFailed.
int failed(const Message& message);
int failed(const QString& what);
/// One line on stderr; the verb continues.
void warn(const QString& what);
/// One line on stderr and kWrongUsage.
int wrong_usage(const QString& what);
/// Writes to stdout at once. False: could not be written; after_output() prints the message. What the reader of a pipe no longer wants
/// counts as written: the verb's work and its entry in the audit log do not hang on a reader.
bool write_out(std::string_view text);
/// The exit status of a verb that ends with `status`: kFailed, and one line on stderr, if stdout has lost something. A pipe that
/// its reader has closed changes nothing.
int after_output(int status);
/// One line on stdout.
void print_line(const std::string& line);

/// --json FILE, or - for stdout. The same in every language.
struct JsonOption {
  std::string file;
  void add_to(CLI::App& verb);
  bool wanted() const { return !file.empty(); }
  bool on_stdout() const { return file == "-"; }
  /// The old file or the whole new one; nothing when it was not asked for. False: could not be written; stderr has the message,
  /// or gets that of after_output().
  bool write(const nlohmann::ordered_json& value) const;
  /// What write() writes.
  static std::string text_of(const nlohmann::ordered_json& value);
};

// Failure::detail of each is the system's reason, and nothing is left.
/// All of it as a WholeFile (scenarios/import/whole_file.h).
Stored<void> write_whole(const std::filesystem::path& file, const std::string& bytes);
/// Whether a WholeFile of this name can be begun. Opens a pipe or a device.
Stored<void> can_begin(const std::filesystem::path& file);
/// Whether files can be written into the folder. Makes it at need.
Stored<void> writable_folder(const std::filesystem::path& folder);

/// "report.json cannot be written: No space left on device."
Message cannot_write(const std::filesystem::path& file, const std::string& why);
/// What to print if `input`, or a file in it, may not be read. Storage names both ways of access alike: read_only of what a verb reads
/// alone is this. nullopt: the failure is another.
std::optional<Message> unreadable(const StorageFailure& failure, const std::filesystem::path& input);
/// The same of a folder as cannot_write().
Message nothing_written_to(const std::filesystem::path& folder, const std::string& why);

/// --clock-is-right, of the verbs that take away what is old.
struct ClockOption {
  bool is_right = false;
  void add_to(CLI::App& verb);
  ClockTrust trust() const { return is_right ? ClockTrust::confirmed : ClockTrust::checked; }
};
/// Names --clock-is-right if the failure is of the clock.
int failed_by_age(const StorageFailure& failure);

// Validators of CLI11: empty, or what is wrong with the typed value.
std::string check_not_negative(const std::string& typed);  // a finite number from 0 on
std::string check_positive(const std::string& typed);      // a finite number above 0
std::string check_whole(const std::string& typed);         // a whole number from 0 to 2^64 - 1
std::string check_counting(const std::string& typed);      // a whole number from 1 to 2^64 - 1
/// A transform of CLI11, for every whole number: leaves out the zeros in front, with which CLI11 reads a number as octal.
std::string decimal(const std::string& typed);
/// Not empty, as a variable of a shell that is not set: an empty name would count as none, and other records or files be taken.
std::string check_not_empty(const std::string& typed);
/// Neither empty nor -, of what is never written to stdout.
std::string check_file_name(const std::string& typed);

}  // namespace cusp::ui

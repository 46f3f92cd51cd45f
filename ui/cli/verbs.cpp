#include "ui/cli/verbs.h"

#include <QGuiApplication>
#include <algorithm>
#include <array>
#include <clocale>
#include <cstdio>
#include <exception>
#include <sstream>
#include <string_view>

#include "scenarios/import/worker.h"
#include "scenarios/library/exercise_file.h"
#include "ui/cli/verb.h"
#include "ui/cli/text.h"
#include "ui/modules.h"
#include "ui/session/build_info.h"
#include "ui/text/language.h"

namespace cusp::ui {

namespace {

constexpr std::array<std::string_view, 19> kVerbs = {"play",    "replay",   "grade",  "validate", "audit",   "import",
                                                     "specimen", "history", "export", "template", "backup", "restore", "erase", "thin", "retain", "appeal", "verify", "exchange", "import-child"};

int run(int argc, char** argv) {
  if (!is_verb(argc, argv)) return failed(CliText::tr("There is no display for the window. A verb needs none (see cusp --help)."));
  CLI::App program(help(CliText::tr("Cusp: cavity preparation with a grade. Without a verb, cusp [--db FILE] [--safe] [NAME.cusp] opens the desktop.")), "cusp");
  program.set_version_flag("--version", build_info());
  program.require_subcommand(1);
  Job job;
  add_play(program, job);
  add_replay(program, job);
  add_grade(program, job);
  add_validate(program, job);
  add_audit(program, job);
  add_import(program, job);
  add_specimen(program, job);
  add_history(program, job);
  add_export(program, job);
  add_template(program, job);
  add_backup(program, job);
  add_erase(program, job);
  add_thin(program, job);
  add_retain(program, job);
  add_appeal(program, job);
  add_exchange(program, job);
  // CLI11 says that a verb is missing.
  if (argc > 1 && argv[1][0] != '-' && std::ranges::find(kVerbs, std::string_view(argv[1])) == kVerbs.end())
    return wrong_usage(CliText::tr("There is no verb %1 (see cusp --help)").arg(QString::fromUtf8(argv[1])));
  try {
    program.parse(argc, argv);
  } catch (const CLI::Success& asked) {  // --help, --version
    std::ostringstream text;
    const int status = program.exit(asked, text);
    write_out(text.str());
    return after_output(status);
  } catch (const CLI::ParseError& wrong) {
    return wrong_usage(CliText::tr("%1 (see cusp VERB --help)").arg(QString::fromUtf8(wrong.what())));
  }
  try {
    return after_output(job());
  } catch (const std::bad_alloc&) {
    return failed(CliText::tr("There is not enough memory."));
  } catch (const std::exception& unexpected) {
    return failed(CliText::tr("Something unexpected happened (%1). What was recorded before is kept.")
                      .arg(QString::fromUtf8(unexpected.what())));
  }
}

}  // namespace

bool is_verb(int argc, char** argv) {
  if (argc < 2) return false;
  const std::string_view first = argv[1];
  return std::ranges::find(kVerbs, first) != kVerbs.end() || first == "--help" || first == "-h" || first == "--version" ||
         (!first.empty() && first.front() != '-' && !names_exercise_file(first));
}

bool no_display(int argc, char** argv) {
  QByteArray platforms = qgetenv("QT_QPA_PLATFORM");
  for (int i = 1; i + 1 < argc; ++i) {
    const std::string_view option = argv[i];
    if (option == "-display" || option == "--display") return false;
    if (option == "-platform" || option == "--platform") platforms = argv[i + 1];
  }
  // A list by ";" of which Qt takes the first that starts; parameters follow a name after ":".
  const QList<QByteArray> names = platforms.isEmpty() ? QList<QByteArray>() : platforms.split(';');
  if (std::ranges::any_of(names, [](const QByteArray& name) { return !name.startsWith("xcb") && !name.startsWith("wayland"); })) return false;
  constexpr std::array kDisplays = {"DISPLAY", "WAYLAND_DISPLAY", "WAYLAND_SOCKET"};
  return std::ranges::all_of(kDisplays, [](const char* name) { return qEnvironmentVariableIsEmpty(name); });
}

std::optional<int> refuse_files(const QStringList& files) {
  for (const QString& file : files)
    if (!names_exercise_file(file.toStdString()))
      return wrong_usage(CliText::tr("%1 is no exercise file, NAME.cusp. A verb stands before every option (see cusp --help).").arg(file));
  if (files.size() > 1) return wrong_usage(CliText::tr("Only one exercise file can be opened, and %1 is another.").arg(files[1]));
  return std::nullopt;
}

int run_verb(int argc, char** argv) {
  if (const auto status = import_child_main(argc, argv)) return *status;
  // A verb prints one line when it fails, and Qt's remarks about the session it runs in are none of it.
  qInstallMessageHandler([](QtMsgType type, const QMessageLogContext&, const QString& message) {
    if (type == QtFatalMsg) std::fprintf(stderr, "cusp: %s\n", qUtf8Printable(message));
  });
  // The page of a report needs fonts, not a display.
  qputenv("QT_QPA_PLATFORM", "offscreen");
  int own_argc = 1;  // a verb's options are not Qt's
  QGuiApplication app(own_argc, argv);
  // Qt has set it as the user has: printf() would write numbers into files with a comma.
  std::setlocale(LC_NUMERIC, "C");
  install_language(app, {});
  return run(argc, argv);
}

}  // namespace cusp::ui

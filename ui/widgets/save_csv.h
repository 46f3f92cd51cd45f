/// A list as a file: where, written whole or not at all, and what came of it. Thread: GUI.
#pragma once

#include <QString>
#include <functional>
#include <optional>
#include <string>

#include "ui/widgets/parts.h"
#include "ui/widgets/ports.h"

namespace cusp::ui {

struct CsvText {
  std::string text;  // UTF-8
  QString done;      // "12 attempts exported."
  std::function<bool()> log{};  // called once the text is written, before the file has its name; false: it has shown why, and no file is left
};

struct CsvWish {
  QString title;                                 // of the file picker
  QString name;                                  // suggested, without ".csv"
  std::function<std::optional<CsvText>()> make;  // called once a file is chosen; nullopt: it has shown why
};

/// What the file picker asks for.
FileWish csv_file_wish(const QString& title, const QString& name);
/// That nothing was written: the path and the system's reason.
void show_unwritten(Band& band, const QString& path, const QString& reason);

/// The band shows `done` with the path, or why nothing was written. `make` is not called once the band is gone.
void save_csv(Band& band, const Ports& ports, const CsvWish& wish);

}  // namespace cusp::ui

/// A list as a file: where, written whole or not at all, and what came of it. Thread: GUI.
#pragma once

#include <QString>
#include <string>

#include "ui/widgets/parts.h"
#include "ui/widgets/ports.h"

namespace cusp::ui {

struct CsvWish {
  QString title;     // of the file picker
  QString name;      // suggested, without ".csv"
  std::string text;  // UTF-8
  QString done;      // "12 attempts exported."
};

/// What the file picker asks for.
FileWish csv_file_wish(const QString& title, const QString& name);
/// That nothing was written: the path and the system's reason.
void show_unwritten(Band& band, const QString& path, const QString& reason);

/// The band shows `done` with the path, or why nothing was written.
void save_csv(Band& band, const Ports& ports, const CsvWish& wish);

}  // namespace cusp::ui

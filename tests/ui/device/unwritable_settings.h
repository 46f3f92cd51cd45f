/// Settings whose file cannot be written, and what is reported over them.
#pragma once

#include <gtest/gtest.h>

#include <QFile>
#include <QTemporaryDir>

#include "tests/modules.h"
#include "ui/widgets/parts.h"

namespace cusp::test {

/// Root may write a read-only folder, and nobody a file below a file.
inline QString unwritable_settings(const QTemporaryDir& folder) {
  QFile file(folder.filePath(QStringLiteral("a file")));
  EXPECT_TRUE(file.open(QIODevice::WriteOnly));
  return folder.filePath(QStringLiteral("a file/Cusp.ini"));
}

/// Of all bands that are shown.
inline QString band_text(const QWidget& panel) {
  QString out;
  for (const Band* band : panel.findChildren<Band*>())
    if (band->isVisibleTo(&panel)) out += band->text();
  return out;
}

inline const QString kUnkept = QStringLiteral("What is changed here holds until Cusp is closed.");

}  // namespace cusp::test

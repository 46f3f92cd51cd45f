/// Text for terminals and files of data. Any thread.
#pragma once

#include <QString>
#include <string>

namespace cusp::ui {

/// One line, without the marks that hold right-to-left text together on a screen.
std::string plain(const QString& text);

}  // namespace cusp::ui

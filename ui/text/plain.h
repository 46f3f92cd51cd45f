/// Text for terminals and files of data. Any thread.
#pragma once

#include <QString>
#include <string>

namespace cusp::ui {

/// One line, without the marks that turn a text's direction. Another control character, which a terminal would obey, is U+FFFD.
std::string plain(const QString& text);

}  // namespace cusp::ui

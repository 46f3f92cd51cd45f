#include "ui/text/plain.h"

namespace cusp::ui {

std::string plain(const QString& text) {
  QString out;
  for (const QChar c : text) {
    const bool mark = c.unicode() >= 0x2066 && c.unicode() <= 0x2069;
    if (!mark) out += c == u'\n' || c == u'\r' ? QChar(u' ') : c;
  }
  return out.toStdString();
}

}  // namespace cusp::ui

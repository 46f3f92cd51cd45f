#include "ui/text/plain.h"

namespace cusp::ui {
namespace {

/// Embeddings, overrides and isolates: U+202A to U+202E, U+2066 to U+2069.
bool turns_direction(QChar c) { return (c.unicode() >= 0x202A && c.unicode() <= 0x202E) || (c.unicode() >= 0x2066 && c.unicode() <= 0x2069); }

QChar printable(QChar c) {
  if (c == u'\n' || c == u'\r' || c == u'\t') return u' ';
  return c.category() == QChar::Other_Control ? QChar(QChar::ReplacementCharacter) : c;
}

}  // namespace

std::string plain(const QString& text) {
  QString out;
  for (const QChar c : text) {
    if (!turns_direction(c)) out += printable(c);
  }
  return out.toStdString();
}

}  // namespace cusp::ui

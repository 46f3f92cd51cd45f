#include "ui/instructor/number_list.h"

#include <QRegularExpression>
#include <algorithm>
#include <map>

namespace cusp::ui {

NumberList read_numbers(const QString& text, const std::vector<Account>& students, const std::set<UserId>& inside) {
  std::map<QString, const Account*> by_number;
  for (const Account& student : students) by_number[QString::fromStdString(student.number).toCaseFolded()] = &student;
  static const QRegularExpression kBlank(QStringLiteral("\\s+")), kCell(QStringLiteral("[\\t,;]+")), kDigit(QStringLiteral("\\d"));
  constexpr qsizetype kMostParts = 4;  // of a number that holds blanks
  const auto words_of = [&](const QString& cell) {
    QStringList words;
    const QStringList parts = cell.split(kBlank, Qt::SkipEmptyParts);
    for (qsizetype i = 0, n = 0; i < parts.size(); i += n) {
      n = std::min(kMostParts, parts.size() - i);
      while (n > 1 && !by_number.contains(parts.mid(i, n).join(u' ').toCaseFolded())) --n;
      words += parts.mid(i, n).join(u' ');
    }
    return words;
  };
  NumberList out;
  std::set<UserId> seen;
  for (const QString& line : text.split(u'\n', Qt::SkipEmptyParts)) {
    bool any = line.trimmed().isEmpty();
    QStringList words;
    for (const QString& cell : line.split(kCell, Qt::SkipEmptyParts)) words += words_of(cell);
    for (const QString& word : words) {
      const auto it = by_number.find(word.toCaseFolded());
      if (it == by_number.end()) {
        if (!word.contains(kDigit)) continue;
        out.unknown += word;
        any = true;
        continue;
      }
      any = true;
      if (!seen.insert(it->second->id).second) continue;
      if (inside.contains(it->second->id)) {
        ++out.already;
      } else {
        out.found.push_back(*it->second);
      }
    }
    if (!any) out.unknown += line.trimmed();
  }
  return out;
}

}  // namespace cusp::ui

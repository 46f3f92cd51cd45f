#include "ui/instructor/number_list.h"

#include <QRegularExpression>
#include <algorithm>
#include <map>

namespace cusp::ui {

NumberList read_numbers(const QString& text, const std::vector<Account>& students, const std::set<UserId>& inside) {
  std::map<QString, const Account*> by_number;
  for (const Account& student : students) by_number[QString::fromStdString(student.number).toCaseFolded()] = &student;
  static const QRegularExpression kBetween(QStringLiteral("[\\s,;]+")), kDigit(QStringLiteral("\\d"));
  NumberList out;
  std::set<UserId> seen;
  for (const QString& line : text.split(u'\n', Qt::SkipEmptyParts)) {
    bool any = line.trimmed().isEmpty();
    for (const QString& word : line.split(kBetween, Qt::SkipEmptyParts)) {
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

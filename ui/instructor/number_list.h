/// Student numbers out of pasted text: one a line, or several separated; names may stand beside them. No widget.
#pragma once

#include <QString>
#include <QStringList>
#include <set>
#include <vector>

#include "storage/repositories/accounts.h"
#include "ui/modules.h"

namespace cusp::ui {

struct NumberList {
  std::vector<Account> found;  // each student once, in the order of the text
  int already = 0;             // numbers of students who are in `inside`
  QStringList unknown;         // words with a digit that are no student's number, and lines without any number
};

/// Separators are commas, semicolons, tabs and, outside a number, blanks. Case does not count, as at sign-in.
NumberList read_numbers(const QString& text, const std::vector<Account>& students, const std::set<UserId>& inside);

}  // namespace cusp::ui

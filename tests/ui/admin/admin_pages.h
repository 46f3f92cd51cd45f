/// The administrator's pages over real records: a desk that answers questions and picks files, and what a test does on a page.
#pragma once

#include <gtest/gtest.h>

#include <QComboBox>
#include <QLineEdit>
#include <QPushButton>
#include <functional>
#include <string>
#include <vector>

#include "tests/modules.h"
#include "tests/ui/desk_records.h"
#include "ui/widgets/ports.h"

namespace cusp::test {

inline void press(QWidget& page, const char* name) {
  for (QPushButton* b : page.findChildren<QPushButton*>()) {
    if (b->accessibleName() == QLatin1String(name)) return b->click();
  }
  FAIL() << "no button " << name;
}
inline QLineEdit* field(QWidget& page, const char* name) {
  for (QLineEdit* f : page.findChildren<QLineEdit*>()) {
    if (f->accessibleName() == QLatin1String(name)) return f;
  }
  return nullptr;
}

inline std::string plain_text(QString text) {
  for (const char16_t c : {u'\x2066', u'\x2069'}) text.remove(QChar(c));
  return text.replace(QChar(0x00A0), u' ').toStdString();
}
inline QStringList texts_of(const QComboBox& box) {
  QStringList out;
  for (int i = 0; i < box.count(); ++i) out += box.itemText(i);
  return out;
}

struct AdminPages : ::testing::Test {
  DeskRecords records;
  Ports ports = Ports::of_the_system();
  std::vector<QString> asked;
  bool answer = true;
  QString file;
  void SetUp() override {
    records.administrator();
    ports.ask = [this](QWidget*, const Question& q, std::function<void(bool)> then) {
      asked.push_back(q.what);
      then(answer);
    };
    ports.pick_file = [this](QWidget*, const FileWish&, std::function<void(const QString&)> then) { then(file); };
    ports.now = [] { return QDateTime(QDate(2026, 11, 20), QTime(12, 0), Qt::UTC); };
  }
};

}  // namespace cusp::test

#include "ui/admin/people_csv.h"

#include <QRegularExpression>
#include <QStringDecoder>
#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <set>

#include "storage/base/text_length.h"
#include "storage/repositories/cohorts.h"
#include "storage/repositories/possible_doubles.h"
#include "ui/widgets/format.h"

namespace cusp::ui {
namespace {

/// Of spreadsheets on Windows, Linux, and an older Mac.
QString with_line_feeds(QString text) { return text.replace(u"\r\n"_qs, u"\n"_qs).replace(u'\r', u'\n'); }

/// Of which the first line has most outside quotes.
QChar separator_of(const QString& text) {
  std::array<std::pair<QChar, int>, 3> signs = {{{u',', 0}, {u';', 0}, {u'\t', 0}}};
  bool quoted = false;
  for (const QChar c : text) {
    if (c == u'"') quoted = !quoted;
    if (quoted) continue;
    if (c == u'\n') break;
    for (auto& [sign, count] : signs) count += c == sign ? 1 : 0;
  }
  return std::ranges::max_element(signs, {}, &std::pair<QChar, int>::second)->first;
}

/// Reads cell by cell; a row ends at a line break outside quotes.
class CsvReader {
 public:
  explicit CsvReader(const QString& text) : text_(with_line_feeds(text)), separator_(separator_of(text_)) {
    static const QRegularExpression kNamesSeparator(QStringLiteral("\\Asep=([,;\t])\n"), QRegularExpression::CaseInsensitiveOption);
    const auto named = kNamesSeparator.match(text_);
    if (!named.hasMatch()) return;
    separator_ = named.captured(1).front();
    at_ = named.capturedLength();
    row_line_ = line_ = 2;
  }

  Result<CsvTable, CsvFailure> read() {
    for (; at_ < text_.size(); ++at_) {
      const QChar c = text_[at_];
      if (c == u'\n') ++line_;
      if (quoted_) {
        in_quotes(c);
      } else if (c == u'"' && cell_.isEmpty()) {
        quoted_ = true;
        opened_ = line_;
      } else if (c == separator_) {
        end_cell();
      } else if (c == u'\n') {
        end_row();
      } else {
        cell_ += c;
      }
    }
    if (quoted_) return fail(CsvError::open_quote, std::to_string(opened_));
    end_row();
    return std::move(out_);
  }

 private:
  void in_quotes(QChar c) {
    if (c != u'"') {
      cell_ += c;
    } else if (at_ + 1 < text_.size() && text_[at_ + 1] == u'"') {
      cell_ += c;
      ++at_;
    } else {
      quoted_ = false;
    }
  }
  void end_cell() {
    // A list from a Mac may hold "u" and two dots where everybody types "ü": number, name and cohort would be others.
    row_.push_back(cell_.trimmed().normalized(QString::NormalizationForm_C));
    cell_.clear();
  }
  void end_row() {
    end_cell();
    const bool any = std::ranges::any_of(row_, [](const QString& cell) { return !cell.isEmpty(); });
    if (any) {
      out_.rows.push_back(std::move(row_));
      out_.lines.push_back(row_line_);
    }
    row_.clear();
    row_line_ = line_;
  }

  const QString text_;
  QChar separator_;
  CsvTable out_;
  std::vector<QString> row_;
  QString cell_;
  qsizetype at_ = 0;
  int line_ = 1, row_line_ = 1, opened_ = 0;
  bool quoted_ = false;
};

enum Head { kNumberHead, kNameHead, kFirstHead, kSurnameHead, kPinHead, kCohortHead, kHeads };

/// Heads as schools write them, without blanks, dots and case; of several the first here counts.
const std::array<std::vector<QString>, kHeads>& heads() {
  static const std::array<std::vector<QString>, kHeads> kNames = {{
      {u"studentnumber"_qs, u"studentid"_qs, u"matrikelnummer"_qs, u"matrikelnr"_qs, u"matrnr"_qs, u"number"_qs, u"nummer"_qs, u"id"_qs},
      {u"name"_qs, u"fullname"_qs, u"student"_qs},
      {u"firstname"_qs, u"givenname"_qs, u"forename"_qs, u"vorname"_qs},
      {u"surname"_qs, u"lastname"_qs, u"familyname"_qs, u"nachname"_qs, u"familienname"_qs},
      {u"pin"_qs},
      {u"cohort"_qs, u"group"_qs, u"class"_qs, u"kohorte"_qs, u"gruppe"_qs, u"semester"_qs},
  }};
  return kNames;
}

std::array<int, kHeads> columns_of(const std::vector<QString>& row) {
  static const QRegularExpression kDropped(QStringLiteral("[\\s._-]"));
  std::array<int, kHeads> out;
  out.fill(-1);
  std::array<std::ptrdiff_t, kHeads> rank;
  rank.fill(PTRDIFF_MAX);
  for (std::size_t i = 0; i < row.size(); ++i) {
    QString head = row[i].toCaseFolded();
    head.remove(kDropped);
    for (std::size_t h = 0; h < kHeads; ++h) {
      const auto at = std::ranges::find(heads()[h], head) - heads()[h].begin();
      if (at == std::ssize(heads()[h]) || at >= rank[h]) continue;
      rank[h] = at;
      out[h] = static_cast<int>(i);
    }
  }
  return out;
}

/// "Name, Vorname" of a German list are surname and first name; another list has the whole name beside the first one.
QString whole_name(const QString& first, const QString& surname, const QString& name) {
  if (!surname.isEmpty()) return (first + u' ' + surname).trimmed();
  static const QRegularExpression kBetween(QStringLiteral("[\\s,]+"));
  const bool holds_first = name.split(kBetween, Qt::SkipEmptyParts).contains(first.section(kBetween, 0, 0), Qt::CaseInsensitive);
  return first.isEmpty() || holds_first ? name : (first + u' ' + name).trimmed();
}

ListedStudent student_of(const std::vector<QString>& row, const std::array<int, kHeads>& columns) {
  const auto cell = [&](Head head) {
    const int i = columns[head];
    return i >= 0 && static_cast<std::size_t>(i) < row.size() ? row[static_cast<std::size_t>(i)] : QString();
  };
  ListedStudent out;
  out.number = without_marks(cell(kNumberHead));
  out.name = without_marks_but_joiners(whole_name(cell(kFirstHead), cell(kSurnameHead), cell(kNameHead)));
  out.pin = without_marks(cell(kPinHead));
  out.cohort = without_marks_but_joiners(cell(kCohortHead));
  return out;
}

ListedStudent::Problem problem_of(const ListedStudent& student) {
  using enum ListedStudent::Problem;
  static const QRegularExpression kSixDigits(QStringLiteral("^[0-9]{6}$"));
  if (student.number.isEmpty()) return no_number;
  if (student.name.isEmpty()) return no_name;
  const auto longer = [](const QString& text, std::size_t most) { return !has_length(text.toStdString(), 0, most); };
  if (longer(student.number, kMostNumber) || longer(student.name, kMostName) || longer(student.cohort, kMostCohortName)) return too_long;
  if (!student.pin.isEmpty() && !kSixDigits.match(student.pin).hasMatch()) return bad_pin;
  return none;
}

void find_namesakes(std::vector<ListedStudent>& list, const std::vector<Account>& accounts) {
  std::set<QString> listed;
  for (const ListedStudent& student : list) listed.insert(student.number.toCaseFolded());
  std::map<std::string, std::vector<QString>> numbers;  // [agreeing_name()]
  for (const Account& account : accounts)
    if (account.role == Role::student && !account.disabled) numbers[agreeing_name(account.name)].push_back(QString::fromStdString(account.number));
  for (ListedStudent& student : list) {
    const auto same = student.state == ListedStudent::State::fresh ? numbers.find(agreeing_name(student.name.toStdString())) : numbers.end();
    if (same == numbers.end() || same->second.size() > 1 || listed.contains(same->second.front().toCaseFolded())) continue;
    student.namesake = same->second.front();
  }
}

}  // namespace

Result<CsvTable, CsvFailure> read_csv(const QString& text) { return CsvReader(text).read(); }

QString decode_text(const QByteArray& bytes) {
  QStringDecoder marked(QStringConverter::encodingForData(bytes).value_or(QStringConverter::Utf8));
  const QString text = marked(bytes);
  if (!marked.hasError()) return text;
  QString out = QString::fromLatin1(bytes);
  // The signs that Windows-1252 has beyond Latin-1 and that names hold.
  constexpr std::array<std::pair<char16_t, char16_t>, 6> kBeyond = {
      {{0x8a, u'Š'}, {0x9a, u'š'}, {0x8e, u'Ž'}, {0x9e, u'ž'}, {0x92, u'’'}, {0x9f, u'Ÿ'}}};
  for (const auto& [from, to] : kBeyond) out.replace(QChar(from), QChar(to));
  return out;
}

Result<std::vector<ListedStudent>, ListFailure> read_student_list(const QByteArray& file, const std::vector<Account>& accounts) {
  const auto table = read_csv(decode_text(file));
  if (!table) return fail(ListError::open_quote, table.error().where);
  if (table->rows.empty()) return fail(ListError::empty, "list");
  const auto columns = columns_of(table->rows.front());
  if (columns[kNumberHead] < 0 || (columns[kNameHead] < 0 && columns[kSurnameHead] < 0)) return fail(ListError::no_columns, "heads");
  if (table->rows.size() < 2) return fail(ListError::empty, "list");

  std::map<QString, const Account*> by_number;
  for (const Account& account : accounts) by_number[QString::fromStdString(account.number).toCaseFolded()] = &account;
  std::vector<ListedStudent> out;
  std::set<QString> seen;
  for (std::size_t i = 1; i < table->rows.size(); ++i) {
    ListedStudent student = student_of(table->rows[i], columns);
    student.line = table->lines[i];
    student.problem = problem_of(student);
    const QString key = student.number.toCaseFolded();
    if (student.problem == ListedStudent::Problem::none && !seen.insert(key).second) student.problem = ListedStudent::Problem::twice;
    if (const auto it = by_number.find(key); student.problem == ListedStudent::Problem::none && it != by_number.end()) {
      if (it->second->role != Role::student) student.problem = ListedStudent::Problem::staff;
      // An older program kept the marks and blanks of its list.
      const bool same = without_marks_but_joiners(QString::fromStdString(it->second->name).normalized(QString::NormalizationForm_C)) == student.name;
      student.state = same ? ListedStudent::State::known : ListedStudent::State::other_name;
      student.switched_off = same && it->second->disabled;
    }
    if (student.problem != ListedStudent::Problem::none) student.state = ListedStudent::State::bad;
    out.push_back(std::move(student));
  }
  find_namesakes(out, accounts);
  return out;
}

}  // namespace cusp::ui

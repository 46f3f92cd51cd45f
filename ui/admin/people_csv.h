/// A list of students from a spreadsheet: CSV (RFC 4180) with comma, semicolon or tab, in UTF-8, UTF-16 or Windows-1252. No widget.
#pragma once

#include <QByteArray>
#include <QString>
#include <optional>
#include <vector>

#include "engine/base/result.h"
#include "storage/repositories/accounts.h"
#include "ui/modules.h"

namespace cusp::ui {

struct CsvTable {
  std::vector<std::vector<QString>> rows;
  std::vector<int> lines;  // [row] its first line in the file, from 1
};
enum class CsvError : std::uint8_t { open_quote };  // where: the line at which the quote opens
using CsvFailure = Failure<CsvError>;
/// Quoted cells may hold separators, line breaks and doubled quotes. Empty lines are left out. The first line decides the
/// separator: it has most of it outside quotes, or is "sep=;" and stands above the heads. A line ends as on any system.
Result<CsvTable, CsvFailure> read_csv(const QString& text);
/// UTF-8 with or without a mark, UTF-16 with one, else Windows-1252.
QString decode_text(const QByteArray& bytes);

struct ListedStudent {
  enum class State : std::uint8_t {
    fresh,       // an account is to be made
    known,       // there is an account with this number and name
    other_name,  // this number has an account with another name: it stays as it is
    bad,         // see problem
  };
  enum class Problem : std::uint8_t { none, no_number, no_name, too_long, twice, bad_pin, staff };
  int line = 0;
  QString number, name, pin, cohort;  // pin and cohort may be empty
  State state = State::fresh;
  QString namesake;  // of a fresh line: the number of the one account that has its name and that the list leaves out: perhaps the same person's
  bool made = false;  // the account, by this import
  bool switched_off = false;  // the account that is known: nobody signs in with it
  Problem problem = Problem::none;
};

enum class ListError : std::uint8_t {
  open_quote,  // where: line
  no_columns,  // the first line names neither number nor name
  empty,       // no line below the heads
};
using ListFailure = Failure<ListError>;

/// Columns by their heads, English or German: number, name (or first name and surname), PIN, cohort. Others are left out.
/// A name beside a first name is the surname unless it holds the first name too. Marks that nobody sees are left out of each cell.
Result<std::vector<ListedStudent>, ListFailure> read_student_list(const QByteArray& file, const std::vector<Account>& accounts);

}  // namespace cusp::ui

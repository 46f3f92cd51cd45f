#include "ui/report/paper_remarks.h"

#include <QCoreApplication>
#include <QStringList>
#include <optional>

#include "ui/widgets/format.h"
#include "ui/widgets/theme.h"

namespace cusp::ui {
namespace {

struct RemarksText {
  Q_DECLARE_TR_FUNCTIONS(cusp::ui::Report)
};

constexpr double kRemarkFoot = 60;  // px at 100 %, left free below the last remark of a sheet

/// How many characters of a paragraph `room` holds, in whole words. Pre: it holds a line.
qsizetype fitting(Paper& paper, const QString& text, const Paper::Type& type, double room) {
  const auto fits = [&](qsizetype size) { return paper.height_of(text.left(size), paper.page().width(), type) <= room; };
  if (fits(text.size())) return text.size();
  qsizetype least = 1, most = text.size();  // what fits, and what does not
  while (most - least > 1) {
    const qsizetype middle = (least + most) / 2;
    (fits(middle) ? least : most) = middle;
  }
  const qsizetype blank = text.lastIndexOf(u' ', least);
  return blank > 0 ? blank : least;
}

}  // namespace

void write_remarks(const std::vector<Remark>& remarks, double bottom, const std::function<Paper()>& begin_sheet) {
  if (remarks.empty()) return;
  const Tokens& t = Tokens::light();
  std::optional<Paper> paper;
  paper.emplace(begin_sheet());
  const Paper::Column whole{paper->page().left(), paper->page().width()};
  const auto write = [&](QString text, Weight weight, const QColor& ink) {
    const Paper::Type type{11, weight, ink};
    while (!text.isEmpty()) {
      if (paper->y() > bottom - paper->u(kRemarkFoot)) paper.emplace(begin_sheet());
      const qsizetype size = fitting(*paper, text, type, bottom - paper->y());
      paper->write(text.left(size), whole, type);
      text = text.mid(size).trimmed();
    }
  };
  paper->write(RemarksText::tr("Remarks"), whole, {13, Weight::bold, t.text});
  paper->skip(4);
  for (const Remark& remark : remarks) {
    const QColor& ink = remark.superseded ? t.text3 : t.text;
    write(remark.who + u", "_qs + format_date_time_zone(remark.when), Weight::bold, ink);
    QStringList lines = remark.text.split(u'\n', Qt::SkipEmptyParts);
    if (!remark.what.isEmpty()) lines.prepend(remark.what);
    for (const QString& line : lines) write(line, Weight::regular, ink);
    paper->skip(8);
  }
}

}  // namespace cusp::ui

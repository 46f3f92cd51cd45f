#include "ui/admin/people_import.h"

#include <QBoxLayout>
#include <QFile>
#include <QFileInfo>
#include <QPushButton>
#include <QStackedWidget>
#include <algorithm>
#include <iterator>
#include <map>
#include <set>

#include "ui/admin/on_window.h"
#include "ui/admin/pin_slips.h"
#include "ui/text/exchange_text.h"
#include "ui/text/failure_text.h"
#include "ui/widgets/busy.h"
#include "ui/widgets/empty_state.h"
#include "ui/widgets/format.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/table.h"
#include "ui/widgets/theme.h"

namespace cusp::ui {
namespace {

using State = ListedStudent::State;
constexpr qint64 kMostBytes = 4 << 20;  // a list of 2,000 students has about 100 kB

std::vector<PinSlip> slips_of(const std::vector<ListedStudent>& lines) {
  std::vector<PinSlip> out;
  for (const ListedStudent& line : lines)
    if (line.state == State::fresh) out.push_back({line.name, line.number, line.pin, line.cohort});
  return out;
}

}  // namespace

PeopleImport::PeopleImport(Store& store, const Actor& actor, const Ports& ports, QWidget* parent)
    : QWidget(parent), store_(store), actor_(actor), ports_(ports), model_(new StudentListModel(this)) {
  setProperty("kind", u"page"_qs);
  setAttribute(Qt::WA_StyledBackground);
  setAccessibleName(tr("Import a list of students"));
  auto* outer = new QVBoxLayout(this);
  outer->setContentsMargins(px(24), px(16), px(24), px(24));
  outer->setSpacing(px(12));
  QPushButton* back = make_button(tr("People"), ButtonKind::quiet, u"chevron_left"_qs, QKeySequence(Qt::ALT | Qt::Key_Left));
  outer->addWidget(back, 0, Qt::AlignLeft);
  auto* head = new PageHead(tr("Import a list of students"), tr("CSV with the columns number and name, and if wanted PIN and cohort"));
  choose_ = make_button(tr("Choose a file"), ButtonKind::standard, u"import"_qs);
  start_ = make_button(tr("Make the accounts"), ButtonKind::primary);
  for (QPushButton* button : {choose_, start_}) head->buttons()->addWidget(button);
  outer->addWidget(head);
  band_ = new Band;
  outer->addWidget(band_);
  run_ = new WorkRun(this);
  outer->addWidget(run_->busy());
  auto* card = new Card;
  auto* table = new Table;
  table->setAccessibleName(tr("Lines of the list"));
  table->setModel(model_);
  table->set_stretch_column(StudentListModel::kName);
  shown_ = new QStackedWidget;
  shown_->addWidget(new EmptyState(u"people"_qs, tr("No list yet"), tr("Each line becomes an account once you have looked at it here.")));
  shown_->addWidget(table);
  card->body()->addWidget(shown_);
  outer->addWidget(card, 1);
  connect(back, &QPushButton::clicked, this, &PeopleImport::leave);
  connect(choose_, &QPushButton::clicked, this, &PeopleImport::choose_file);
  connect(start_, &QPushButton::clicked, this, &PeopleImport::start);
  fit_buttons();
  setFocusProxy(choose_);
}

PeopleImport::~PeopleImport() { stop(); }

QString PeopleImport::message() const { return band_->isVisibleTo(this) ? band_->text() : QString(); }

void PeopleImport::show_failure(const StorageFailure& failure) {
  const Message message = describe(failure);
  band_->show_message(Band::Kind::bad, message.what, message.more);
}

void PeopleImport::fit_buttons() {
  choose_->setEnabled(!working());
  start_->setEnabled(!working() && !to_do().empty());
  shown_->setCurrentIndex(model_->rowCount() == 0 ? 0 : 1);
}

std::vector<ListedStudent> PeopleImport::to_do() const {
  std::map<QString, std::set<UserId>> inside;  // [name of a cohort] its students
  const auto joins = [&](const ListedStudent& student) {
    if (student.state != State::known || student.cohort.isEmpty()) return false;
    const auto [at, unread] = inside.try_emplace(student.cohort);
    if (unread) {
      if (const auto cohort = store_.cohorts.find_name(student.cohort.toStdString()))
        if (const auto students = store_.cohorts.students(cohort->id)) at->second.insert(students->begin(), students->end());
    }
    const auto account = store_.accounts.find_number(student.number.toStdString());
    return !account || !at->second.contains(account->id);  // another desk may have erased it: the import names the line
  };
  std::vector<ListedStudent> out;
  std::ranges::copy_if(model_->students(), std::back_inserter(out), [&](const ListedStudent& s) { return s.state == State::fresh || joins(s); });
  return out;
}

void PeopleImport::leave() {
  if (working()) return stop();
  Q_EMIT back_wanted();
}

void PeopleImport::choose_file() {
  ports_.pick_file(this, {tr("Choose a list of students"), {}, tr("CSV (*.csv *.txt)"), false}, [this](const QString& path) { read_file(path); });
}

void PeopleImport::read_file(const QString& path) {
  QFile file(path);
  if (!file.open(QIODevice::ReadOnly)) {
    band_->show_message(Band::Kind::bad, tr("%1 cannot be read.").arg(QFileInfo(path).fileName()), file.errorString());
    return;
  }
  const QByteArray bytes = file.read(kMostBytes + 1);  // a device has no size, and may have no end
  if (bytes.size() > kMostBytes) {
    band_->show_message(Band::Kind::bad, tr("%1 is too large for a list of students.").arg(QFileInfo(path).fileName()), tr("4 MB are the most."));
    return;
  }
  const auto accounts = store_.accounts.list(actor_);
  if (!accounts) return show_failure(accounts.error());
  auto list = read_student_list(bytes, *accounts);
  if (!list) {
    model_->set_students({});
    fit_buttons();
    const QString more = list.error().code == ListError::open_quote
                             ? tr("A quote that opens in line %1 is never closed.").arg(QString::fromStdString(list.error().where))
                         : list.error().code == ListError::empty
                             ? tr("It has no line below the heads of the columns.")
                             : tr("Its first line needs the heads number and name, or number, first name and surname.");
    band_->show_message(Band::Kind::bad, tr("%1 is no list of students.").arg(QFileInfo(path).fileName()), more);
    return;
  }
  model_->set_students(std::move(*list));
  fit_buttons();
  const int bad = model_->count(State::bad), other = model_->count(State::other_name);
  const QString what = tr("%n new account(s).", nullptr, model_->count(State::fresh));
  QStringList more;
  if (const int known = model_->count(State::known); known > 0) more += tr("%n student(s) have one already.", nullptr, known);
  const auto off = std::ranges::count_if(model_->students(), [](const ListedStudent& s) { return s.state == State::known && s.switched_off; });
  if (off > 0) more += tr("Switched off, so that nobody signs in with them: %1. Switch them on under People.").arg(count_text(static_cast<std::size_t>(off)));
  const auto named = std::ranges::count_if(model_->students(), [](const ListedStudent& s) { return !s.namesake.isEmpty(); });
  if (named > 0) more += tr("%n new name(s) have an account under another number: perhaps the same person.", nullptr, static_cast<int>(named));
  if (other > 0) more += tr("%n number(s) belong to another name and stay as they are.", nullptr, other);
  if (bad > 0) more += tr("%n line(s) are left out; the table says why.", nullptr, bad);
  band_->show_message(bad + other + off + named > 0 ? Band::Kind::look : Band::Kind::info, what, more.join(u' '));
}

void PeopleImport::start() {
  if (working()) return;
  if (model_->count(State::fresh) == 0) return make({});
  FileWish wish{tr("Save the PIN slips"), tr("PIN slips %1.pdf").arg(ports_.now().toString(u"yyyy-MM-dd HH-mm"_qs)), tr("PDF (*.pdf)")};
  wish.what = FileWish::What::new_file;  // slips of another list may stand there
  ports_.pick_file(this, wish, [this](const QString& path) { make(path); });
}

void PeopleImport::make(const QString& slips) {
  if (working()) return;
  PeopleImportWork work{records_of(store_), actor_, to_do(), slips.toStdString()};
  give_pins(work.lines);
  band_->clear();
  if (!slips.isEmpty()) {
    if (QFile::exists(slips)) {
      const Message taken = describe_exchange_failure({StorageError::duplicate, slips.toStdString(), {}}, slips);
      return band_->show_message(Band::Kind::bad, taken.what, taken.more);
    }
    if (const auto written = write_pin_slips(work.slips, slips_of(work.lines)); !written) {
      const QString cause = QString::fromStdString(written.error().detail);
      return band_->show_message(Band::Kind::bad, tr("%1 cannot be written: %2.").arg(isolate(slips), cause), tr("Choose another place. No account was made."));
    }
  }
  progress_ = run_->start(tr("Making accounts"),
                          [](std::size_t done, std::size_t all) { return tr("%1 of %2").arg(count_text(done), count_text(all)); });
  fit_buttons();
  task_ = make_accounts(std::move(work), progress_, on_window<PeopleImportEnd>(this, &PeopleImport::end));
}

void PeopleImport::stop() { run_->cancel(); }

void PeopleImport::end(const PeopleImportEnd& end) {
  progress_.reset();
  if (!end.failure) {
    // A second start has nothing left to do. A line that was left out may repeat the number of another.
    std::vector<ListedStudent> lines = model_->students();
    for (ListedStudent& line : lines) {
      line.made = line.made || line.state == State::fresh;
      if (line.state == State::fresh) line.state = State::known;
    }
    model_->set_students(std::move(lines));
  }
  fit_buttons();
  run_->finish(choose_);
  show_end(end);
}

void PeopleImport::show_end(const PeopleImportEnd& end) {
  if (!end.failure) {
    const QString made = tr("%n account(s) made.", nullptr, end.made);
    const QString file = QString::fromStdString(end.slips.string());
    return band_->show_message(Band::Kind::good, tr("The list is imported."), file.isEmpty() ? made : made + u' ' + tr("Their PINs stand in %1 alone.").arg(isolate(file)));
  }
  const bool stopped = end.failure->code == StorageError::stopped;
  const QString what = stopped         ? tr("Stopped.")
                       : end.line == 0 ? describe(*end.failure).line()
                                       : tr("Stopped at line %1.").arg(end.line) + u' ' + describe(*end.failure).line();
  band_->show_message(stopped ? Band::Kind::look : Band::Kind::bad, what, tr("No account was made."));
}

}  // namespace cusp::ui

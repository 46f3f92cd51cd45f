#include "ui/admin/people_import.h"

#include <QBoxLayout>
#include <QFile>
#include <QFileInfo>
#include <QPushButton>
#include <QRandomGenerator>
#include <QTimer>
#include <algorithm>

#include "ui/text/failure_text.h"
#include "ui/widgets/busy.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/table.h"
#include "ui/widgets/theme.h"

namespace cusp::ui {
namespace {

using State = ListedStudent::State;
constexpr qint64 kMostBytes = 4 << 20;  // a list of 2,000 students has about 100 kB

QString fresh_pin() { return QStringLiteral("%1").arg(QRandomGenerator::system()->bounded(1'000'000), 6, 10, QLatin1Char('0')); }

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
  save_ = make_button(tr("Save the PIN slips"), ButtonKind::standard, u"print"_qs);
  for (QPushButton* button : {choose_, start_, save_}) head->buttons()->addWidget(button);
  outer->addWidget(head);
  band_ = new Band;
  outer->addWidget(band_);
  busy_ = new Busy;
  busy_->hide();
  outer->addWidget(busy_);
  auto* card = new Card;
  auto* table = new Table;
  table->setAccessibleName(tr("Lines of the list"));
  table->setModel(model_);
  table->set_stretch_column(StudentListModel::kName);
  card->body()->addWidget(table);
  outer->addWidget(card, 1);
  connect(back, &QPushButton::clicked, this, &PeopleImport::leave);
  connect(choose_, &QPushButton::clicked, this, &PeopleImport::choose_file);
  connect(start_, &QPushButton::clicked, this, &PeopleImport::start);
  connect(save_, &QPushButton::clicked, this, &PeopleImport::save_slips);
  connect(busy_, &Busy::cancelled, this, [this] { end(Ending::stopped, tr("Stopped.")); });
  fit_buttons();
  setFocusProxy(choose_);
}

QString PeopleImport::message() const { return band_->isVisibleTo(this) ? band_->text() : QString(); }

void PeopleImport::show_failure(const StorageFailure& failure) {
  const Message message = describe(failure);
  band_->show_message(Band::Kind::bad, message.what, message.more);
}

void PeopleImport::fit_buttons() {
  choose_->setEnabled(!working());
  start_->setEnabled(!working() && model_->count(State::fresh) > 0);
  save_->setEnabled(!working() && !slips_.empty());
}

void PeopleImport::leave() {
  if (working()) return end(Ending::stopped, tr("Stopped."));
  if (slips_.empty() || slips_saved_) return Q_EMIT back_wanted();
  ports_.ask(this, {tr("Leave without the PIN slips?"), tr("The PINs stand nowhere else. Each student would need a new one."), tr("Leave"), true},
             [this](bool yes) {
               if (yes) Q_EMIT back_wanted();
             });
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
  if (file.size() > kMostBytes) {
    band_->show_message(Band::Kind::bad, tr("%1 is too large for a list of students.").arg(QFileInfo(path).fileName()), tr("4 MB are the most."));
    return;
  }
  const auto accounts = store_.accounts.list(actor_);
  if (!accounts) return show_failure(accounts.error());
  auto list = read_student_list(file.readAll(), *accounts);
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
  if (other > 0) more += tr("%n number(s) belong to another name and stay as they are.", nullptr, other);
  if (bad > 0) more += tr("%n line(s) are left out; the table says why.", nullptr, bad);
  band_->show_message(bad + other > 0 ? Band::Kind::look : Band::Kind::info, what, more.join(u' '));
}

void PeopleImport::start() {
  order_.clear();
  std::ranges::copy_if(model_->students(), std::back_inserter(order_),
                       [](const ListedStudent& s) { return s.state == State::fresh || (s.state == State::known && !s.cohort.isEmpty()); });
  next_ = 0;
  slips_.clear();
  slips_saved_ = false;
  cohorts_.clear();
  const auto list = store_.cohorts.list();
  if (!list) return show_failure(list.error());
  for (const Cohort& cohort : *list) cohorts_[QString::fromStdString(cohort.name).toCaseFolded()] = cohort.id;
  band_->clear();
  busy_->start(tr("Making accounts"), Busy::Cancel::offered);
  fit_buttons();
  QTimer::singleShot(0, this, &PeopleImport::step);
}

void PeopleImport::step() {
  if (!working()) return;  // stopped
  if (!make(order_[next_])) return;
  ++next_;
  busy_->set_progress(static_cast<double>(next_) / static_cast<double>(order_.size()),
                      tr("%1 of %2").arg(QLocale().toString(next_), QLocale().toString(order_.size())));
  if (!working()) return end(Ending::whole, tr("The list is imported."));
  QTimer::singleShot(0, this, &PeopleImport::step);
}

Stored<CohortId> PeopleImport::cohort_named(const QString& name) {
  const auto it = cohorts_.find(name.toCaseFolded());
  if (it != cohorts_.end()) return it->second;
  const auto made = store_.cohorts.create(actor_, name.toStdString());
  if (!made) return std::unexpected(made.error());
  cohorts_[name.toCaseFolded()] = made->id;
  return made->id;
}

bool PeopleImport::make(const ListedStudent& student) {
  const auto stop = [this, &student](const StorageFailure& failure) {
    end(Ending::failed, tr("Stopped at line %1.").arg(student.line) + u' ' + describe(failure).line());
    return false;
  };
  UserId id;
  if (student.state == State::fresh) {
    const QString pin = student.pin.isEmpty() ? fresh_pin() : student.pin;
    const auto made = store_.accounts.create(
        actor_, {student.number.toStdString(), student.name.toStdString(), Role::student, {}, pin.toStdString()});
    if (!made) return stop(made.error());
    id = made->id;
    slips_.push_back({student.name, student.number, pin, student.cohort});
  } else {
    const auto found = store_.accounts.find_number(student.number.toStdString());
    if (!found) return stop(found.error());
    id = found->id;
  }
  if (student.cohort.isEmpty()) return true;
  const auto cohort = cohort_named(student.cohort);
  if (!cohort) return stop(cohort.error());
  if (const auto added = store_.cohorts.add(actor_, *cohort, id); !added) return stop(added.error());
  return true;
}

void PeopleImport::end(Ending ending, const QString& what) {
  order_.clear();
  next_ = 0;
  busy_->finish();
  // A second start makes what is left: lines that were done are known now.
  std::vector<ListedStudent> lines = model_->students();
  for (ListedStudent& line : lines)
    if (std::ranges::any_of(slips_, [&](const PinSlip& slip) { return slip.number == line.number; })) line.state = State::known;
  model_->set_students(std::move(lines));
  fit_buttons();
  const Band::Kind kind = ending == Ending::whole     ? Band::Kind::good
                          : ending == Ending::stopped ? Band::Kind::look
                                                      : Band::Kind::bad;
  band_->show_message(kind, what,
                      tr("%n account(s) made.", nullptr, static_cast<int>(slips_.size())) +
                          (slips_.empty() ? QString() : u' ' + tr("Save the PIN slips now: the PINs stand nowhere else.")));
}

void PeopleImport::save_slips() {
  ports_.pick_file(this, {tr("Save the PIN slips"), tr("PIN slips.pdf"), tr("PDF (*.pdf)"), true}, [this](const QString& path) {
    if (!write_pin_slips(path.toStdString(), slips_)) {
      band_->show_message(Band::Kind::bad, tr("%1 cannot be written.").arg(path), tr("Choose another place. The accounts are kept."));
      return;
    }
    slips_saved_ = true;
    band_->show_message(Band::Kind::good, tr("The PIN slips are saved."), path);
  });
}

}  // namespace cusp::ui

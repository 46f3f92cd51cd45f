#include "ui/report/pack_card.h"

#include <QApplication>
#include <QBoxLayout>
#include <QLabel>
#include <QPointer>
#include <QPushButton>

#include "ui/text/incident_text.h"
#include "ui/widgets/busy.h"
#include "ui/widgets/format.h"
#include "ui/widgets/theme.h"

namespace cusp::ui {
namespace {

constexpr std::size_t kFindingsShown = 3;

}  // namespace

PackCard::PackCard(std::shared_ptr<const OpenedPack> pack, QWidget* parent) : Card(tr("Appeal pack"), {}, parent), pack_(std::move(pack)) {
  setAccessibleName(tr("Appeal pack"));
  set_aside(tr("made %1").arg(format_day_time(local_time(pack_->checked.description.made_utc_us))));
  found_ = new Band;
  body()->addWidget(found_);
  const QString key = fingerprint(pack_->checked.key);
  const QString signer = pack_->signer == PackSigner::this_station
                             ? tr("Signed by this station, key %1.").arg(key)
                             : tr("Signed by the key %1, which these records do not know: compare it with the one on that station’s page.").arg(key);
  if (!pack_->whole()) {
    found_->show_message(Band::Kind::bad, tr("This pack was changed after it was made."), findings() + u' ' + signer);
  } else {
    const Band::Kind kind = pack_->signer == PackSigner::this_station ? Band::Kind::good : Band::Kind::look;
    found_->show_message(kind, tr("Nothing was changed: %n file(s), and every record of the attempt.", nullptr,
                                  static_cast<int>(pack_->checked.description.files.size())),
                         signer);
  }
  replayed_ = new Band;
  body()->addWidget(replayed_);
  busy_ = new Busy;
  busy_->hide();
  body()->addWidget(busy_);
  prove_ = make_button(tr("Compute the attempt anew"), ButtonKind::standard, u"refresh"_qs);
  auto* row = new QHBoxLayout;
  row->addWidget(prove_);
  QLabel* why = make_label(tr("from its trace, and compare tooth and grade"), TextRole::body, Weight::regular, "text2");
  why->setWordWrap(true);
  row->addWidget(why, 1);
  body()->addLayout(row);
  connect(prove_, &QPushButton::clicked, this, &PackCard::prove);
}

QString PackCard::findings() const {
  QStringList out;
  if (!pack_->checked.signature_holds) out += tr("The signature does not belong to this description.");
  if (!pack_->differing.empty()) {
    QStringList names;
    for (const std::string& name : pack_->differing) names += QString::fromStdString(name);
    out += tr("Not as they were signed: %1.").arg(names.join(QStringLiteral(", ")));
  }
  for (std::size_t i = 0; i < pack_->findings.size() && i < kFindingsShown; ++i) out += finding_text(pack_->findings[i]);
  return out.join(u' ');
}

void PackCard::prove() {
  if (proving_) return;
  proving_ = true;
  prove_->setEnabled(prove_ == window()->focusWidget());  // a disabled one hands the focus on
  busy_->start(tr("Computing the attempt anew"), Busy::Cancel::none);
  task_ = BackgroundTask([card = QPointer<PackCard>(this), pack = pack_] {
    auto proof = std::make_shared<Result<ReplayProof, Message>>(prove_pack(*pack));
    QMetaObject::invokeMethod(
        qApp,
        [card, proof] {
          if (card) card->show_proof(*proof);
        },
        Qt::QueuedConnection);
  }, BackgroundTask::Holds::nothing);
}

void PackCard::show_proof(const Result<ReplayProof, Message>& proof) {
  proving_ = false;
  busy_->finish();
  prove_->setEnabled(true);
  if (!proof) return replayed_->show_message(Band::Kind::bad, proof.error().what, proof.error().more);
  if (!proof->holds()) return replayed_->show_message(Band::Kind::bad, tr("The trace does not lead to this result."), proof_text(*proof));
  if (!proof->same_engine) {
    return replayed_->show_message(Band::Kind::look, tr("This program cannot compute the attempt anew."),
                                   tr("It was drilled with engine %1; this is engine %2. The records hold.").arg(proof->engine_version).arg(kEngineVersion));
  }
  replayed_->show_message(Band::Kind::good, tr("The trace leads to this tooth and this grade, bit for bit."), {});
}

}  // namespace cusp::ui

/// What verification found of an opened appeal pack: signature, files, records; and, if asked for, the replay of its trace.
/// Thread: GUI; the replay runs in the background on the pack's own records.
#pragma once

#include <memory>

#include "ui/report/appeal_pack.h"
#include "ui/session/background_task.h"
#include "ui/widgets/parts.h"

namespace cusp::ui {

class Busy;

class PackCard : public Card {
  Q_OBJECT

 public:
  explicit PackCard(std::shared_ptr<const OpenedPack> pack, QWidget* parent = nullptr);
  bool proving() const { return proving_; }

 public Q_SLOTS:
  void prove();

 private:
  QString findings() const;
  void show_proof(const Result<ReplayProof, Message>& proof);

  std::shared_ptr<const OpenedPack> pack_;
  Band *found_, *replayed_;
  Busy* busy_;
  QPushButton* prove_;
  BackgroundTask task_;
  bool proving_ = false;
};

}  // namespace cusp::ui

/// The foot of the score panel: whether the attempt is kept, and whether picture and scores have caught up with the bur.
/// Thread: GUI.
#pragma once

#include <QHBoxLayout>
#include <cstdint>
#include <optional>

#include "ui/modules.h"
#include "ui/session/observer.h"

class QLabel;

namespace cusp::ui {

/// What the foot says, the gravest first.
enum class SessionNews : std::uint8_t {
  failed,          // the record cannot be written
  too_slow,        // LiveView::ring_warning: the attempt ends soon unless the bur is lifted
  picture_behind,  // by a second or more
  disk_behind,
  recording,
  off,
};

/// Picture and scores this far behind the bur mislead a hand.
inline constexpr double kPictureBehindS = 1.0;

/// s of the session: how far picture and scores are behind the bur. Not from ticks: a slow computer's last longer than 1 ms.
double picture_behind_s(const LiveView& live) noexcept;

SessionNews session_news(const LiveView& live) noexcept;

class SessionFoot : public QHBoxLayout {
  Q_OBJECT

 public:
  SessionFoot();

  QString text() const;
  /// Reads what is new aloud if it asks for an act.
  void show_values(const LiveView& live);

 private:
  QLabel *icon_, *text_;
  std::optional<SessionNews> shown_;
};

}  // namespace cusp::ui

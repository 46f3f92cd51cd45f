/// Help: how an attempt works, and every key. Searched by nobody, read by everybody once: one page.
#pragma once

#include <QWidget>

#include "storage/base/rights.h"
#include "ui/modules.h"

class QHBoxLayout;

namespace cusp::ui {

class HelpPage : public QWidget {
  Q_OBJECT

 public:
  /// Staff are offered the quick start, and have no page of their own results.
  explicit HelpPage(Role role, QWidget* parent = nullptr);

 Q_SIGNALS:
  void quick_start_wanted();

 private:
  static QHBoxLayout* make_keys();
};

}  // namespace cusp::ui

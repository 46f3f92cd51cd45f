/// Help: how an attempt works, and every key. Searched by nobody, read by everybody once: one page.
#pragma once

#include <QWidget>

namespace cusp::ui {

class HelpPage : public QWidget {
  Q_OBJECT

 public:
  explicit HelpPage(QWidget* parent = nullptr);
};

}  // namespace cusp::ui

#include "ui/editor/later_forms.h"

#include <QScrollArea>
#include <algorithm>

namespace cusp::ui {

LaterForms::LaterForms() {
  turn_.setSingleShot(true);
  turn_.setInterval(0);
  turn_.callOnTimeout([this] { fill_next(); });
}

QWidget* LaterForms::add(Make make) {
  auto* area = new QScrollArea;
  area->setWidgetResizable(true);
  area->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  area->setFrameShape(QFrame::NoFrame);
  area->setFocusPolicy(Qt::NoFocus);
  waiting_.push_back({area, std::move(make)});
  turn_.start();
  return area;
}

void LaterForms::fill(QWidget* page) {
  const auto it = std::ranges::find_if(waiting_, [page](const Waiting& one) { return one.area == page; });
  if (it == waiting_.end()) return;
  const Waiting one = std::move(*it);
  waiting_.erase(it);
  fill(one);
}

void LaterForms::fill(const Waiting& one) {
  if (!one.area) return;
  QWidget* form = one.make();
  form->setProperty("kind", u"page_surface"_qs);
  form->setAttribute(Qt::WA_StyledBackground);
  one.area->setWidget(form);
  form->show();
}

void LaterForms::fill_next() {
  if (waiting_.empty()) return;
  const Waiting one = std::move(waiting_.front());
  waiting_.pop_front();
  fill(one);
  turn_.start();
}

}  // namespace cusp::ui

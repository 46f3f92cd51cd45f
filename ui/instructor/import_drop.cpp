#include "ui/instructor/import_drop.h"

#include <QBoxLayout>
#include <QLabel>
#include <QPushButton>

#include "ui/widgets/empty_state.h"
#include "ui/widgets/theme.h"

namespace cusp::ui {

ImportDrop::ImportDrop(QWidget* parent) : Card(parent) {
  auto* empty = new EmptyState(u"import"_qs, tr("Drop files here"), tr("or choose them. Several surfaces are put together, each of one tissue."),
                               tr("Choose a file…"), Ink::accent);
  button_ = empty->button();
  set_kind(button_, "primary");
  connect(empty, &EmptyState::acted, this, &ImportDrop::choose);
  body()->addWidget(empty, 1);
  body()->addWidget(make_rule());
  auto* kinds = new QHBoxLayout;
  kinds->setContentsMargins(px(8), px(8), px(8), px(8));
  kinds->setSpacing(px(24));
  add_kind(*kinds, tr("Surfaces"), u"STL, OBJ, PLY, 3DS, OFF"_qs, tr("From a scanner or a modeller. Closed, or with gaps that are mended."));
  add_kind(*kinds, tr("Volumes"), u"NRRD, MetaImage, NIfTI, binvox"_qs, tr("Labels, colours or ranges of grey become tissues."));
  add_kind(*kinds, tr("CT"), u"DICOM"_qs, tr("One slice names its series. Nothing about the patient is read."));
  body()->addLayout(kinds);
}

void ImportDrop::add_kind(QHBoxLayout& row, const QString& name, const QString& formats, const QString& about) {
  auto* column = new QVBoxLayout;
  column->setSpacing(px(4));
  column->addWidget(make_label(name, TextRole::body, Weight::bold));
  for (const auto& [text, ink] : {std::pair(formats, ""), std::pair(about, "text2")}) {
    QLabel* line = make_label(text, TextRole::body, Weight::regular, ink);
    line->setWordWrap(true);
    column->addWidget(line);
  }
  column->addStretch();
  row.addLayout(column, 1);
}

}  // namespace cusp::ui

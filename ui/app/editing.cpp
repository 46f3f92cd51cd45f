// The desktop's ways into editor, exercise files and imports, and from the editor to a try-out and back with everything as it was.

#include <QFileInfo>
#include <QPointer>
#include <utility>

#include "ui/admin/people_import.h"
#include "ui/app/desktop.h"
#include "ui/app/shell.h"
#include "ui/drill/drill_screen.h"
#include "ui/editor/editor_page.h"
#include "ui/instructor/import_page.h"
#include "ui/instructor/library_page.h"
#include "ui/modules.h"

namespace cusp::ui {

void Desktop::edit(const EditorStart& start) {
  auto* editor = new EditorPage(*store_, account_->actor(), ports_, start);
  connect(editor, &EditorPage::back_wanted, this, &Desktop::back);
  connect(editor, &EditorPage::try_out_wanted, this, &Desktop::try_out);
  connect(editor, &EditorPage::result_wanted, this, [this](const std::shared_ptr<const SessionResult>& result) { show_result(result, std::nullopt); });
  connect(editor, &EditorPage::copied, this, [this](const EditorStart& copy) {
    back();
    edit(copy);
  });
  push(editor);
}

void Desktop::open_waiting_file() {
  if (waiting_file_.isEmpty()) return;
  const QString what = tr("%1 is not open.").arg(QFileInfo(waiting_file_).fileName());
  if (!may(account_->role, Action::edit_scenarios)) {
    show_failure({what, tr("Instructors open exercise files. Sign out, and sign in as an instructor: the file then opens.")});
    return;
  }
  if (reading_only_) {
    show_failure({what, tr("The records can only be read now, so nothing can be added to the library.")});
    return;
  }
  shell_->show_page(u"library"_qs);
  const QString file = std::exchange(waiting_file_, {});
  if (auto* library = qobject_cast<LibraryPage*>(shell_->page())) library->open_file(file);
}

void Desktop::import_specimen() {
  auto* page = new ImportPage(ports_, database_);
  connect(page, &ImportPage::back_wanted, this, &Desktop::back);
  connect(page, &ImportPage::edit_wanted, this, [this](const EditorStart& start) {
    back();
    edit(start);
  });
  push(page);
}

void Desktop::import_people() {
  auto* page = new PeopleImport(*store_, account_->actor(), ports_);
  connect(page, &PeopleImport::back_wanted, this, [this] {
    back();
    if (shell_->page_key() != u"people"_qs) shell_->show_page(u"people"_qs);
  });
  push(page);
}

void Desktop::try_out(const SessionPlan& plan, const QString& title) {
  if (refuse_drilling()) return;
  const QPointer<EditorPage> editor = qobject_cast<EditorPage*>(page());
  DrillScreen* screen = open_drilling(plan, {title, tr("Try-out: nothing is kept")});
  connect(screen, &DrillScreen::finished, this, [this, editor](std::shared_ptr<const SessionResult> result) {
    if (editor) editor->model().now_tried({TriedBy::author, result->scenario, result->measures});
    back();
    show_result(std::move(result), std::nullopt);
  });
}

}  // namespace cusp::ui

#include "ui/text/gradebook_text.h"

#include "ui/text/text.h"

namespace cusp::ui {

QStringList gradebook_text(const GradebookFile& file) {
  QStringList out{Text::tr("%n result(s) exported.", nullptr, static_cast<int>(file.students))};
  if (file.failed > 0)
    out += Text::tr("%n of them failed by a critical event with enough points to pass: the gradebook sees the points alone.", nullptr,
                    static_cast<int>(file.failed));
  if (file.withheld > 0) out += Text::tr("%n result(s) wait for release.", nullptr, static_cast<int>(file.withheld));
  if (!file.ungraded.empty()) {
    QStringList numbers;
    for (const std::string& number : file.ungraded) numbers += text(number);
    out += Text::tr("%n student(s) have no graded attempt: %1.", nullptr, static_cast<int>(file.ungraded.size())).arg(numbers.join(u", "_qs));
  }
  return out;
}

}  // namespace cusp::ui

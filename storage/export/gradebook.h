/// Results of one assignment as a column for another system's gradebook. Student numbers identify the students there.
///
///   Moodle   ID number,TITLE               mapped to "ID number" and the grade item while importing
///   Canvas   Student,ID,SIS User ID,SIS Login ID,Section,TITLE, then a row "Points Possible"
///
/// TITLE is that of the assigned exercise, with or without results. Points are rounded to hundredths, never up to the pass mark.
/// Sources: Moodle's documentation, "Grade import"; Canvas's gradebook importer, which reads these headers.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "storage/export/csv.h"

namespace cusp::storage {

enum class Gradebook : std::uint8_t { moodle, canvas };

struct GradebookFile {
  std::string text;
  std::size_t students = 0;  // with a result in the file
  std::size_t withheld = 0;  // whose only results wait for their release, and are left out
  std::vector<std::string> ungraded{};  // numbers of students with attempts of which none has a grade; left out
  std::size_t failed = 0;    // of students: whose points reach the pass mark, though a critical event failed that attempt
};

/// The best released result of each student, whether it passed or failed: a gradebook takes points alone. Who has none has no line: an empty cell would clear a grade there. Nor has who
/// was erased: the gradebook would not know the number. `language`: of the title. Needs export_results. log_gradebook() follows
/// once the text is written.
Stored<GradebookFile> make_gradebook(StorageContext& context, const Actor& actor, AssignmentId assignment, Gradebook system,
                                     const std::string& language = "en");
/// The entry in the audit log, before the file has its name. Needs export_results, as the records have it now. None if the records are
/// open for reading alone.
Stored<void> log_gradebook(StorageContext& context, const Actor& actor, AssignmentId assignment, const GradebookFile& file);

}  // namespace cusp::storage

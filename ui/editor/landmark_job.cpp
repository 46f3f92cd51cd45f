#include "ui/editor/landmark_job.h"

#include <utility>

#include "scenarios/specimens/specimens.h"

namespace cusp::ui {

void LandmarkJob::start(const SpecimenSource& source, const std::string& folder, int fdi) {
  job_.start(this, [source, folder, fdi](const PoolLink<LandmarkJob>& link) {
    const auto volume = make_specimen(source, folder);
    if (!volume) {
      link.post([failure = volume.error()](LandmarkJob& job) {
        job.job_.finish();
        Q_EMIT job.unreadable(failure);
      });
      return;
    }
    if (link.cancelled()) return;
    const auto found = propose_landmarks(*volume, fdi);
    link.post([found](LandmarkJob& job) {
      job.job_.finish();
      if (found) {
        Q_EMIT job.proposed(*found);
      } else {
        Q_EMIT job.failed(found.error().code);
      }
    });
  });
}

}  // namespace cusp::ui

#include "ui/view/tooth_ahead.h"

#include <utility>

#include "ui/view/low_priority.h"

namespace cusp::ui {

ToothAhead::ToothAhead(std::shared_ptr<ToothCache> teeth, ToothWish wish)
    : stop_(std::make_shared<std::atomic<bool>>(false)), task_([teeth = std::move(teeth), wish = std::move(wish), stop = stop_] {
        lower_own_priority();
        // A failure is shown by whoever starts the exercise.
        (void)teeth->tooth(wish, stop.get());
      }, BackgroundTask::Holds::nothing) {}

ToothAhead::~ToothAhead() { *stop_ = true; }

}  // namespace cusp::ui

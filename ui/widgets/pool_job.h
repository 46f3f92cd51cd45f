/// One job of an owner in Qt's pool: a flag that cancels it, and answers that reach the owner on the GUI thread. Thread: GUI, but for
/// PoolLink.
#pragma once

#include <QCoreApplication>
#include <QPointer>
#include <QThreadPool>
#include <atomic>
#include <memory>
#include <utility>

namespace cusp::ui {

template <class Owner>
class PoolJob;

/// What the work in the pool holds. The pool's thread.
template <class Owner>
class PoolLink {
 public:
  bool cancelled() const { return run_->load(); }
  /// Set once it is cancelled. Lives as long as the link.
  const std::atomic<bool>* cancel_flag() const { return run_.get(); }
  /// Calls answer(owner) on the GUI thread, unless the owner is gone or its job another one by then.
  template <class Answer>
  void post(Answer answer) const {
    QMetaObject::invokeMethod(
        qApp,
        [owner = owner_, job = job_, run = run_, answer = std::move(answer)] {
          if (owner && job->run_ == run) answer(*owner);
        },
        Qt::QueuedConnection);
  }

 private:
  friend class PoolJob<Owner>;
  QPointer<Owner> owner_;
  PoolJob<Owner>* job_ = nullptr;  // of the owner
  std::shared_ptr<std::atomic<bool>> run_;
};

/// A member of its owner.
template <class Owner>
class PoolJob {
 public:
  PoolJob() = default;
  ~PoolJob() { cancel(); }
  PoolJob(const PoolJob&) = delete;
  PoolJob& operator=(const PoolJob&) = delete;

  /// Cancels the running job first. The pool calls work(link).
  template <class Work>
  void start(Owner* owner, Work work) {
    cancel();
    run_ = std::make_shared<std::atomic<bool>>(false);
    PoolLink<Owner> link;
    link.owner_ = owner;
    link.job_ = this;
    link.run_ = run_;
    QThreadPool::globalInstance()->start([link = std::move(link), work = std::move(work)] { work(link); });
  }
  /// No more answers come.
  void cancel() {
    if (run_) run_->store(true);
    run_.reset();
  }
  /// The last answer calls it.
  void finish() { run_.reset(); }
  bool running() const { return run_ != nullptr; }

 private:
  friend class PoolLink<Owner>;
  std::shared_ptr<std::atomic<bool>> run_;
};

}  // namespace cusp::ui

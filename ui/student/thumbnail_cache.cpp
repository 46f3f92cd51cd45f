#include "ui/student/thumbnail_cache.h"

#include <QBuffer>
#include <QRunnable>
#include <QStringList>
#include <algorithm>

#include "scenarios/format/content_hash.h"
#include "ui/modules.h"
#include "ui/render/gl_context_egl.h"
#include "ui/render/opengl_allowed.h"
#include "ui/render/patch_feed.h"
#include "ui/render/patch_store.h"
#include "ui/render/target_look.h"
#include "ui/render/tooth_picture.h"
#include "ui/session/scene_builder.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/save_bytes.h"

namespace cusp::ui {
namespace {

// Drawn at twice the size and halved: smooth edges without multisampling.
constexpr QSize kCard(560, 460), kCover(1080, 1200);
constexpr double kCardVoxelMm = 0.2;     // five pixels of a card; grown in an eighth of the time of 0.1 mm
constexpr const char* kLook = "-look3";  // of files: rises when the drawing changes

Colour linear(const QColor& c) {
  return {static_cast<float>(c.redF()), static_cast<float>(c.greenF()), static_cast<float>(c.blueF()), 1.0f};
}

/// The target with the crown about it.
Camera about_target(const TargetShape& shape) {
  constexpr double kAroundMm = 2.6, kLeastMm = 4.6;
  const Vec3 centre(0.5 * (shape.low() + shape.high()), shape.top_mm() - 0.8);
  return Camera::about(centre, std::max(0.5 * glm::length(shape.high() - shape.low()) + kAroundMm, kLeastMm));
}

/// Null if `stop` was set.
QImage draw(const Scenario& scenario, const std::filesystem::path& folder, ThumbnailCache::Use use,
            const Tokens& colours, const std::atomic<bool>& stop) {
  const auto specimen = build_specimen(scenario, folder, &stop);
  if (!specimen) return {};
  const Volume volume(*specimen);
  const QSize size = use == ThumbnailCache::Use::card ? kCard : kCover;
  const auto context = EglContext::create(2 * size.width(), 2 * size.height());
  if (!context) return {};
  const auto picture = ToothPicture::create();
  if (!picture) return {};
  const TargetLook look(scenario.target, scenario.leeway, *specimen);
  const bool card = use == ThumbnailCache::Use::card;
  PatchFeed feed(card ? look.feed() : FeedSettings{});
  if (stop) return {};
  feed.build_all(volume);
  PatchStore patches;
  for (BakedPatch& patch : feed.take(~std::size_t{0}).patches) {
    picture->put(patch);
    patches.put(std::move(patch));
  }
  const auto scenery = scenery_of(scenario.specimen, &stop);
  if (stop) return {};
  picture->set_scenery(scenery.get());
  const Box box = patches.bounds().value_or(Box{Vec3(-5.0), Vec3(5.0)});
  Scene3d scene;
  scene.camera = card && !look.empty() ? about_target(look.shape()) : Camera::about(0.5 * (box.low + box.high), 0.46 * glm::length(box.high - box.low));
  scene.camera.set_preset(PresetView::working);
  scene.background_middle = linear(colours.view_middle);
  scene.background_edge = linear(colours.view_edge);
  scene.show_target = card;
  scene.line_scale = 3.0f;
  if (card) picture->set_lines(look.lines(volume));
  picture->draw(scene, context->width(), context->height());
  const std::vector<std::uint8_t> rgba = context->read_rgba();
  const QImage twice(rgba.data(), context->width(), context->height(), context->width() * 4, QImage::Format_RGBX8888);
  return twice.scaled(size, Qt::IgnoreAspectRatio, Qt::SmoothTransformation).convertToFormat(QImage::Format_RGB32);
}

QString name_of(const Exercise& exercise, ThumbnailCache::Use use) {
  return QString::fromStdString(content_hash(exercise.scenario).hex()).left(32) + QLatin1String(kLook) +
         (use == ThumbnailCache::Use::card ? u"-card"_qs : u"-cover"_qs) + (tokens().dark ? u"-dark.png"_qs : u"-light.png"_qs);
}

QByteArray png_of(const QImage& image) {
  QByteArray png;
  QBuffer buffer(&png);
  buffer.open(QIODevice::WriteOnly);
  image.save(&buffer, "PNG");
  return png;
}

}  // namespace

ThumbnailCache::ThumbnailCache(std::filesystem::path cache, QObject* parent) : QObject(parent), cache_(std::move(cache)) {
  pool_.setMaxThreadCount(1);
  std::error_code ignored;
  std::filesystem::create_directories(cache_, ignored);
}

ThumbnailCache::~ThumbnailCache() {
  stop();
  pool_.waitForDone();
}

QString ThumbnailCache::file_of(const QString& name) const { return QString::fromStdString((cache_ / name.toStdString()).string()); }

void ThumbnailCache::stop() {
  *stopped_ = true;
  stopped_ = std::make_shared<std::atomic<bool>>(false);
  pool_.clear();
  asked_.clear();
}

QImage ThumbnailCache::kept(const Exercise& exercise, Use use) const {
  const QString name = name_of(exercise, use);
  const QImage drawn(file_of(name));
  return drawn.isNull() ? without_file_.value(name) : drawn;
}

QImage ThumbnailCache::picture(const Exercise& exercise, const std::filesystem::path& folder, Use use) {
  const QString name = name_of(exercise, use), file = file_of(name);
  QImage known = kept(exercise, use);
  if (!known.isNull() || asked_.contains(name) || !opengl_allowed()) return known;
  asked_.insert(name);
  pool_.start([this, scenario = exercise.scenario, folder, use, dark = tokens().dark, name, file, stopped = stopped_]() mutable {
    if (use == Use::card) scenario.specimen.voxel_mm = std::max(scenario.specimen.voxel_mm, kCardVoxelMm);
    const QImage drawn = draw(scenario, folder, use, dark ? Tokens::dark_theme() : Tokens::light(), *stopped);
    if (drawn.isNull()) return;
    const bool written = save_bytes(file, png_of(drawn)).has_value();
    QMetaObject::invokeMethod(this, [this, name, drawn, written] {
      if (!written) without_file_.insert(name, drawn);
      Q_EMIT ready();
    }, Qt::QueuedConnection);
  });
  return {};
}

}  // namespace cusp::ui

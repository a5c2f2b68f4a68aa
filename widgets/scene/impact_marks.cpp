#include "widgets/scene/impact_marks.h"

#include <QLineF>

#include "widgets/base/number_text.h"

namespace carom {
namespace {

constexpr double kReach = 7.0;  // px, from the contact point

}  // namespace

std::optional<ImpactRecord> impact_at(std::span<const ImpactRecord> marks, const Camera& camera,
                                      const QPointF& at) {
  std::optional<ImpactRecord> found;
  double least = kReach;
  for (const ImpactRecord& impact : marks) {
    const double distance = QLineF(camera.to_screen(impact.point), at).length();
    if (distance > least) continue;
    least = distance;
    found = impact;
  }
  return found;
}

QString impact_text(const std::vector<Body>& bodies, const ImpactRecord& impact) {
  const auto name = [&](int body) {
    return QString::fromStdString(bodies[static_cast<std::size_t>(body)].name).toHtmlEscaped();
  };
  QString text = QString("<b>%1 – %2</b> at %3 s")
                     .arg(name(impact.a), name(impact.b), QString::number(impact.time, 'f', 3));
  text += QString("<br>impulse %1 N·s").arg(figure(impact.normal_impulse));
  if (impact.tangential_impulse != 0.0)
    text += QString(", along the surface %1 N·s").arg(figure(impact.tangential_impulse));
  text += QString("<br>lost %1 J").arg(figure(lost_energy(impact)));
  return "<div style='white-space: nowrap'>" + text + "<br>a click goes to its moment</div>";
}

}  // namespace carom

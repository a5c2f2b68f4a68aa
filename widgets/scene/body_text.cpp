#include "widgets/scene/body_text.h"

#include <cmath>
#include <numbers>
#include <variant>

#include "widgets/base/number_text.h"
#include "widgets/scene/drawing_forces.h"
#include "widgets/scene/grid.h"

namespace carom {

QString body_text(const Frame& frame, int index) {
  const Body& body = (*frame.bodies)[static_cast<std::size_t>(index)];
  const Vec2 at = frame.state.position(index);
  const Vec2 v = frame.state.velocity(index);
  const auto number = [](double value) { return number_text(value, 4); };
  QString text = QString::fromStdString(body.name).toHtmlEscaped();
  text = "<b>" + text + "</b>" +
         (body.fixed   ? ", fixed"
          : body.drive ? ", driven"
                       : ", " + number(mass_of(body)) + " kg");
  text += QString("<br>position (%1, %2) m").arg(number(at.x()), number(at.y()));
  if (!body.fixed) {
    text += QString("<br>velocity (%1, %2) m/s").arg(number(v.x()), number(v.y()));
    text += QString("<br>spin %1 rad/s").arg(number(frame.state.v(2, index)));
  }
  int touching = 0;
  Vec2 force = Vec2::Zero();
  for (const ContactForce& contact : frame.contacts) {
    if (contact.a != index && contact.b != index) continue;
    ++touching;
    force += (contact.b == index ? 1.0 : -1.0) * force_on_b(contact);
  }
  if (touching > 0) {
    text += QString("<br>force of %1 contact%2 (%3, %4) N")
                .arg(touching)
                .arg(touching == 1 ? "" : "s")
                .arg(number(force.x()), number(force.y()));
  }
  return "<div style='white-space: nowrap'>" + text + "</div>";
}

QString kind_text(const Body& body) {
  const bool compound = std::holds_alternative<Compound>(body.shape);
  const QString shape = compound ? "several shapes" : kShapeWords[body.shape.index()];
  if (has_infinite_mass(body)) return shape + (body.fixed ? ", fixed" : ", driven");
  return QString("%1, %2 kg").arg(shape, short_figure(mass_of(body)));
}

QString spoken_text(const Frame& frame, int index) {
  const Body& body = (*frame.bodies)[static_cast<std::size_t>(index)];
  const Vec2 at = frame.state.position(index);
  const Vec2 v = frame.state.velocity(index);
  const double spin = frame.state.v(2, index);
  const auto number = [](double value) { return number_text(value, 4); };
  QString text = QString::fromStdString(body.name) + ", " + kind_text(body);
  text += QString(", x %1 m, y %2 m").arg(number(at.x()), number(at.y()));
  if (body.fixed) return text;
  const double degrees = std::atan2(v.y(), v.x()) * 180.0 / std::numbers::pi;
  text += v.isZero(0.0) ? QString(", at rest")
                        : QString(", %1 m/s at %2°").arg(number(v.norm()), number_text(degrees, 3));
  if (spin != 0.0) text += QString(", spin %1 rad/s").arg(number(spin));
  return text;
}

}  // namespace carom

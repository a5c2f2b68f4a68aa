#include "widgets/scene/body_text.h"

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

}  // namespace carom

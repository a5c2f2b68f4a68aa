#pragma once

#include <QPointF>
#include <QString>
#include <optional>
#include <span>
#include <vector>

#include "physics/ledger/impact_record.h"
#include "physics/scene/scene.h"
#include "widgets/scene/camera.h"

namespace carom {

// The impact whose mark is at a point of the screen: the closest one, of several at one place the newest.
[[nodiscard]] std::optional<ImpactRecord> impact_at(std::span<const ImpactRecord> marks, const Camera& camera,
                                                    const QPointF& at);

// What the tooltip of its mark says, as rich text: who, when, impulse and loss.
[[nodiscard]] QString impact_text(const std::vector<Body>& bodies, const ImpactRecord& impact);

}  // namespace carom

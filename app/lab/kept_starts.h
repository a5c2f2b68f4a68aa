#pragma once

#include <QByteArray>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "app/lab/document_change.h"
#include "physics/preset/preset.h"

namespace carom {

// A start of a session as a file holds it, beside the document.
struct KeptStart {
  StartOrigin origin;
  std::optional<Preset> preset{};              // that begins with it; none: the document does
  std::map<std::string, std::uint32_t> ids{};  // of the session, by the names of its bodies
  std::vector<OwnTheory> theories{};           // that the document knows; with the start that it begins with
};
// The first one, as opened or saved, stands first.
using KeptStarts = std::vector<KeptStart>;

[[nodiscard]] QByteArray written_starts(const KeptStarts& starts);
// Throws SceneError where the text is no such list.
[[nodiscard]] KeptStarts read_starts(const QByteArray& text);

// The ids of the bodies that a preset lists, or adds on its way.
[[nodiscard]] std::map<std::string, std::uint32_t> body_ids(const Preset& preset);
// As starts of the document with this preset. Bodies that had one id have one again: that of the document, or a
// new one, larger than `given`, which becomes the largest.
[[nodiscard]] std::vector<Start> starts_of(const KeptStarts& kept, const Preset& document,
                                           std::uint32_t& given);

}  // namespace carom

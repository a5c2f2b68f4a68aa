#include "app/lab/kept_starts.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <algorithm>
#include <map>
#include <string>
#include <utility>

#include "app/lab/new_parts.h"
#include "physics/preset/preset_file.h"
#include "physics/scene/validate.h"

namespace carom {
namespace {

constexpr const char* kPlace = "starts of the unsaved work";

QJsonObject written(const QuantityName& quantity) {
  QJsonArray bodies;
  for (const std::string& body : quantity.bodies) bodies.append(QString::fromStdString(body));
  return {{"observable", QString::fromStdString(quantity.observable)},
          {"bodies", bodies},
          {"theory", QString::fromStdString(quantity.theory)},
          {"residual", quantity.residual}};
}

QuantityName read_quantity(const QJsonObject& in) {
  QuantityName quantity{in["observable"].toString().toStdString(), {}};
  for (const QJsonValue& body : in["bodies"].toArray())
    quantity.bodies.push_back(body.toString().toStdString());
  quantity.theory = in["theory"].toString().toStdString();
  quantity.residual = in["residual"].toBool();
  return quantity;
}

QJsonObject written(const OwnTheory& each) {
  QJsonObject out{{"line", written(each.theory.line)}, {"scene", QString::number(each.scene)}};
  if (each.theory.x) out["x"] = written(*each.theory.x);
  return out;
}

OwnTheory read_theory(const QJsonObject& in) {
  OwnTheory each{{read_quantity(in["line"].toObject())}, in["scene"].toString().toULongLong()};
  if (in.contains("x")) each.theory.x = read_quantity(in["x"].toObject());
  return each;
}

QJsonObject written(const KeptStart& start) {
  const StartOrigin& origin = start.origin;
  QJsonObject out{{"by", origin.by}, {"saved", origin.saved}, {"scene", QString::number(origin.scene)}};
  if (origin.from) out["from"] = *origin.from;
  if (start.preset) out["preset"] = QString::fromStdString(write_preset(*start.preset));
  QJsonObject ids;
  for (const auto& [name, id] : start.ids) ids[QString::fromStdString(name)] = static_cast<qint64>(id);
  out["ids"] = ids;
  QJsonArray theories;
  for (const OwnTheory& each : start.theories) theories.append(written(each));
  if (!theories.empty()) out["theories"] = theories;
  return out;
}

KeptStart read(const QJsonObject& in) {
  KeptStart start{.origin = {.by = in["by"].toString(),
                             .saved = in["saved"].toBool(),
                             .scene = in["scene"].toString().toULongLong()}};
  if (in.contains("from")) start.origin.from = in["from"].toDouble();
  if (in.contains("preset")) start.preset = parse_preset(in["preset"].toString().toStdString(), kPlace);
  const QJsonObject ids = in["ids"].toObject();
  for (auto id = ids.begin(); id != ids.end(); ++id)
    start.ids[id.key().toStdString()] = static_cast<std::uint32_t>(id.value().toInteger());
  for (const QJsonValue& each : in["theories"].toArray())
    start.theories.push_back(read_theory(each.toObject()));
  return start;
}

// Calls each(body) with the listed bodies and those that come in later.
template <class P, class Each>
void each_body(P& preset, const Each& each) {
  for (auto& body : preset.scene.bodies) each(body);
  for (auto& late : preset.edits) {
    for (auto& edit : std::get<SceneEdits>(late.what)) {
      if (auto* add = std::get_if<Add<Body>>(&edit)) each(add->part);
    }
  }
}

}  // namespace

QByteArray written_starts(const KeptStarts& starts) {
  QJsonArray all;
  for (const KeptStart& each : starts) all.append(written(each));
  return QJsonDocument(all).toJson();
}

KeptStarts read_starts(const QByteArray& text) {
  const QJsonDocument json = QJsonDocument::fromJson(text);
  if (!json.isArray())
    throw SceneError(std::string(kPlace) + ": no list; allowed: what the program wrote there");
  KeptStarts starts;
  for (const QJsonValue& each : json.array()) starts.push_back(read(each.toObject()));
  return starts;
}

std::map<std::string, std::uint32_t> body_ids(const Preset& preset) {
  std::map<std::string, std::uint32_t> ids;
  each_body(preset, [&ids](const Body& body) { ids[body.name] = body.id.number; });
  return ids;
}

std::vector<Start> starts_of(const KeptStarts& kept, const Preset& document, std::uint32_t& given) {
  std::map<std::uint32_t, std::uint32_t> now;  // ids, by those of the session before
  const std::map<std::string, std::uint32_t> named = body_ids(document);
  for (const KeptStart& each : kept) {
    if (each.preset) continue;
    for (const auto& [name, before] : each.ids) {
      if (const auto same = named.find(name); same != named.end()) now[before] = same->second;
    }
  }
  std::vector<Start> starts;
  for (const KeptStart& each : kept) {
    Document there{each.preset.value_or(document)};
    there.start = each.origin;
    if (each.preset) {
      each_body(there.preset, [&](Body& body) {
        const auto before = each.ids.find(body.name);
        if (before == each.ids.end()) return;
        const auto same = now.find(before->second);
        if (same == now.end()) now[before->second] = ++given;
        body.id.number = now[before->second];
      });
      there.preset.scene.ids_given = given;
      give_ids(there.preset);
      given = there.preset.scene.ids_given;
    }
    starts.push_back(start_of(there));
  }
  return starts;
}

}  // namespace carom

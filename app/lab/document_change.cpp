#include "app/lab/document_change.h"

#include <QCoreApplication>
#include <algorithm>
#include <iterator>
#include <set>
#include <string>
#include <utility>

#include "app/lab/new_parts.h"
#include "physics/dynamics/integrators/integrators.h"
#include "physics/preset/start_fingerprint.h"
#include "physics/scene/edit_rules.h"
#include "physics/scene/facts.h"
#include "widgets/base/method_names.h"
#include "widgets/edit/inspected.h"
#include "widgets/plot/plot_content.h"

namespace carom {
namespace {

template <auto Member>
Set<Member> applied(Document& document, const Set<Member>& set) {
  return {std::exchange(document.preset.*Member, set.value)};
}

// Ids that were given stay given: edits that are taken back, and runs that were left, know parts by them.
SetScene applied(Document& document, const SetScene& set) {
  Scene& scene = document.preset.scene;
  const std::uint32_t given = std::max(scene.ids_given, set.value.ids_given);
  SetScene before{std::exchange(scene, set.value)};
  scene.ids_given = given;
  return before;
}

SceneEdits applied(Document& document, const SceneEdits& edits) {
  return apply_edits(document.preset.scene, edits);
}

SetMethods applied(Document& document, const SetMethods& set) {
  SetMethods before{document.methods(), std::exchange(document.before_usual, set.before_usual)};
  document.preset.method = set.methods.own;
  document.preset.compare = set.methods.others;
  document.reference = set.methods.reference;
  return before;
}

SetOrigin applied(Document& document, const SetOrigin& set) {
  return {std::exchange(document.start, set.origin)};
}

SetFirstTheories applied(Document& document, const SetFirstTheories& set) {
  return {std::exchange(document.first_theories, set.plots)};
}

SetOwnTheories applied(Document& document, const SetOwnTheories& set) {
  return {std::exchange(document.own_theories, set.theories)};
}

bool is_generated(Id<Body> id) { return id.number >= kFirstGenerated; }

bool is_of_generated_body(const SceneEdit& edit) {
  const auto* replace = std::get_if<Replace<Body>>(&edit);
  const auto* remove = std::get_if<Remove<Body>>(&edit);
  return (replace != nullptr && is_generated(replace->part.id)) ||
         (remove != nullptr && is_generated(remove->id));
}

// Makes bodies of the scene's generators listed ones.
void list_bodies(Scene& scene) {
  scene.bodies = all_bodies(scene);
  scene.generators.clear();
  for (Body& body : scene.bodies) {
    if (is_generated(body.id)) body.id = {};
  }
  give_ids(scene);
}

// The body that an id of a run means: `all` bodies stand in the order of the run.
const Body* meant(const std::vector<Body>& all, Id<Body> id) {
  const std::size_t place = id.number - kFirstGenerated;
  if (is_generated(id)) return place < all.size() ? &all[place] : nullptr;
  const auto found = std::find_if(all.begin(), all.end(), [id](const Body& b) { return b.id == id; });
  return found == all.end() ? nullptr : &*found;
}

// Gives edits of a run's bodies the ids of a start with these.
void take_ids(const std::vector<Body>& all, SceneEdits& edits) {
  for (SceneEdit& edit : edits) {
    if (auto* replace = std::get_if<Replace<Body>>(&edit)) {
      if (const Body* body = meant(all, replace->part.id)) replace->part.id = body->id;
    } else if (auto* remove = std::get_if<Remove<Body>>(&edit)) {
      if (const Body* body = meant(all, remove->id)) remove->id = body->id;
    }
  }
}

// Makes the edits of bodies that come in later where these are, and takes them out of the list.
std::vector<Renamed> edit_late_bodies(std::vector<RunEdit>& late, SceneEdits& edits) {
  std::vector<Renamed> renamed;
  std::erase_if(edits, [&](const SceneEdit& edit) {
    const auto* replace = std::get_if<Replace<Body>>(&edit);
    const auto* remove = std::get_if<Remove<Body>>(&edit);
    if (replace == nullptr && remove == nullptr) return false;
    const Id<Body> id = replace != nullptr ? replace->part.id : remove->id;
    const auto found =
        std::find_if(late.begin(), late.end(), [&](const RunEdit& each) { return added_body(each).id == id; });
    if (id.number == 0 || found == late.end()) return false;
    renamed.push_back({added_body(*found).name, replace != nullptr ? replace->part.name : std::string()});
    if (replace != nullptr) {
      found->what = SceneEdits{Add<Body>{replace->part}};
    } else {
      late.erase(found);
    }
    return true;
  });
  return renamed;
}

// False if the body is gone.
bool follow_name(std::string& body, const std::vector<Renamed>& renamed) {
  const auto now =
      std::find_if(renamed.begin(), renamed.end(), [&](const Renamed& r) { return r.from == body; });
  if (now == renamed.end()) return true;
  body = now->to;
  return !body.empty();
}

// False if the quantity is of a body that is gone.
bool follow_names(QuantityName& quantity, const std::vector<Renamed>& renamed) {
  return std::all_of(quantity.bodies.begin(), quantity.bodies.end(),
                     [&](std::string& body) { return follow_name(body, renamed); });
}

std::vector<Plot> with_names(std::vector<Plot> plots, const std::vector<Renamed>& renamed) {
  std::erase_if(plots, [&](Plot& plot) {
    const bool had_lines = !plot.y.empty();
    std::erase_if(plot.y, [&](QuantityName& line) { return !follow_names(line, renamed); });
    return (had_lines && plot.y.empty()) || (plot.x && !follow_names(*plot.x, renamed));
  });
  return plots;
}

// The theories of one's own that are known once the document gets another scene.
void keep_own_theories(const Document& document, const std::vector<Renamed>& renamed, DocumentChange& change) {
  if (document.is_experiment) return;
  std::vector<OwnTheory> known = with_theories_of(document.own_theories, document.preset);
  std::erase_if(known, [&renamed](OwnTheory& each) {
    return !follow_names(each.theory.line, renamed) ||
           (each.theory.x && !follow_names(*each.theory.x, renamed));
  });
  if (known != document.own_theories) change.emplace_back(SetOwnTheories{std::move(known)});
}

// Those about bodies that are gone go, too.
std::vector<Stop> with_names(std::vector<Stop> stops, const std::vector<Renamed>& renamed) {
  std::erase_if(
      stops, [&](Stop& stop) { return !follow_name(stop.body, renamed) || !follow_name(stop.with, renamed); });
  return stops;
}

// Takes the theories from the plots; those that had some are kept in `first`.
void take_theories(std::vector<Plot>& plots, std::vector<Plot>& first) {
  for (Plot& plot : plots) {
    const Plot before = std::exchange(plot, without_theories(plot));
    if (before != plot && std::find(first.begin(), first.end(), before) == first.end()) first.push_back(before);
  }
}

// Plots that are left of these once their theories went have them again.
std::vector<Plot> with_theories(std::vector<Plot> plots, const std::vector<Plot>& of_start) {
  for (Plot& plot : plots) {
    const auto same = std::find_if(of_start.begin(), of_start.end(),
                                   [&plot](const Plot& each) { return without_theories(each) == plot; });
    if (same != of_start.end()) plot = *same;
  }
  return plots;
}

// The plots, and what is known of theories, once the document gets another scene: an experiment keeps the
// theories of plots that have them `there`.
void leave_theories(const Document& document, const std::vector<Renamed>& renamed,
                    const std::vector<Plot>& there, DocumentChange& change) {
  std::vector<Plot> plots = with_names(document.preset.plots, renamed);
  std::vector<Plot> first = with_names(document.first_theories, renamed);
  if (document.is_experiment) take_theories(plots, first);
  plots = with_theories(std::move(plots), there);
  if (first != document.first_theories) change.emplace_back(SetFirstTheories{std::move(first)});
  keep_own_theories(document, renamed, change);
  if (plots != document.preset.plots) change.emplace_back(SetPlots{std::move(plots)});
}

Method possible(Method method, const Scene& scene) {
  if (why_not(scene, method.integrator)) method.integrator = IntegratorId::kRk4;
  return method;
}

// The methods that the scene allows, where that is not all of them.
void limit_methods(const Document& document, const Scene& after, DocumentChange& change) {
  Methods methods = document.methods();
  methods.own = possible(methods.own, after);
  for (Method& method : methods.others) method = possible(method, after);
  const RunSetup setup{after, methods.own};
  if (methods.reference != ReferenceId::kNone && why_not(setup, methods.reference))
    methods.reference = usual_reference(setup);
  if (methods.own != document.preset.method || methods.others != document.preset.compare ||
      methods.reference != document.reference)
    change.emplace_back(SetMethods{methods, document.before_usual});
}

// What the bodies of a document, with those that come in later, are called in another scene with these late
// bodies, by their ids; else by their names.
std::vector<Renamed> renamed_to(const Preset& preset, const Scene& scene, const std::vector<RunEdit>& late) {
  std::set<std::string> names;
  for (const Body& body : all_bodies(scene)) names.insert(body.name);
  for (const RunEdit& edit : late) names.insert(added_body(edit).name);
  const auto listed = [](Scene bodies, const std::vector<RunEdit>& edits) {
    for (const RunEdit& edit : edits) bodies.bodies.push_back(added_body(edit));
    return bodies;
  };
  std::vector<Renamed> renamed = renamed_bodies(listed(preset.scene, preset.edits), listed(scene, late));
  std::erase_if(renamed, [](const Renamed& each) { return each.to.empty(); });
  for (const Renamed& each : renamed) names.insert(each.from);
  for (const Body& body : all_bodies(preset)) {
    if (!names.contains(body.name)) renamed.push_back({body.name, {}});
  }
  return renamed;
}

// A change to a start with this scene, late bodies and clock, and then the edits.
struct Beginning {
  Scene scene;
  std::vector<RunEdit> late;
  std::optional<SavedRun> saved;
  bool other_scene;  // than the document's
};

DocumentChange change_to(const Document& document, Beginning start, SceneEdits edits) {
  const Preset& preset = document.preset;
  DocumentChange change;
  std::vector<Body> all = start.scene.bodies;
  for (const RunEdit& edit : start.late) all.push_back(added_body(edit));
  take_ids(all, edits);
  std::vector<Renamed> renamed = edit_late_bodies(start.late, edits);
  const bool other_late = start.other_scene || !renamed.empty();
  edits = with_followers(start.scene, edits);
  Scene after = start.scene;
  apply_edits(after, edits);
  const std::vector<Renamed> more = renamed_bodies(start.scene, after);
  renamed.insert(renamed.end(), more.begin(), more.end());

  if (start.other_scene) change.emplace_back(SetScene{std::move(start.scene)});
  change.emplace_back(std::move(edits));
  if (other_late) change.emplace_back(SetLateBodies{std::move(start.late)});
  if (start.saved.has_value() != preset.saved.has_value() || (preset.saved && preset.saved->fingerprint != 0))
    change.emplace_back(SetSaved{std::move(start.saved)});
  if (!preset.expect.empty()) change.emplace_back(SetExpectations{{}});
  leave_theories(document, renamed, {}, change);
  std::vector<Stop> stops = with_names(preset.stops, renamed);
  if (stops != preset.stops) change.emplace_back(SetStops{std::move(stops)});
  limit_methods(document, after, change);
  return change;
}

double changed(double was, double is, double start) { return is == was ? start : is; }

// Of the motion of a body what was edited. One that got another size moved along with a side of it.
void take_motion(const Body& was, const Body& is, Body& start) {
  const bool resized = bounding_radius(was.shape) != bounding_radius(is.shape);
  for (const int axis : {0, 1}) {
    start.position[axis] = resized ? start.position[axis] + is.position[axis] - was.position[axis]
                                   : changed(was.position[axis], is.position[axis], start.position[axis]);
    start.velocity[axis] = changed(was.velocity[axis], is.velocity[axis], start.velocity[axis]);
  }
  start.angle = changed(was.angle, is.angle, start.angle);
  start.spin = changed(was.spin, is.spin, start.spin);
}

}  // namespace

DocumentChange apply_change(Document& document, const DocumentChange& change) {
  DocumentChange back;
  for (const auto& part : change)
    back.emplace_back(
        std::visit([&](const auto& p) -> DocumentChange::value_type { return applied(document, p); }, part));
  std::reverse(back.begin(), back.end());
  return back;
}

FirstTheories first_theories_of(const Document& document) {
  return {document.first_theories, theories_of_others(document.own_theories, document.preset)};
}

DocumentChange change_of_methods(const Document& document, const Scene& scene) {
  DocumentChange change;
  limit_methods(document, scene, change);
  return change;
}

QString said_of_methods(const Document& document, const DocumentChange& change, const Scene& scene) {
  const Methods before = document.methods();
  for (const auto& [run, method] : methods_changed(document, change)) {
    const IntegratorId lost = (run == 0 ? before.own : before.others[run - 1]).integrator;
    const std::string with = what_prevents(scene, lost);
    if (lost == method.integrator || with.empty()) continue;
    return QCoreApplication::translate("DocumentChange", "%1 can't have %2: %3 instead.")
        .arg(text_of(choice_of(kIntegrators, lost).label), text_of(with),
             text_of(choice_of(kIntegrators, method.integrator).label));
  }
  return {};
}

std::vector<std::pair<std::size_t, Method>> methods_changed(const Document& document,
                                                            const DocumentChange& change) {
  std::vector<std::pair<std::size_t, Method>> methods;
  for (const auto& part : change) {
    const auto* set = std::get_if<SetMethods>(&part);
    if (set == nullptr) continue;
    if (set->methods.own != document.preset.method) methods.emplace_back(0, set->methods.own);
    for (std::size_t i = 0; i < set->methods.others.size(); ++i) {
      const Method& other = set->methods.others[i];
      if (other != document.preset.compare.at(i)) methods.emplace_back(i + 1, other);
    }
  }
  return methods;
}

DocumentChange change_of_start(const Document& document, const SceneEdits& edits) {
  const Preset& preset = document.preset;
  const bool lists =
      !preset.scene.generators.empty() && std::any_of(edits.begin(), edits.end(), is_of_generated_body);
  Beginning start{preset.scene, preset.edits, {}, lists};
  if (preset.saved) start.saved = SavedRun{.time = preset.saved->time};
  if (start.other_scene) list_bodies(start.scene);
  return change_to(document, std::move(start), edits);
}

DocumentChange change_to_moment(const Document& document, const Scene& now, double time,
                                const SceneEdits& edits) {
  const Preset& preset = document.preset;
  Beginning start{now, {}, {}, true};
  start.scene.ids_given = std::max(now.ids_given, preset.scene.ids_given);
  start.scene.forces.hand.reset();  // it belongs to the run
  list_bodies(start.scene);
  const SceneFacts facts = facts_of(now);
  const bool keeps_clock = facts.drives || facts.timed;
  if (keeps_clock) start.saved = SavedRun{.time = time};
  for (RunEdit edit : preset.edits) {
    if (edit.time <= time) continue;
    if (!keeps_clock) edit.time -= time;
    start.late.push_back(std::move(edit));
  }
  return change_to(document, std::move(start), edits);
}

DocumentChange change_of_late_bodies(const Document& document, std::vector<RunEdit> late) {
  DocumentChange change = {SetLateBodies{std::move(late)}};
  leave_theories(document, {}, {}, change);
  return change;
}

Start start_of(const Document& document) {
  const Preset& preset = document.preset;
  return {document.start, preset.scene, preset.edits, preset.saved, preset.expect, preset.plots};
}

Preset as_named_in(const Scene& scene, const std::vector<RunEdit>& left, Preset document) {
  const std::vector<Renamed> renamed = renamed_to(document, scene, left);
  document.plots = with_names(std::move(document.plots), renamed);
  document.stops = with_names(std::move(document.stops), renamed);
  document.edits = left;
  return document;
}

bool begin_alike(const Start& a, const Start& b) {
  return fingerprint_of_start(a.scene, a.saved, a.late) == fingerprint_of_start(b.scene, b.saved, b.late);
}

DocumentChange change_to_start(const Document& document, const Start& start) {
  const Preset& preset = document.preset;
  const std::vector<Renamed> renamed = renamed_to(preset, start.scene, start.late);
  DocumentChange change = {SetScene{start.scene}, SetLateBodies{start.late}, SetSaved{start.saved},
                           SetExpectations{start.expectations}, SetOrigin{start.origin}};
  leave_theories(document, renamed, start.plots, change);
  std::vector<Stop> stops = with_names(preset.stops, renamed);
  if (stops != preset.stops) change.emplace_back(SetStops{std::move(stops)});
  limit_methods(document, start.scene, change);
  return change;
}

std::vector<Plot> theories_left_at(const Start& start, const Document& document) {
  Document there = document;
  apply_change(there, change_to_start(there, start));
  apply_change(there, change_to_start(there, start_of(document)));
  return there.first_theories;
}

SceneEdits with_motion_of(const std::vector<Body>& bodies, const SceneEdits& edits) {
  SceneEdits kept = edits;
  for (SceneEdit& edit : kept) {
    auto* body = std::get_if<Replace<Body>>(&edit);
    if (body == nullptr) continue;
    const Body* was = meant(bodies, body->part.id);
    if (was == nullptr) continue;
    body->part.position = was->position;
    body->part.angle = was->angle;
    body->part.velocity = was->velocity;
    body->part.spin = was->spin;
    if (!has_infinite_mass(body->part)) continue;
    body->part.velocity.setZero();
    body->part.spin = 0.0;
  }
  return kept;
}

SceneEdits moved_to(const std::vector<Body>& now, const SceneEdits& edits, const Scene& moment) {
  SceneEdits there = with_motion_of(now, edits);
  for (std::size_t i = 0; i < edits.size(); ++i) {
    const auto* asked = std::get_if<Replace<Body>>(&edits[i]);
    const Body* was = asked == nullptr ? nullptr : part_of(moment.bodies, asked->part.id);
    if (was != nullptr) take_motion(*was, asked->part, std::get<Replace<Body>>(there[i]).part);
  }
  return there;
}

SceneEdits at_the_start(const Preset& preset, const SceneEdits& edits) {
  return with_known_parts(preset.scene, with_motion_of(all_bodies(preset), edits));
}

SceneEdits at_the_start(const Preset& preset, const SceneEdits& edits, const Scene& moment) {
  return with_known_parts(preset.scene, moved_to(all_bodies(preset), edits, moment));
}

std::shared_ptr<const Scene> scene_at_start(const Scene& start) {
  auto scene = std::make_shared<Scene>(start);
  scene->bodies = all_bodies(start);
  for (std::size_t i = 0; i < scene->bodies.size(); ++i) {
    Id<Body>& id = scene->bodies[i].id;
    if (id.number == 0) id.number = kFirstGenerated + static_cast<std::uint32_t>(i);
  }
  return scene;
}

ReferenceId first_reference(const Preset& preset) {
  constexpr std::ptrdiff_t kMostMoving = 200;  // beyond it the costly reference runs only on request
  const std::vector<Body> bodies = all_bodies(preset);
  const auto moving =
      std::count_if(bodies.begin(), bodies.end(), [](const Body& b) { return !has_infinite_mass(b); });
  return moving > kMostMoving ? ReferenceId::kNone : usual_reference(setup_of(preset));
}

}  // namespace carom

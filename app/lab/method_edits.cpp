#include "app/lab/method_edits.h"

#include <utility>

#include "physics/dynamics/integrators/integrators.h"
#include "widgets/base/method_names.h"
#include "widgets/base/number_text.h"

namespace carom {
namespace {

QString text_of_step(double step) { return MethodEdits::tr("Step %1 ms").arg(short_figure(1e3 * step)); }

// By what differs, the most important first.
QString text_of_change(const Method& from, const Method& to) {
  if (from.integrator != to.integrator)
    return MethodEdits::tr("Method: %1").arg(text_of(choice_of(kIntegrators, to.integrator).label));
  if (from.impacts != to.impacts)
    return MethodEdits::tr("Impacts: %1").arg(text_of(choice_of(kImpacts, to.impacts).label));
  if (from.contacts != to.contacts)
    return MethodEdits::tr("Contacts: %1").arg(text_of(choice_of(kContacts, to.contacts).label));
  if (from.step != to.step) return text_of_step(to.step);
  return MethodEdits::tr("Tolerance %1 m").arg(short_figure(to.tolerance));
}

Method& method_of(Methods& methods, std::size_t run) {
  return run == 0 ? methods.own : methods.others[run - 1];
}

}  // namespace

MethodEdits::MethodEdits(EditHistory& history) : history_(history), runs_(history.runs()) {}

void MethodEdits::go_on_under(const std::vector<std::pair<std::size_t, Method>>& changed, const Methods& after,
                              DocumentEdit::What what) {
  DocumentChange change = {set(after)};
  if (runs_.in_past()) change.emplace_back(SetLateBodies{history_.edits_left()});
  history_.cut_at_shown(what);
  what.runs = runs_.worker().set_methods(changed, what.runs);
  history_.push(what, change);
}

void MethodEdits::change(const Method& method, std::size_t run) {
  if (!is_run(run) || !history_.may_edit_moment()) return;
  Methods after = document().methods();
  const Method before = std::exchange(method_of(after, run), method);
  if (before == method) return;
  go_on_under({{run, method}}, after, {.text = text_of_change(before, method)});
}

void MethodEdits::change_step(double step, const std::vector<std::size_t>& runs, int drag) {
  Methods after = document().methods();
  std::vector<std::pair<std::size_t, Method>> changed;
  for (const std::size_t run : runs) {
    if (!is_run(run)) continue;
    Method& now = method_of(after, run);
    if (std::exchange(now.step, step) != step) changed.emplace_back(run, now);
  }
  if (changed.empty() || !history_.may_edit_moment()) return;
  const DocumentEdit* before = runs_.in_past() ? nullptr : history_.last_edit_of(drag);
  go_on_under(changed, after,
              {.text = text_of_step(step), .runs = before != nullptr ? before->what().runs : 0, .drag = drag});
}

void MethodEdits::add(const Method& method) {
  Methods after = document().methods();
  const bool full = after.others.size() == kMostCompared;
  if (full) after.others.pop_back();
  after.others.push_back(method);
  Worker& worker = runs_.worker();
  const Worker::EditId runs = full ? worker.set_method(method, kMostCompared) : worker.add_method(method);
  if (after.reference == ReferenceId::kNone) after.reference = first_reference(document().preset);
  history_.push({tr("Add method %1").arg(names_of({method}).front()), runs}, {set(after)});
}

void MethodEdits::remove(std::size_t run) {
  if (run == 0 || !is_run(run)) return;
  Methods after = document().methods();
  const QString name = names_of({method_of(after, run)}).front();
  after.others.erase(after.others.begin() + static_cast<std::ptrdiff_t>(run) - 1);
  history_.push({tr("Remove method %1").arg(name), runs_.worker().remove_method(run)}, {set(after)});
}

void MethodEdits::choose_reference(ReferenceId reference) {
  if (reference == document().reference) return;
  Methods after = document().methods();
  after.reference = reference;
  DocumentEdit::What what{.text = tr("Reference"), .is_work = false};  // not saved in files
  history_.push(what, {set(after)});
}

// The exact run becomes the scene's own run meanwhile: the others are compared with it, and a preset saved
// then stays valid.
void MethodEdits::compare_usual(const std::vector<Plot>& plots, const std::vector<Curve>& curves) {
  const Preset& preset = document().preset;
  SetMethods change = set(document().methods());
  if (change.before_usual) {
    change.methods = *std::exchange(change.before_usual, std::nullopt);
  } else {
    change.before_usual = change.methods;
    Method euler = preset.method;
    euler.integrator = IntegratorId::kExplicitEuler;
    Method rk4 = preset.method;
    rk4.integrator = IntegratorId::kRk4;
    const RunSetup setup = setup_of(preset);
    change.methods = {live_reference_method(setup, preset.method, usual_reference(setup)),
                      {euler, rk4},
                      first_reference(preset)};
  }
  const Worker::EditId runs = runs_.begin_with(change.methods, curves);
  history_.push({change.before_usual ? tr("Compare Euler, RK4 and exact") : tr("End of the comparison"), runs},
                {change, SetPlots{plots}});
}

}  // namespace carom

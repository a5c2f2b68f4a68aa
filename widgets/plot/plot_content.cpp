#include "widgets/plot/plot_content.h"

#include <QObject>
#include <QStringList>
#include <algorithm>
#include <utility>

#include "physics/observe/quantity_name.h"
#include "physics/preset/preset.h"
#include "physics/scene/validate.h"
#include "widgets/base/method_names.h"

namespace carom {
namespace {

// Sums that should be zero are rounding below this part of their terms.
constexpr Rounding kValues{1e-9, 1.0};
// A drift is shown down to rounding.
constexpr Rounding kDrift{1e-15, 1e-15};

PlotLine line(const char* label, const char* observable, const char* tip = "", bool sum = false) {
  const Observable* found = find_observable(observable);
  return {QString::fromUtf8(label), shown_unit(*found), QString::fromUtf8(tip),
          Curve{{found, {}}, std::nullopt}, sum};
}

PlotContent named(const char* id, const char* title, const char* unit, const char* tip, double Scales::*scale,
                  Rounding rounding, std::vector<PlotLine> lines) {
  Plot plot;
  plot.id = id;
  return {plot,
          QString::fromUtf8(title),
          {QString::fromUtf8(unit)},
          QString::fromUtf8(tip),
          {},
          {},
          std::move(lines),
          scale,
          rounding};
}

PlotContent distribution(const char* id, const char* title, const char* unit, const char* tip,
                         const char* x_title, const char* x_unit, PlotContent::Shows shows) {
  PlotContent content = named(id, title, unit, tip, nullptr, {0.0, 0.0}, {});
  content.x_title = QString::fromUtf8(x_title);
  content.x_unit.name = QString::fromUtf8(x_unit);
  content.shows = shows;
  return content;
}

PlotContent logarithmic(PlotContent content) {
  content.plot.logarithmic = true;
  return content;
}

// "A and B"
QString names_of(const QuantityName& quantity) {
  QStringList names;
  for (const std::string& name : quantity.bodies) names << QString::fromStdString(name);
  return names.join(" and ");
}

QString residual_mark(const QuantityName& quantity, bool of_first) {
  if (!quantity.residual) return {};
  return QString::fromUtf8(of_first ? " − theory of the first scene" : " − theory");
}

QString label_of(const QuantityName& quantity, bool of_first) {
  const QString label = text_of(find_observable(quantity.observable)->label);
  return (quantity.bodies.empty() ? label : QString("%1 of %2").arg(label, names_of(quantity))) +
         residual_mark(quantity, of_first);
}

bool is_drift(const Observable& o) {
  return o.name == "numerical_drift" || o.name == "momentum_drift_x" || o.name == "momentum_drift_y";
}

double Scales::*scale_of(const Observable& o) {
  if (o.unit == "J") return &Scales::energy;
  if (o.unit == "N s") return &Scales::momentum;
  return nullptr;
}

// The theories that the plot had, if it is left of one of these.
void take_first_theories(PlotContent& content, std::span<const Body> bodies, std::span<const Plot> first) {
  const Plot& plot = content.plot;
  const auto left_of = std::find_if(first.begin(), first.end(), [&plot](const Plot& each) {
    Plot left = without_theories(each);
    left.notes = plot.notes;
    return each.id.empty() && left == plot;
  });
  if (left_of == first.end()) return;
  Plot with_theories = *left_of;
  if (with_theories.y.size() > plot.y.size())
    std::erase_if(with_theories.y, [](const QuantityName& line) { return line.residual; });
  const PlotContent then = content_of(with_theories, bodies);
  for (std::size_t i = 0; i < content.lines.size(); ++i) {
    if (content.lines[i].theory.empty()) content.lines[i].first_theory = then.lines[i].theory;
  }
}

}  // namespace

std::span<const PlotContent> named_plots() {
  static const std::vector<PlotContent> table = {
      named("energy", "Energy", "J", "Energy of all freely moving bodies", &Scales::energy, kValues,
            {line("kinetic", "kinetic_energy"), line("potential", "potential_energy"),
             line("total", "total_energy", "", true)}),
      named("momentum", "Momentum", "kg m/s", "Momentum of all freely moving bodies", &Scales::momentum,
            kValues, {line("x", "momentum_x"), line("y", "momentum_y")}),
      named("impulse", "Contact impulses", "N·s", "The normal impulse of each impact", &Scales::impulse,
            kValues, {{"normal", {QString::fromUtf8("N·s")}, {}, std::nullopt, false}}),
      named("ledger", "Ledger", "J", "Where the energy went since the start", &Scales::energy, kValues,
            {line("restitution", "lost_in_impacts",
                  "lost in impacts to restitution below 1, and where bodies stick together"),
             line("friction", "lost_to_friction", "lost to friction, in impacts and at contacts that last"),
             line("drag", "lost_in_flight",
                  "lost to drag, to the dampers of springs, to rolling resistance and as strings become taut"),
             line("put in", "put_in",
                  "put in by driven bodies, applied forces and the user, and by separating overlaps")}),
      named("drift", "Energy drift", "J",
            "Energy that the method itself gained or lost: what no entry of the ledger explains",
            &Scales::energy, kDrift, {line("numerical", "numerical_drift")}),
      named("momentum_drift", "Momentum drift", "kg m/s",
            "Momentum that the method itself gained or lost: what neither forces, walls nor the user explain",
            &Scales::momentum, kDrift, {line("x", "momentum_drift_x"), line("y", "momentum_drift_y")}),
      logarithmic(named("error", "Distance from the reference", "m", "The largest over the moving bodies",
                        nullptr, kValues, {line("", "position_error")})),
      distribution("speeds", "Speeds", "s/m",
                   "How often each speed occurs among the freely moving bodies, beside Maxwell's law", "speed",
                   "m/s", PlotContent::Shows::kSpeeds),
      distribution("impulses", "Strengths of impacts", "impacts a bin",
                   "How many impacts of the time that is shown have each normal impulse", "normal impulse",
                   "N·s", PlotContent::Shows::kImpulses),
  };
  return table;
}

const std::vector<Plot>& default_plots() {
  static const std::vector<Plot> plots = [] {
    std::vector<Plot> all;
    for (const char* id : {"energy", "momentum", "impulse"}) all.emplace_back().id = id;
    return all;
  }();
  return plots;
}

QString label_of(const QuantityName& quantity) { return label_of(quantity, false); }

PlotContent content_of(const Plot& plot, std::span<const Body> bodies, const FirstTheories& first) {
  for (const PlotContent& known : named_plots()) {
    if (plot.id.empty() || known.plot.id != plot.id) continue;
    PlotContent content = known;
    content.plot.notes = plot.notes;
    return content;
  }
  PlotContent content;
  content.plot = plot;
  const auto is_of_first = [&](const QuantityName& line) {
    return std::find(first.kept.begin(), first.kept.end(), PlottedTheory{line, plot.x}) != first.kept.end();
  };
  std::optional<Quantity> x;
  if (plot.x) {
    x = quantity_of(*plot.x, bodies);
    content.x_title = label_of(*plot.x);
    content.x_unit = shown_unit(*x->observable);
  }
  for (const QuantityName& name : plot.y) {
    Quantity y = quantity_of(name, bodies);
    const bool of_first = is_of_first(name);
    PlotLine line{label_of(name, of_first), si_unit(*y.observable), {}, std::nullopt, false,
                  theory_of(name, x)};
    if (name.residual) {
      line.tip = QObject::tr("measured minus theory: %1").arg(QString::fromStdString(name.theory));
      y.less = std::exchange(line.theory, {});
    }
    if (of_first) line.first_theory = std::exchange(line.theory, {});
    line.curve = Curve{y, x};
    content.lines.push_back(std::move(line));
  }
  if (content.lines.empty()) throw SceneError("a plot without a quantity; allowed: at least one");
  const Observable& front = *content.lines.front().curve->y.observable;
  const auto every = [&](const auto& same) {
    return std::all_of(content.lines.begin(), content.lines.end(),
                       [&](const PlotLine& l) { return same(*l.curve->y.observable); });
  };
  if (every([&](const Observable& o) { return o.unit == front.unit; })) {
    content.unit = shown_unit(front);
    for (PlotLine& line : content.lines) line.unit = content.unit;
    content.scale = scale_of(front);
    const bool drifts = std::all_of(content.lines.begin(), content.lines.end(), [](const PlotLine& l) {
      return is_drift(*l.curve->y.observable) || !l.curve->y.less.empty();
    });
    content.rounding = drifts ? kDrift : kValues;
  }
  // The part that all lines share is in the title instead.
  const bool one_body = plot.x && plot.x->bodies == plot.y.front().bodies && plot.y.size() == 1;
  if (content.lines.size() == 1) {
    content.title = one_body ? text_of(front.label) + residual_mark(plot.y.front(), is_of_first(plot.y.front()))
                             : content.lines.front().label;
    content.lines.front().label.clear();
  } else if (every([&](const Observable& o) { return &o == &front; })) {
    content.title = text_of(front.label);
    for (std::size_t i = 0; i < content.lines.size(); ++i) {
      const QString names = names_of(plot.y[i]);
      content.lines[i].label =
          (names.isEmpty() ? content.title : names) + residual_mark(plot.y[i], is_of_first(plot.y[i]));
    }
  } else {
    content.title = QStringLiteral("Plot");
  }
  if (plot.logarithmic) content.title = "|" + content.title + "|";
  if (plot.x) content.title = QString("%1 over %2").arg(content.title, content.x_title);
  if (!plot.title.empty()) content.title = QString::fromStdString(plot.title);
  // A capital first letter, except for the x of a coordinate.
  if (content.title.size() > 1 && content.title[1] != ' ') content.title[0] = content.title[0].toUpper();
  take_first_theories(content, bodies, first.taken);
  return content;
}

Plot without_theories(Plot plot) {
  const auto is_residual = [](const QuantityName& line) { return line.residual; };
  if (std::all_of(plot.y.begin(), plot.y.end(), is_residual)) return plot;
  std::erase_if(plot.y, is_residual);
  for (QuantityName& line : plot.y) line.theory.clear();
  return plot;
}

}  // namespace carom

#include "physics/study/study_table.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>

#include "physics/dynamics/integrators/integrators.h"
#include "physics/files/csv.h"
#include "physics/scene/method.h"

namespace carom {
namespace {

// A number as in its field; empty if there is none.
std::string field(double value) { return std::isfinite(value) ? csv_number(value) : std::string(); }
std::string field(std::int64_t value) { return fmt::format("{}", value); }
std::string field(int value) { return fmt::format("{}", value); }
std::string field(const std::string& text) { return csv_text(text); }

struct Column {
  const char* name;
  std::string (*write)(const StudyFacts&, const StudyRow&, const StudyGroup&);
};

template <auto Member>
constexpr Column row_column(const char* name) {
  return {name, [](const StudyFacts&, const StudyRow& r, const StudyGroup&) { return field(r.*Member); }};
}
template <auto Member>
constexpr Column facts_column(const char* name) {
  return {name, [](const StudyFacts& f, const StudyRow&, const StudyGroup&) { return field(f.*Member); }};
}
template <auto Member, const auto& kTable>
constexpr Column choice_column(const char* name) {
  return {name, [](const StudyFacts&, const StudyRow& r, const StudyGroup&) {
            return std::string(choice_of(kTable, r.method.*Member).name);
          }};
}
// A column of numbers from a fit.
template <auto Fit, auto Member>
constexpr Column fit_column(const char* name) {
  return {name, [](const StudyFacts&, const StudyRow&, const StudyGroup& g) {
            return (g.*Fit).kind == OrderFit::Kind::kOrder ? field(g.*Fit.*Member) : std::string();
          }};
}
template <auto Fit>
constexpr Column order_column(const char* name) {
  return {name, [](const StudyFacts&, const StudyRow&, const StudyGroup& g) {
            const OrderFit& fit = g.*Fit;
            if (&fit == &g.fit && g.is_of_angle()) return std::string("exact but for angles");
            return fit.kind == OrderFit::Kind::kOrder ? field(fit.order) : text_of(fit);
          }};
}

constexpr auto kColumns = std::to_array<Column>({
    choice_column<&Method::integrator, kIntegrators>("integrator"),
    choice_column<&Method::impacts, kImpacts>("impacts"),
    choice_column<&Method::contacts, kContacts>("contacts"),
    {"step [s] or tolerance [m]",
     [](const StudyFacts&, const StudyRow& r, const StudyGroup&) {
       const auto value = r.step_or_tolerance();
       return value ? field(*value) : std::string();
     }},
    row_column<&StudyRow::position_error>("position error [m]"),
    row_column<&StudyRow::velocity_error>("velocity error [m/s]"),
    row_column<&StudyRow::energy_error>("energy error [J]"),
    row_column<&StudyRow::impact_time_error>("impact-time error [s]"),
    row_column<&StudyRow::wall_time>("wall time [s]"),
    row_column<&StudyRow::evaluations>("evaluations [1]"),
    row_column<&StudyRow::impacts>("number of impacts [1]"),
    order_column<&StudyGroup::fit>("fitted order [1]"),
    fit_column<&StudyGroup::fit, &OrderFit::uncertainty>("standard error of the order [1]"),
    fit_column<&StudyGroup::fit, &OrderFit::from>("fitted from step [s]"),
    fit_column<&StudyGroup::fit, &OrderFit::to>("fitted to step [s]"),
    fit_column<&StudyGroup::fit, &OrderFit::points>("fitted points [1]"),
    row_column<&StudyRow::angle_error>("angle error [m]"),
    row_column<&StudyRow::spin_error>("spin error [m/s]"),
    order_column<&StudyGroup::angle_fit>("fitted order of the angle [1]"),
    fit_column<&StudyGroup::angle_fit, &OrderFit::uncertainty>("standard error of the order of the angle [1]"),
    row_column<&StudyRow::wall_least>("least wall time [s]"),
    row_column<&StudyRow::wall_most>("largest wall time [s]"),
    facts_column<&StudyFacts::repeats>("repeats [1]"),
    row_column<&StudyRow::steps>("steps [1]"),
    row_column<&StudyRow::rejected_steps>("rejected steps [1]"),
    row_column<&StudyRow::matched>("matched impacts [1]"),
    row_column<&StudyRow::unmatched>("unmatched impacts [1]"),
    row_column<&StudyRow::left_out>("bodies left out [1]"),
    row_column<&StudyRow::status>("status"),
    facts_column<&StudyFacts::time>("compared time [s]"),
    facts_column<&StudyFacts::duration>("duration [s]"),
    facts_column<&StudyFacts::reference>("reference"),
    facts_column<&StudyFacts::reference_position_error>("reference position error [m]"),
    facts_column<&StudyFacts::reference_velocity_error>("reference velocity error [m/s]"),
    facts_column<&StudyFacts::reference_angle_error>("reference angle error [m]"),
    facts_column<&StudyFacts::reference_spin_error>("reference spin error [m/s]"),
    facts_column<&StudyFacts::reference_energy_error>("reference energy error [J]"),
    facts_column<&StudyFacts::stated>("figures of the file"),
    facts_column<&StudyFacts::length>("length [m]"),
    facts_column<&StudyFacts::arc>("longest arc [m]"),
    facts_column<&StudyFacts::growth>("growth [1]"),
    facts_column<&StudyFacts::exponent>("Lyapunov exponent [1/s]"),
    facts_column<&StudyFacts::horizon>("horizon [s]"),
    facts_column<&StudyFacts::remarks>("remarks"),
    facts_column<&StudyFacts::preset>("preset"),
    facts_column<&StudyFacts::title>("title"),
});

bool same_method(const Method& x, const Method& y) {
  return x.integrator == y.integrator && x.impacts == y.impacts && x.contacts == y.contacts;
}

auto group_of(auto& groups, const StudyRow& row) {
  return std::find_if(groups.begin(), groups.end(),
                      [&](const StudyGroup& g) { return same_method(g.rows.front().method, row.method); });
}

// The order of an error; `floor` is rounding, and the reference's own error is a floor too (all in m).
OrderFit fit_of(const StudyGroup& g, double StudyRow::*value, double floor, double of_reference,
                double largest) {
  std::vector<ErrorAtStep> errors;
  for (const StudyRow& row : g.rows) {
    // A run whose impacts differ from the reference's is another motion: its error is no part of an order.
    const double error = row.unmatched == 0 ? row.*value : std::fmax(row.*value, largest);
    errors.push_back({row.step_or_tolerance().value_or(row.method.step), error});
  }
  const double fitted = std::max(floor, 0.1 * of_reference);
  OrderFit fit = fit_order(errors, floor, largest);
  if (fit.kind == OrderFit::Kind::kExact || !(fitted > floor)) return fit;
  fit = fit_order(errors, fitted, largest);
  return fit.kind == OrderFit::Kind::kExact ? OrderFit{} : fit;
}

}  // namespace

ErrorParameter error_parameter(const Method& method) {
  const IntegratorChoice& integrator = choice_of(kIntegrators, method.integrator);
  if (method.contacts == ContactsId::kLasting) return ErrorParameter::kStep;
  if (integrator.adaptive) return ErrorParameter::kTolerance;
  return integrator.order == 0 ? ErrorParameter::kNone : ErrorParameter::kStep;
}

std::optional<double> StudyRow::step_or_tolerance() const {
  switch (error_parameter(method)) {
    case ErrorParameter::kStep:
      return method.step;
    case ErrorParameter::kTolerance:
      return method.tolerance;
    case ErrorParameter::kNone:
      break;
  }
  return std::nullopt;
}

double StudyFacts::rounding_floor() const { return std::numeric_limits<double>::epsilon() * length * growth; }
double StudyFacts::angle_floor() const { return std::numeric_limits<double>::epsilon() * arc * growth; }

std::vector<StudyGroup> groups_of(const StudyTable& table) {
  std::vector<StudyGroup> groups;
  for (const StudyRow& row : table.rows) {
    const auto mine = group_of(groups, row);
    if (mine != groups.end()) {
      mine->rows.push_back(row);
    } else {
      groups.push_back({row.method.integrator, row.method.impacts, row.method.contacts, {row}, {}, {}});
    }
  }
  const StudyFacts& f = table.facts;
  for (StudyGroup& g : groups) {
    g.fit =
        fit_of(g, &StudyRow::position_error, f.rounding_floor(), f.reference_position_error, f.largest_error());
    g.angle_fit =
        fit_of(g, &StudyRow::angle_error, f.angle_floor(), f.reference_angle_error, f.largest_angle_error());
  }
  return groups;
}

std::vector<std::string> study_csv(const StudyTable& table) {
  std::vector<std::string> lines;
  CsvLine header;
  for (const Column& column : kColumns) header.add(column.name);
  lines.push_back(header.text());
  const std::vector<StudyGroup> groups = groups_of(table);
  for (const StudyRow& row : table.rows) {
    const StudyGroup& group = *group_of(groups, row);
    CsvLine line;
    for (const Column& column : kColumns) line.add_field(column.write(table.facts, row, group));
    lines.push_back(line.text());
  }
  return lines;
}

}  // namespace carom

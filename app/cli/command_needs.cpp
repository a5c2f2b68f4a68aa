#include <array>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/cli/commands.h"
#include "app/cli/options.h"
#include "app/cli/standard_output.h"
#include "app/cli/text_table.h"
#include "physics/check/part_costs.h"
#include "physics/model/needs.h"
#include "physics/preset/preset.h"
#include "physics/scene/plain_text.h"

namespace carom {
namespace {

struct NeedsOptions {
  std::string preset;
  MethodOptions method;
  bool json = false;
};

std::string micro_seconds(double seconds) { return fmt::format("{:.3g} µs", 1e6 * seconds); }

// Cost of the part in a step of this run; empty if the model does not have it.
std::string cost_of(const PartCost& cost, const Method& method) {
  if (!cost.needed) return "0";
  if (cost.entry->part == Part::kRestingContacts && method.contacts == ContactsId::kImpulse)
    return "0 (not asked for)";
  return cost.without ? micro_seconds(cost.with - *cost.without) : "";
}

std::string_view why(const PartCost& cost) { return cost.needed ? cost.entry->why : cost.entry->why_not; }

void print_json(const Preset& preset, const std::vector<PartCost>& costs) {
  nlohmann::ordered_json parts = nlohmann::ordered_json::array();
  for (const PartCost& cost : costs) {
    nlohmann::ordered_json part;
    part["part"] = cost.entry->key;
    part["needed"] = cost.needed;
    part["why"] = why(cost);
    part["brings"] = cost.entry->brings;
    part["step_with_s"] = cost.with;
    if (cost.without) part["step_without_s"] = *cost.without;
    parts.push_back(std::move(part));
  }
  print_out("{}\n", nlohmann::ordered_json{{"preset", preset.title}, {"parts", parts}}.dump(2));
}

int show_needs(const NeedsOptions& options) {
  const Preset preset = preset_with_method(options.preset, options.method);
  const RunSetup setup = setup_of(preset);
  const std::vector<PartCost> costs = part_costs(setup, start_time(setup.saved) + preset.duration);
  if (options.json) {
    print_json(preset, costs);
    return kGood;
  }
  const NeedsText text = text_of(needs_of(preset.scene), preset.scene, preset.method.contacts);
  print_out("{}\nmodelled: {}\nnot needed: {}\n\n", printable(preset.title), fmt::join(text.modelled, ", "),
            fmt::join(text.not_needed, ", "));
  std::vector<std::vector<std::string>> rows = {
      {"part", "needed", "a step with it", "without", "its cost a step", "because"}};
  for (const PartCost& cost : costs) {
    rows.push_back({std::string(cost.entry->noun), cost.needed ? "yes" : "no", micro_seconds(cost.with),
                    cost.without ? micro_seconds(*cost.without) : "-", cost_of(cost, preset.method),
                    std::string(why(cost))});
  }
  print_table(
      rows, std::array{Align::kLeft, Align::kLeft, Align::kRight, Align::kRight, Align::kRight, Align::kLeft});
  print_out(
      "\nCPU time, medians. A part that is not needed: a step with the part put into the model, and without "
      "it.\n"
      "A part that is needed: a step of this run, and of the run without what needs it; \"-\" if there is "
      "none.\n");
  return kGood;
}

}  // namespace

Command add_needs_command(CLI::App& program, Arguments /*arguments*/) {
  const auto options = std::make_shared<NeedsOptions>();
  CLI::App& command =
      *program.add_subcommand("needs", "which parts of the model an experiment needs, and what each costs");
  add_preset_option(command, options->preset)->required();
  add_method_options(command, options->method);
  command.add_flag("--json", options->json, "print one JSON object instead of a table");
  return {&command, [options] { return show_needs(*options); }};
}

}  // namespace carom

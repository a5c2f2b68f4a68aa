#include <array>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/cli/commands.h"
#include "app/cli/options.h"
#include "app/cli/standard_output.h"
#include "app/cli/text_table.h"
#include "app/library/preset_library.h"
#include "physics/model/needs.h"
#include "physics/preset/preset.h"
#include "physics/preset/preset_file.h"
#include "physics/scene/plain_text.h"

namespace carom {
namespace {

struct NeedsOptions {
  std::string preset;
  bool json = false;
};

void print_json(const Preset& preset, const Needs& needs) {
  nlohmann::ordered_json parts = nlohmann::ordered_json::array();
  for (const PartEntry& entry : part_entries()) {
    const bool needed = needs.has(entry.part);
    nlohmann::ordered_json part;
    part["part"] = entry.key;
    part["needed"] = needed;
    part["why"] = needed ? entry.why : entry.why_not;
    part["brings"] = entry.brings;
    parts.push_back(std::move(part));
  }
  print_out("{}\n", nlohmann::ordered_json{{"preset", preset.title}, {"parts", parts}}.dump(2));
}

int show_needs(const NeedsOptions& options) {
  const Preset preset = read_preset(find_preset(options.preset));
  const Needs needs = needs_of(preset.scene);
  if (options.json) {
    print_json(preset, needs);
    return kGood;
  }
  const NeedsText text = text_of(needs, preset.scene, preset.method.contacts);
  print_out("{}\nmodelled: {}\nnot needed: {}\n\n", printable(preset.title), fmt::join(text.modelled, ", "),
            fmt::join(text.not_needed, ", "));
  std::vector<std::vector<std::string>> rows = {{"part", "needed", "because"}};
  for (const PartEntry& entry : part_entries()) {
    const bool needed = needs.has(entry.part);
    rows.push_back(
        {std::string(entry.noun), needed ? "yes" : "no", std::string(needed ? entry.why : entry.why_not)});
  }
  print_table(rows, std::array{Align::kLeft, Align::kLeft, Align::kLeft});
  return kGood;
}

}  // namespace

Command add_needs_command(CLI::App& program, Arguments /*arguments*/) {
  const auto options = std::make_shared<NeedsOptions>();
  CLI::App& command = *program.add_subcommand("needs", "which parts of the model an experiment needs, and why");
  add_preset_option(command, options->preset)->required();
  command.add_flag("--json", options->json, "print one JSON object instead of a table");
  return {&command, [options] { return show_needs(*options); }};
}

}  // namespace carom

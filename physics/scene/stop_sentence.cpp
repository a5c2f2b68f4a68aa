#include <algorithm>
#include <array>
#include <charconv>
#include <fmt/format.h>
#include <optional>

#include "physics/scene/plain_text.h"
#include "physics/scene/range_check.h"
#include "physics/scene/stop.h"

namespace carom {
namespace {

constexpr std::string_view kOf = " of ";
constexpr std::string_view kWith = " with ";
constexpr std::string_view kWall = "a wall";
constexpr std::string_view kPasses = " passes ";
constexpr const char* kAllowed =
    "\"at 2.5 s\", \"at the 3rd impact\", \"at every impact\" (both also \"of A\", \"with B\", \"with a "
    "wall\"), "
    "\"when A passes x = 0.4 m\" (or y = 0.4 m, angle = 1 rad, speed = 2 m/s; also \"upwards\", "
    "\"downwards\"), "
    "\"when all is at rest\", \"when K falls below 1 J\"";

struct QuantityUnit {
  StopQuantity id;
  std::string_view unit;
};
constexpr auto kUnits = std::to_array<QuantityUnit>({
    {StopQuantity::kX, "m"},
    {StopQuantity::kY, "m"},
    {StopQuantity::kAngle, "rad"},
    {StopQuantity::kSpeed, "m/s"},
});

// Quoted where the words of a sentence could be taken for a part of it.
std::string told(const std::string& name) {
  const auto has = [&name](std::string_view word) { return name.find(word) != std::string::npos; };
  const bool plain = !name.empty() && name.front() != ' ' && name.back() != ' ' && name != kWall &&
                     !has("\"") && !has(kWith) && !has(kPasses);
  if (plain) return name;
  std::string quoted = "\"";
  for (const char c : name) quoted += c == '"' ? "\"\"" : std::string(1, c);
  return quoted + "\"";
}

std::string ordinal(int number) {
  constexpr auto kEndings = std::to_array<const char*>({"th", "st", "nd", "rd"});
  const int last = number % 10;
  const bool teen = number / 10 % 10 == 1;
  return fmt::format("{}{}", number, teen || last > 3 ? "th" : kEndings[static_cast<std::size_t>(last)]);
}

// Reads a sentence from its beginning on. What doesn't fit leaves `fits` false.
struct SentenceReader {
  std::string_view rest;
  bool fits = true;

  [[nodiscard]] bool has(std::string_view words) {
    if (!rest.starts_with(words)) return false;
    rest.remove_prefix(words.size());
    return true;
  }
  void needs(std::string_view words) { fits = has(words) && fits; }
  void ends() { fits = fits && rest.empty(); }
  template <class Number>
  void reads(Number& number) {
    const char* const begin = rest.data();
    const auto [end, error] = std::from_chars(begin, begin + rest.size(), number);
    fits = fits && error == std::errc();
    rest.remove_prefix(static_cast<std::size_t>(end - begin));
  }
  // A name, up to the word after it or to the end.
  void reads_name(std::string& name, std::string_view word) {
    if (rest.starts_with('"')) return reads_quoted(name);
    const std::size_t length = std::min(rest.find(word), rest.size());
    name = rest.substr(0, length);
    fits = fits && length > 0;
    rest.remove_prefix(length);
  }
  void reads_quoted(std::string& name) {
    rest.remove_prefix(1);
    name.clear();
    while (!rest.empty() && (rest.front() != '"' || rest.starts_with("\"\""))) {
      rest.remove_prefix(rest.front() == '"' ? 1 : 0);
      name += rest.front();
      rest.remove_prefix(1);
    }
    needs("\"");
  }
};

std::string partners(const Stop& stop) {
  std::string text;
  if (!stop.body.empty()) text += fmt::format("{}{}", kOf, told(stop.body));
  if (stop.with_wall) return fmt::format("{}{}{}", text, kWith, kWall);
  if (!stop.with.empty()) text += fmt::format("{}{}", kWith, told(stop.with));
  return text;
}

void read_partners(SentenceReader& reader, Stop& stop) {
  if (reader.has(kOf)) reader.reads_name(stop.body, kWith);
  if (!reader.has(kWith)) return;
  stop.with_wall = reader.rest == kWall;
  if (stop.with_wall) {
    reader.needs(kWall);
  } else {
    reader.reads_name(stop.with, kWith);
  }
}

void read_passing(SentenceReader& reader, Stop& stop) {
  reader.reads_name(stop.body, kPasses);
  reader.needs(kPasses);
  const auto named =
      std::find_if(kStopQuantityNames.begin(), kStopQuantityNames.end(),
                   [&reader](const auto& row) { return reader.has(fmt::format("{} = ", row.name)); });
  if (named == kStopQuantityNames.end()) {
    reader.fits = false;
    return;
  }
  stop.quantity = named->id;
  reader.reads(stop.value);
  reader.needs(fmt::format(" {}", kUnits[index_of(kUnits, stop.quantity)].unit));
  for (const auto& [id, name] : kPassingWayNames) {
    if (id != PassingWay::kEither && reader.has(fmt::format(" {}", name))) stop.way = id;
  }
}

std::string tell_passing(const Stop& stop) {
  const std::string way =
      stop.way == PassingWay::kEither ? "" : fmt::format(" {}", name_of(kPassingWayNames, stop.way));
  return fmt::format("when {}{}{} = {} {}{}", told(stop.body), kPasses,
                     name_of(kStopQuantityNames, stop.quantity), stop.value,
                     kUnits[index_of(kUnits, stop.quantity)].unit, way);
}

// How each kind is told: its sentence, and what follows its first words.
struct Sentence {
  StopKind id;
  std::string_view begins;
  std::string (*tell)(const Stop& stop);
  void (*read)(SentenceReader& reader, Stop& stop);
};

constexpr auto kSentences = std::to_array<Sentence>({
    {StopKind::kRest, "when all is at rest", [](const Stop&) { return std::string("when all is at rest"); },
     [](SentenceReader&, Stop&) {}},
    {StopKind::kKineticEnergy, "when K falls below ",
     [](const Stop& stop) { return fmt::format("when K falls below {} J", stop.below); },
     [](SentenceReader& reader, Stop& stop) {
       reader.reads(stop.below);
       reader.needs(" J");
     }},
    {StopKind::kPassing, "when ", tell_passing, read_passing},
    {StopKind::kEveryImpact, "at every impact",
     [](const Stop& stop) { return "at every impact" + partners(stop); }, read_partners},
    {StopKind::kImpact, "at the ",
     [](const Stop& stop) { return fmt::format("at the {} impact{}", ordinal(stop.number), partners(stop)); },
     [](SentenceReader& reader, Stop& stop) {
       reader.reads(stop.number);
       reader.fits =
           (reader.has("st") || reader.has("nd") || reader.has("rd") || reader.has("th")) && reader.fits;
       reader.needs(" impact");
       read_partners(reader, stop);
     }},
    {StopKind::kTime, "at ", [](const Stop& stop) { return fmt::format("at {} s", stop.time); },
     [](SentenceReader& reader, Stop& stop) {
       reader.reads(stop.time);
       reader.needs(" s");
     }},
});

std::optional<Stop> read_as(const Sentence& sentence, std::string_view text) {
  Stop stop;
  stop.kind = sentence.id;
  SentenceReader reader{text};
  reader.needs(sentence.begins);
  if (reader.fits) sentence.read(reader, stop);
  reader.ends();
  return reader.fits ? std::optional(stop) : std::nullopt;
}

}  // namespace

std::string sentence_of(const Stop& stop) { return kSentences[index_of(kSentences, stop.kind)].tell(stop); }

Stop stop_of(const std::string& place, std::string_view sentence) {
  for (const Sentence& each : kSentences) {
    if (const auto stop = read_as(each, sentence)) {
      check_fields(place, *stop);
      return *stop;
    }
  }
  throw SceneError(fmt::format("{}: \"{}\" is not allowed; allowed: {}", place, shortened(sentence), kAllowed));
}

}  // namespace carom

#include <filesystem>
#include <gtest/gtest.h>
#include <string>
#include <vector>

#include "physics/preset/preset_file.h"
#include "tests/support/preset_files.h"
#include "tests/support/source_folder.h"

namespace carom {
namespace {

namespace fs = std::filesystem;
using test::content;
using test::PresetFiles;

struct Bad {
  std::string what;
  std::string text;
  std::string place;  // must stand in the message
};

std::string repeated(const std::string& part, std::size_t bytes) {
  std::string text;
  text.reserve(bytes + part.size());
  while (text.size() < bytes) text += part;
  return text;
}

std::vector<Bad> bad_presets() {
  const std::string head = R"({"format": "carom-preset", "version": 1, "title": "t")";
  const auto with = [&](const std::string& more) { return head + ", " + more + "}"; };
  const auto body = [&](const std::string& more) {
    return with(R"("bodies": [{"name": "a", "shape": {"type": "disc", "radius": 0.1}, "position": [0, 0])" +
                more + "}]");
  };
  const auto forces = [&](const std::string& list) {
    return with(R"("bodies": [{"name": "a", "shape": {"type": "disc", "radius": 1}, "position": [0, 0]},
        {"name": "b", "shape": {"type": "disc", "radius": 1}, "position": [9, 0]},
        {"name": "w", "shape": {"type": "disc", "radius": 1}, "position": [0, 9], "fixed": true}],
        "forces": [)" +
                list + "]");
  };
  const auto joints = [&](const std::string& list) {
    return with(R"("bodies": [{"name": "a", "shape": {"type": "disc", "radius": 1}, "position": [0, 0]},
        {"name": "b", "shape": {"type": "disc", "radius": 1}, "position": [9, 0], "velocity": [1, 1]},
        {"name": "w", "shape": {"type": "disc", "radius": 1}, "position": [0, 9], "fixed": true}],
        "links": [)" +
                list + "]");
  };
  const auto expect = [&](const std::string& more) {
    return with(R"("expect": [{"observable": "time", "value": 0, "tolerance": 0, )" + more + "}]");
  };
  const std::string disc = R"({"name": "a", "shape": {"type": "disc", "radius": 0.1}, "position": [0, 0]})";
  const std::string other = R"({"name": "b", "shape": {"type": "disc", "radius": 0.1}, "position": [1, 0]})";
  return {
      {"empty", "", "line 1"},
      {"not JSON", "hello\nworld", "line 1"},
      {"truncated", head + R"(, "bodies": [{"na)", "line 1"},
      {"an array", "[]", "/"},
      {"null", "null", "/"},
      {"no format", R"({"version": 1, "title": "t"})", "format"},
      {"another format", R"({"format": "x", "version": 1, "title": "t"})", "/format"},
      {"newer version", R"({"format": "carom-preset", "version": 2, "title": "t"})", "newer"},
      {"version 0", R"({"format": "carom-preset", "version": 0, "title": "t"})", "/version"},
      {"version 1.5", R"({"format": "carom-preset", "version": 1.5, "title": "t"})", "/version"},
      {"huge version", R"({"format": "carom-preset", "version": 18446744073709551615, "title": "t"})", "newer"},
      {"unknown key", with(R"("gravitation": [0, 0])"), "/gravitation"},
      {"unknown key inside", body(R"(, "colour": "red")"), "/bodies/0/colour"},
      {"duplicate key", with(R"("title": "u")"), "/title"},
      {"duplicate key inside", body(R"(, "mass": 1, "mass": 2)"), "/bodies/0/mass"},
      {"negative mass", body(R"(, "mass": -1)"), "/bodies/0/mass"},
      {"mass 0", body(R"(, "mass": 0)"), "/bodies/0/mass"},
      {"NaN", body(R"(, "mass": NaN)"), "line 1"},
      {"1e999", body(R"(, "mass": 1e999)"), "too large"},
      {"-1e999", body(R"(, "spin": -1e999)"), "too large"},
      {"1e300", body(R"(, "spin": 1e300)"), "/bodies/0/spin"},
      {"text for a number", body(R"(, "mass": "1")"), "/bodies/0/mass"},
      {"number for a text", body(R"(, "material": 1)"), "/bodies/0/material"},
      {"three coordinates", body(R"(, "velocity": [1, 2, 3])"), "/bodies/0/velocity"},
      {"mass and density", body(R"(, "mass": 1, "density": 1)"), "/bodies/0/density"},
      {"unknown material", body(R"(, "material": "cheese")"), "/bodies/0/material"},
      {"one name twice",
       with(R"("bodies": [{"name": "a", "shape": {"type": "disc", "radius": 1}, "position": [0, 0]},
            {"name": "a", "shape": {"type": "disc", "radius": 1}, "position": [9, 0]}])"),
       "/bodies/1/name"},
      {"a moving half-plane",
       with(R"("bodies": [{"name": "a", "shape": {"type": "wall"}, "position": [0, 0]}])"), "/bodies/0/fixed"},
      {"a moving thin wall without a mass",
       with(R"("bodies": [{"name": "a", "shape": {"type": "wall", "length": 1}, "position": [0, 0]}])"),
       "/bodies/0/mass"},
      {"a point without a mass",
       with(R"("bodies": [{"name": "a", "shape": {"type": "disc", "radius": 0}, "position": [0, 0]}])"),
       "/bodies/0/mass"},
      {"a rounded polygon with a dent",
       with(
           R"("bodies": [{"name": "a", "shape": {"type": "polygon", "vertices": [[0, 0], [2, 0], [1, 0.1], [0, 2]],
            "rounding": 0.1}, "position": [0, 0]}])"),
       "/bodies/0/shape/vertices"},
      {"a polygon that crosses itself",
       with(
           R"("bodies": [{"name": "a", "shape": {"type": "polygon", "vertices": [[0, 0], [2, 2], [2, 0], [0, 2]]},
            "position": [0, 0]}])"),
       "/bodies/0/shape/vertices"},
      {"a shape beside shapes",
       with(R"("bodies": [{"name": "a", "shape": {"type": "disc", "radius": 1}, "position": [0, 0],
            "shapes": [{"shape": {"type": "disc", "radius": 1}}]}])"),
       "/bodies/0/shape"},
      {"no shapes", with(R"("bodies": [{"name": "a", "shapes": [], "position": [0, 0]}])"), "/bodies/0/shapes"},
      {"a half-plane among shapes",
       with(R"("bodies": [{"name": "a", "shapes": [{"shape": {"type": "wall"}}], "position": [0, 0]}])"),
       "/bodies/0/shapes/0/shape/length"},
      {"a dent in one of the shapes",
       with(R"("bodies": [{"name": "a", "shapes": [{"shape": {"type": "polygon", "rounding": 0.1,
            "vertices": [[0, 0], [2, 0], [1, 0.1], [0, 2]]}}], "position": [0, 0]}])"),
       "/bodies/0/shapes/0/shape/vertices"},
      {"a surface of a shape that is not there",
       with(R"("bodies": [{"name": "a", "shapes": [{"shape": {"type": "disc", "radius": 1}, "material": "m"}],
            "position": [0, 0]}])"),
       "/bodies/0/shapes/0/material"},
      {"shapes of no area without a mass",
       with(
           R"("bodies": [{"name": "a", "shapes": [{"shape": {"type": "wall", "length": 1}}], "position": [0, 0]}])"),
       "/bodies/0/mass"},
      {"a polygon of numbers",
       with(
           R"("bodies": [{"name": "a", "shape": {"type": "polygon", "vertices": [1, 2, 3]}, "position": [0, 0]}])"),
       "/bodies/0/shape/vertices/0"},
      {"an unrounded polygon of two points",
       with(R"("bodies": [{"name": "a", "shape": {"type": "polygon", "vertices": [[0, 0], [1, 0]]},
            "position": [0, 0]}])"),
       "/bodies/0/shape/vertices"},
      {"an inertia of zero", body(R"(, "inertia": 0)"), "/bodies/0/inertia"},
      {"an inertia beside a drive", body(R"(, "drive": {"velocity": [1, 0]}, "inertia": 1)"),
       "/bodies/0/inertia"},
      {"a pair of one material", with(R"("material_pairs": [{"materials": ["default"]}])"),
       "/material_pairs/0/materials"},
      {"a pair of an unknown material", with(R"("material_pairs": [{"materials": ["default", "ice"]}])"),
       "/material_pairs/0/materials/1"},
      {"a pair that is named twice",
       with(
           R"("material_pairs": [{"materials": ["default", "default"]}, {"materials": ["default", "default"]}])"),
       "/material_pairs/1/materials"},
      {"a moving fixed body", body(R"(, "fixed": true, "velocity": [1, 0])"), "/bodies/0/velocity"},
      {"no radius", with(R"("bodies": [{"name": "a", "shape": {"type": "disc"}, "position": [0, 0]}])"),
       "/bodies/0/shape"},
      {"unknown shape", with(R"("bodies": [{"name": "a", "shape": {"type": "star"}, "position": [0, 0]}])"),
       "/bodies/0/shape/type"},
      {"spring of nobody",
       with(R"("forces": [{"type": "spring", "body": "b", "anchor": [0, 0], "stiffness": 1}])"), "\"b\""},
      {"an added body without a time", with(R"("added": [{"body": )" + disc + "}]"), "/added/0"},
      {"an added body before the start", with(R"("added": [{"time": -1, "body": )" + disc + "}]"),
       "/added/0/time"},
      {"added bodies out of order",
       with(R"("added": [{"time": 1, "body": )" + disc + R"(}, {"time": 0.5, "body": )" + other + "}]"),
       "/added/1/time"},
      {"an added body with a name that is taken",
       body(R"(}], "added": [{"time": 1, "body": )" + disc + R"(}], "materials": [{"name": "m")"),
       "/added/0/body/name"},
      {"an added body of an unknown material",
       with(R"("added": [{"time": 1, "body": )" + disc.substr(0, disc.size() - 1) +
            R"(, "material": "ice"}}])"),
       "/added/0/body/material"},
      {"an added body with an unknown key",
       with(R"("added": [{"time": 1, "body": )" + disc.substr(0, disc.size() - 1) + R"(, "colour": 1}}])"),
       "/added/0/body"},
      {"a spring of an added body",
       with(R"("added": [{"time": 1, "body": )" + disc +
            R"(}], "forces": [{"type": "spring", "body": "a", "anchor": [0, 0], "stiffness": 1}])"),
       "/forces/0/body"},
      {"unknown force", with(R"("forces": [{"type": "magic"}])"), "/forces/0/type"},
      {"unknown link", joints(R"({"type": "glue", "body": "a", "anchor": [0, 1]})"), "/links/0/type"},
      {"link without a type", joints(R"({"body": "a", "anchor": [0, 1]})"), "\"rod\", \"string\", \"pin\""},
      {"link of nobody", joints(R"({"type": "rod", "body": "c", "anchor": [0, 1]})"), "/links/0/body"},
      {"link to nobody", joints(R"({"type": "rod", "body": "a", "to": "c"})"), "/links/0/to"},
      {"link of a fixed body", joints(R"({"type": "rod", "body": "w", "anchor": [0, 1]})"), "/links/0/body"},
      {"link to itself", joints(R"({"type": "rod", "body": "a", "to": "a"})"), "/links/0/to"},
      {"link without an end", joints(R"({"type": "rod", "body": "a"})"), "anchor"},
      {"two links of one name", joints(R"({"type": "rod", "name": "r", "body": "a", "anchor": [0, 1]},
            {"type": "rod", "name": "r", "body": "a", "anchor": [1, 0]})"),
       "/links/1/name"},
      {"rod of no length", joints(R"({"type": "rod", "body": "a", "anchor": [0, 0]})"), "/links/0"},
      {"rod of another length", joints(R"({"type": "rod", "body": "a", "anchor": [0, 1], "length": 1.1})"),
       "/links/0/length"},
      {"string too short", joints(R"({"type": "string", "body": "a", "anchor": [0, 1], "length": 0.9})"),
       "/links/0/length"},
      {"length 0", joints(R"({"type": "string", "body": "a", "anchor": [0, 1], "length": 0})"),
       "/links/0/length"},
      {"pin with a length", joints(R"({"type": "pin", "body": "a", "anchor": [0, 0], "length": 1})"),
       "/links/0/length"},
      {"pin off its place", joints(R"({"type": "pin", "body": "a", "anchor": [0, 1]})"), "1 m apart"},
      {"pin that is left", joints(R"({"type": "pin", "body": "b", "anchor": [9, 0]})"), "part at 1.41"},
      {"pin with an angle", joints(R"({"type": "pin", "body": "a", "anchor": [0, 0], "angle": 1})"),
       "/links/0/angle"},
      {"weld with a length", joints(R"({"type": "weld", "body": "a", "anchor": [0, 0], "length": 1})"),
       "/links/0/length: unknown key"},
      {"weld off its place", joints(R"({"type": "weld", "body": "a", "anchor": [0, 1]})"),
       "a weld whose ends are 1 m"},
      {"weld of another angle", joints(R"({"type": "weld", "body": "a", "anchor": [0, 0], "angle": 0.1})"),
       "/links/0/angle: 0.1 of bodies that are turned by"},
      {"weld of no angle", joints(R"({"type": "weld", "body": "a", "anchor": [0, 0], "angle": 1e13})"),
       "/links/0/angle"},
      {"weld that is left", joints(R"({"type": "weld", "body": "b", "anchor": [9, 0]})"),
       "a weld whose ends part"},
      {"weld to nothing", joints(R"({"type": "weld", "body": "a"})"), "anchor"},
      {"weld that is turned", with(R"("bodies": [{"name": "a", "shape": {"type": "disc", "radius": 1},
                                                "position": [0, 1], "spin": 2}],
            "links": [{"type": "weld", "body": "a", "anchor": [0, 1]}])"),
       "turn against each other at 2 rad/s"},
      {"simultaneous impacts that stick",
       with(R"("several_impacts": "simultaneous", "materials": [{"name": "clay", "sticks": true}])"),
       "/several_impacts: \"simultaneous\" with surfaces that stick"},
      {"exact flight of clay",
       with(R"("method": {"integrator": "exact-flight"}, "materials": [{"name": "clay", "sticks": true}])"),
       "surfaces that stick"},
      {"sticks in words", with(R"("materials": [{"name": "clay", "sticks": "yes"}])"), "/materials/0/sticks"},
      {"rod that grows", joints(R"({"type": "rod", "body": "b", "to": "a"})"), "part at 1 m/s"},
      {"link far away", joints(R"({"type": "rod", "body": "a", "anchor": [0, 1e13]})"), "/links/0/anchor/1"},
      {"exact flight of a link", with(R"("method": {"integrator": "exact-flight"}, "bodies": [{"name": "a",
            "shape": {"type": "disc", "radius": 1}, "position": [0, 0]}],
            "links": [{"type": "rod", "body": "a", "anchor": [0, 1]}])"),
       "/method/integrator"},
      {"restitution 2", with(R"("materials": [{"name": "m", "restitution": 2}])"), "/materials/0/restitution"},
      {"static below kinetic",
       with(R"("materials": [{"name": "m", "kinetic_friction": 0.5, "static_friction": 0.2}])"),
       "/materials/0/static_friction"},
      {"step 0", with(R"("method": {"step": 0})"), "/method/step"},
      {"unknown integrator", with(R"("method": {"integrator": "rk5"})"), "/method/integrator"},
      {"step 0 of another method", with(R"("compare": [{}, {"step": 0}])"), "/compare/1/step"},
      {"an unknown other method", with(R"("compare": [{"impacts": "late"}])"), "/compare/0/impacts"},
      {"exact flight of what sticks, beside it",
       with(R"("materials": [{"name": "clay", "sticks": true}], "compare": [{"integrator": "exact-flight"}])"),
       "/compare/0/integrator"},
      {"too many methods", with(R"("compare": [{}, {}, {}, {}, {}, {}])"), "up to 5"},
      {"an error that is expected",
       with(
           R"("expect": [{"observable": "position_error", "reduction": "final", "value": 0, "tolerance": 1}])"),
       "in plots only"},
      {"duration 0", with(R"("duration": 0)"), "/duration"},
      {"unknown plot", with(R"("plots": ["heat"])"), "/plots/0"},
      {"a plot that is a number", with(R"("plots": [3])"), "/plots/0"},
      {"a plot of nothing", with(R"("plots": [{"y": []}])"), "/plots/0/y"},
      {"a plot without y", with(R"("plots": [{"x": {"observable": "time"}}])"), "\"y\" is missing"},
      {"a plot of an unknown observable", with(R"("plots": [{"y": [{"observable": "luck"}]}])"),
       "/plots/0/y/0/observable"},
      {"a plot of too few bodies",
       with(R"("plots": [{"y": [{"observable": "time"}], "x": {"observable": "x"}}])"), "/plots/0/x/bodies"},
      {"a note without a text", with(R"("plots": [{"plot": "energy", "notes": [{"at": [1, 2], "text": ""}]}])"),
       "/plots/0/notes/0/text"},
      {"a note nowhere", with(R"("plots": [{"plot": "energy", "notes": [{"text": "a"}]}])"),
       "/plots/0/notes/0: \"at\" is missing"},
      {"an unknown plot with notes", with(R"("plots": [{"plot": "heat", "notes": []}])"), "/plots/0/plot"},
      {"a named plot of something", with(R"("plots": [{"plot": "energy", "y": [{"observable": "time"}]}])"),
       "/plots/0/y: unknown key"},
      {"a theory of an unknown name", with(R"("plots": [{"y": [{"observable": "time", "theory": "2*z"}]}])"),
       "/plots/0/y/0/theory: \"2*z\" at character 3: \"z\" is not known; allowed: an expression of t, pi, abs"},
      {"a theory in x over time", with(R"("plots": [{"y": [{"observable": "time", "theory": "x"}]}])"),
       "/plots/0/y/0/theory"},
      {"a theory that is a number", with(R"("plots": [{"y": [{"observable": "time", "theory": 2}]}])"),
       "/plots/0/y/0/theory"},
      {"a residual of nothing", with(R"("plots": [{"y": [{"observable": "time", "residual": true}]}])"),
       "/plots/0/y/0/residual"},
      {"a theory of what is below", with(R"("plots": [{"y": [{"observable": "time"}],
       "x": {"observable": "time", "theory": "t"}}])"),
       "/plots/0/x/theory"},
      {"a plot of an unknown body", with(R"("plots": [{"y": [{"observable": "x", "bodies": ["z"]}]}])"),
       "/plots/0/y/0/bodies/0"},
      {"unknown observable",
       with(R"("expect": [{"observable": "luck", "reduction": "final", "value": 1, "tolerance": 0}])"),
       "/expect/0/observable"},
      {"too few bodies",
       with(R"("expect": [{"observable": "x", "reduction": "final", "value": 1, "tolerance": 0}])"),
       "/expect/0/bodies"},
      {"unknown body",
       with(
           R"("expect": [{"observable": "x", "bodies": ["z"], "reduction": "final", "value": 1, "tolerance": 0}])"),
       "/expect/0/bodies/0"},
      {"a billion bodies", with(R"("generators": [{"type": "grid", "columns": 100000, "rows": 10000}])"),
       "/generators/0"},
      {"generator repeats a name",
       with(R"("generators": [{"type": "grid", "name": "g"}, {"type": "grid", "name": "g"}])"), "/generators"},
      {"seed -1",
       with(
           R"("generators": [{"type": "grid", "name": "g", "origin": [0, 0], "spacing": [1, 1], "radius": [0.1, 0.1], "seed": -1}])"),
       "/generators/0/seed"},
      {"drive of a fixed body", body(R"(, "fixed": true, "drive": {"velocity": [1, 0]})"), "/bodies/0/fixed"},
      {"drive and velocity", body(R"(, "velocity": [1, 0], "drive": {})"), "/bodies/0/velocity"},
      {"drive and spin", body(R"(, "spin": 1, "drive": {})"), "/bodies/0/spin"},
      {"drive and mass", body(R"(, "mass": 1, "drive": {})"), "/bodies/0/mass"},
      {"drive and density", body(R"(, "density": 1, "drive": {})"), "/bodies/0/density"},
      {"drive backwards", body(R"(, "drive": {"angular_frequency": -1})"), "/bodies/0/drive/angular_frequency"},
      {"drive with an unknown key", body(R"(, "drive": {"speed": 1})"), "/bodies/0/drive/speed"},
      {"two linear drags", forces(R"({"type": "linear_drag", "coefficient": 1},
           {"type": "linear_drag", "coefficient": 1})"),
       "/forces/1"},
      {"linear drag below 0", forces(R"({"type": "linear_drag", "coefficient": -1})"), "/forces/0/coefficient"},
      {"spring without other end", forces(R"({"type": "spring", "body": "a", "stiffness": 1})"),
       "/forces/0/anchor"},
      {"spring at no point",
       forces(R"({"type": "spring", "body": "a", "stiffness": 1, "point": [0, "x"], "anchor": [0, 0]})"),
       "/forces/0/point/1"},
      {"spring to itself", forces(R"({"type": "spring", "body": "a", "stiffness": 1, "to": "a"})"),
       "/forces/0/to"},
      {"spring to nobody", forces(R"({"type": "spring", "body": "a", "stiffness": 1, "to": "z"})"),
       "/forces/0/to"},
      {"spring to no name", forces(R"({"type": "spring", "body": "a", "stiffness": 1, "to": ""})"),
       "/forces/0/to"},
      {"spring of a fixed body", forces(R"({"type": "spring", "body": "w", "stiffness": 1, "to": "a"})"),
       "/forces/0/body"},
      {"second of two springs", forces(R"({"type": "spring", "body": "a", "stiffness": 1, "to": "b"},
              {"type": "quadratic_drag", "coefficient": 1},
              {"type": "spring", "body": "a", "stiffness": 0, "to": "b"})"),
       "/forces/2/stiffness"},
      {"one spring name twice",
       forces(R"({"type": "spring", "name": "s", "body": "a", "stiffness": 1, "to": "b"},
              {"type": "spring", "name": "s", "body": "b", "stiffness": 1, "to": "a"})"),
       "/forces/1/name"},
      {"damping below 0",
       forces(R"({"type": "spring", "body": "a", "stiffness": 1, "to": "b", "damping": -1})"),
       "/forces/0/damping"},
      {"unknown way to act",
       forces(R"({"type": "spring", "body": "a", "stiffness": 1, "to": "b", "acts": "never"})"),
       "/forces/0/acts"},
      {"two attractions",
       forces(R"({"type": "attraction", "constant": 1}, {"type": "attraction", "constant": 1})"), "/forces/1"},
      {"attraction 0", forces(R"({"type": "attraction", "constant": 0})"), "/forces/0/constant"},
      {"force on nobody", forces(R"({"type": "force", "body": "z"})"), "/forces/0/body"},
      {"force on a wall", forces(R"({"type": "force", "body": "w", "force": [1, 0]})"), "/forces/0/body"},
      {"force that ends before it starts", forces(R"({"type": "force", "body": "a", "start": 2, "end": 1})"),
       "/forces/0/end"},
      {"tolerance 1", with(R"("method": {"tolerance": 1})"), "/method/tolerance"},
      {"unknown reduction", expect(R"("reduction": "sum")"), "/expect/0/reduction"},
      {"count without a bound", expect(R"("reduction": "count")"), "\"above\" is missing"},
      {"until before from", expect(R"("reduction": "mean", "from": 2, "until": 1)"), "/expect/0/until"},
      {"from where nothing is looked over", expect(R"("reduction": "final", "from": 2)"), "/expect/0/from"},
      {"setting of nothing", expect(R"("reduction": "final", "with": {"/bodies/7/mass": 1})"),
       "/bodies/7/mass"},
      {"setting of a text", expect(R"("reduction": "final", "with": {"/title": 1})"), "\"/title\""},
      {"setting without a slash", expect(R"("reduction": "final", "with": {"gravity": 1})"), "\"gravity\""},
      {"setting that is a text", expect(R"("reduction": "final", "with": {"/duration": "1"})"),
       "/expect/0/with /duration"},
      {"sweep of nothing",
       expect(R"("reduction": "final", "over": {"place": "/x", "values": [1], "reduction": "mean"})"),
       "/expect/0/over/place"},
      {"sweep over nothing",
       expect(R"("reduction": "final", "over": {"place": "/duration", "values": [], "reduction": "mean"})"),
       "/expect/0/over/values"},
      {"exponent of one value",
       expect(
           R"("reduction": "final", "over": {"place": "/duration", "values": [1], "reduction": "exponent"})"),
       "/expect/0/over/values"},
      {"exponent through zero",
       expect(
           R"("reduction": "final", "over": {"place": "/duration", "values": [0, 1], "reduction": "exponent"})"),
       "/expect/0/over/values/0"},
      {"parabola of values in disorder", expect(R"("reduction": "final",
              "over": {"place": "/duration", "values": [1, 3, 2], "reduction": "where-maximum"})"),
       "/expect/0/over/values/2"},
      {"extra is a number", with(R"("extra": 1)"), "/extra"},
      {"not UTF-8", head + ", \"about\": \"\xff\xfe\"}", "line 1"},
      {"50 MB of brackets", repeated("[", 50'000'000), "nested deeper"},
      {"50 MB of braces", repeated(R"({"a":)", 50'000'000), "nested deeper"},
  };
}

void expect_clear(const std::string& what, const std::string& message, const std::string& place) {
  EXPECT_EQ(message.find('\n'), std::string::npos) << what << ": " << message;
  EXPECT_LT(message.size(), 400U) << what << ": " << message;
  EXPECT_NE(message.find(place), std::string::npos) << what << ": " << message;
  EXPECT_TRUE(message.find("allowed") != std::string::npos ||
              message.find("reads up to") != std::string::npos ||
              message.find("needs five") != std::string::npos)
      << what << ": " << message;
}

TEST(BadPresets, AreRefusedInOneClearLine) {
  for (const Bad& bad : bad_presets()) {
    try {
      (void)parse_preset(bad.text, "bad.json");
      ADD_FAILURE() << bad.what << " was accepted";
    } catch (const SceneError& error) {
      const std::string message = error.what();
      EXPECT_EQ(message.rfind("bad.json: ", 0), 0U) << message;
      expect_clear(bad.what, message, bad.place);
    }
  }
}

TEST_F(PresetFiles, MissingFileAndFolder) {
  for (const fs::path& file : {folder_ / "missing.json", folder_}) {
    try {
      (void)read_preset(file);
      ADD_FAILURE() << file << " was accepted";
    } catch (const SceneError& error) {
      expect_clear(file.string(), error.what(), file.string());
    }
  }
}

// Every way to cut or to damage a preset by one byte ends in a scene or in a SceneError.
TEST(BadPresets, DamagedBytes) {
  const std::string good = content(test::preset_file("first-collisions/head-on.json"));
  for (std::size_t i = 0; i < good.size(); i += 3) {
    std::string cut = good.substr(0, i);
    std::string damaged = good;
    damaged[i] = static_cast<char>(damaged[i] ^ (1 << (i % 8)));
    for (const std::string& text : {cut, damaged}) {
      try {
        (void)parse_preset(text, "damaged.json");
      } catch (const SceneError& error) {
        EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos) << error.what();
      }
    }
  }
}

}  // namespace
}  // namespace carom

#include <array>

#include "tests/support/program.h"

namespace carom {
namespace {

// Wrong input, and the text that the one error line must contain.
struct BadCall {
  const char* name;
  const char* arguments;  // separated by blanks
  const char* part;
};

void PrintTo(const BadCall& call, std::ostream* out) { *out << call.arguments; }

class BadArguments : public testing::TestWithParam<BadCall> {};

TEST_P(BadArguments, AreRefusedInOneLine) {
  const Program carom;
  const BadCall& call = GetParam();
  expect_refused(carom(QString(call.arguments).split(' ', Qt::SkipEmptyParts)), call.part);
  EXPECT_EQ(carom.files(), QStringList());
}

INSTANTIATE_TEST_SUITE_P(Calls, BadArguments,
                         testing::ValuesIn(std::to_array<BadCall>({
                             {"UnknownName", "run no-such", "no-such: no such file or experiment"},
                             {"UnknownNameForTheLab", "no-such", "no-such: no such file or experiment"},
                             {"UnknownFile", "run no/such.json", "no/such.json: the file cannot be read"},
                             {"Folder", "run ./", "./: this is a folder"},
                             {"NoPreset", "run", "preset"},
                             {"TwoPresets", "run head-on pile", "pile"},
                             {"UnknownCommand", "jump head-on", "head-on"},
                             {"UnknownOption", "run head-on --bogus", "--bogus"},
                             {"UnknownIntegrator", "run head-on --integrator leapfrog", "semi-implicit-euler"},
                             {"ExactFlightWithDrag", "run drag-projectile --integrator exact-flight",
                              "--integrator: exact flight is not possible with drag; allowed: "},
                             {"UnknownImpacts", "run head-on --impacts never", "located"},
                             {"UnknownContacts", "run head-on --contacts glue", "impulse"},
                             {"StepZero", "run head-on --step 0", "--step: 0 is not allowed"},
                             {"StepNan", "run head-on --step nan", "--step: nan is not allowed"},
                             {"StepNegative", "run head-on --step -1", "--step: -1 is not allowed"},
                             {"StepInfinite", "run head-on --step inf", "--step: inf is not allowed"},
                             {"StepWord", "run head-on --step small", "--step"},
                             {"StepMissing", "run head-on --step", "--step"},
                             {"ToleranceZero", "run head-on --tolerance 0",
                              "--tolerance: 0 is not allowed; allowed: from 1e-14 to 0.1 m and m/s"},
                             {"ToleranceLarge", "run head-on --tolerance 1", "--tolerance: 1 is not allowed"},
                             {"ToleranceNan", "run head-on --tolerance nan", "--tolerance: nan is not allowed"},
                             {"ToleranceWord", "run head-on --tolerance fine", "--tolerance"},
                             {"ExactFlightPicture", "picture spring-box --integrator exact-flight -o a.png",
                              "--integrator: exact flight is not possible with springs; allowed: "},
                             {"UntilNegative", "run head-on --until -1", "--until: -1 is not allowed"},
                             {"UntilNan", "run head-on --until nan", "--until: nan is not allowed"},
                             {"UntilInfinite", "run head-on --until inf", "--until: inf is not allowed"},
                             {"UntilWord", "run head-on --until 1s", "--until: 1s is not allowed"},
                             {"CsvMissing", "run head-on --csv", "--csv"},
                             {"CsvUnwritable", "run head-on --csv no/such/run.csv", "no/such/run.csv"},
                             {"EventsUnwritable", "run head-on --events no/such/e.csv", "no/such/e.csv"},
                             {"SaveUnwritable", "run head-on --save no/such/end.json", "no/such/end.json"},
                             {"PictureWithoutOutput", "picture head-on", "--output"},
                             {"PictureSuffix", "picture head-on -o a.txt",
                              "a.txt: not a kind of picture; allowed: .png, .svg, .pdf"},
                             {"PictureNoSuffix", "picture head-on -o a", "a: not a kind of picture"},
                             {"PictureWindowSuffix", "picture head-on --window -o a.svg", "allowed: .png"},
                             {"PictureUnknown", "picture no-such -o a.png", "no-such"},
                             {"PictureAt", "picture head-on --at -1 -o a.png", "--at: -1 is not allowed"},
                             {"PictureWidth", "picture head-on --width 10 -o a.png", "--width"},
                             {"PicturePngUnwritable", "picture head-on -o no/such/a.png", "no/such/a.png"},
                             {"PictureSvgUnwritable", "picture head-on -o no/such/a.svg", "no/such/a.svg"},
                             {"PicturePdfUnwritable", "picture head-on -o no/such/a.pdf", "no/such/a.pdf"},
                             {"PictureWindowUnwritable", "picture head-on --window -o no/such/a.png",
                              "no/such/a.png"},
                         })),
                         [](const auto& one) { return std::string(one.param.name); });

// A preset file with one fault, and the place that the error line must name.
struct BadFile {
  const char* name;
  const char* text;  // %start: the keys that all need; %ball: the keys of a valid body
  const char* part;
};

void PrintTo(const BadFile& file, std::ostream* out) { *out << file.name; }

constexpr const char* kBall = R"("name": "ball", "shape": {"type": "disc", "radius": 0.1}, "position": [0, 0])";
constexpr const char* kStart = R"({"format": "carom-preset", "version": 1, "title": "t",)";

class BadPreset : public testing::TestWithParam<BadFile> {};

TEST_P(BadPreset, IsRefusedWithFileAndPlace) {
  const Program carom;
  const QString text = QString(GetParam().text).replace("%ball", kBall).replace("%start", kStart);
  carom.write("bad.json", text.toUtf8());
  const ProgramResult run = carom({"run", "bad.json"});
  expect_refused(run, "bad.json: ");
  expect_refused(run, GetParam().part);
  expect_refused(carom({"picture", "bad.json", "-o", "a.png"}), GetParam().part);
  expect_refused(carom({"bad.json"}), GetParam().part);
  EXPECT_EQ(carom.files(), QStringList{"bad.json"});
  EXPECT_EQ(carom.read("bad.json"), text.toUtf8());
}

INSTANTIATE_TEST_SUITE_P(
    Files, BadPreset,
    testing::ValuesIn(std::to_array<BadFile>({
        {"Empty", "", "line 1, column 1"},
        {"NotJson", "hello", "line 1, column 1"},
        {"Truncated", "%start\n\"bodies\": [{%ball}", "line 2, column"},
        {"NotAnObject", "[1, 2]", "/: [1,2] is not allowed"},
        {"NotAPreset", R"({"a": 1})", "\"format\" is missing"},
        {"NewerVersion", R"({"format": "carom-preset", "version": 99, "title": "t"})", "/version: "},
        {"UnknownKey", R"(%start "bodies": [{%ball, "colour": "red"}]})", "/bodies/0/colour: unknown key"},
        {"KeyTwice", R"(%start "duration": 1, "duration": 2})", "/duration: "},
        {"NegativeMass", R"(%start "bodies": [{%ball, "mass": -1}]})", "/bodies/0/mass: "},
        {"Nan", "%start\n\"bodies\": [{%ball, \"mass\": NaN}]}", "line 2, column"},
        {"HugeNumber", R"(%start "bodies": [{%ball, "mass": 1e999}]})", "1e999"},
        {"TwoOfOneName", R"(%start "bodies": [{%ball}, {%ball}]})", "/bodies/1/name: "},
        {"TextForNumber", R"(%start "bodies": [{%ball, "mass": "heavy"}]})", "/bodies/0/mass: "},
        {"ObjectForArray", R"(%start "bodies": {%ball}})", "/bodies: "},
        {"UnknownMaterial", R"(%start "bodies": [{%ball, "material": "butter"}]})", "/bodies/0/material: "},
        {"UnknownShape", R"(%start "bodies": [{"name": "a", "shape": {"type": "star"}, "position": [0, 0]}]})",
         "/bodies/0/shape/type: "},
        {"StepZero", R"(%start "method": {"step": 0}})", "/method/step: "},
    })),
    [](const auto& one) { return std::string(one.param.name); });

TEST(BadPresetBytes, NestedFiftyMillionDeepIsRefused) {
  const Program carom;
  constexpr qsizetype kBytes = 50'000'000;
  carom.write("arrays.json", QByteArray(kBytes, '['));
  expect_refused(carom({"run", "arrays.json"}), "arrays.json: /0/0");
  carom.write("objects.json", QByteArray(R"({"extra":)").repeated(kBytes / 9));
  expect_refused(carom({"run", "objects.json"}), "objects.json: /extra/extra");
}

TEST(BadPresetBytes, UnreadableBytesAreRefused) {
  const Program carom;
  carom.write("bytes.json", QByteArray("\x00\xff\xfe{\x80", 5));
  expect_refused(carom({"run", "bytes.json"}), "bytes.json: line 1, column 1");
}

}  // namespace
}  // namespace carom

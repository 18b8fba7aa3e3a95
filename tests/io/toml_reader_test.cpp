#include "scratch.hpp"

#include <scree/error.hpp>
#include <scree/io/replace_file.hpp>
#include <scree/io/toml_reader.hpp>

#include <array>
#include <cmath>
#include <utility>

namespace scree::io {
namespace {

using test::message_of;

constexpr std::array<std::string_view, 3> limiters{"minmod", "van_leer", "superbee"};

TomlFile parse(std::string_view text) {
  return TomlFile::parse(text, "scene.toml");
}

/// The report of a file from which `read(root)` reads.
template <class Read>
std::string report(std::string_view text, const Read& read) {
  TomlFile file = parse(text);
  read(file.root());
  return message_of<InputError>([&] { file.finish(); });
}

/// The report on one key of the first line.
template <class Read>
std::string report_on(const std::string& line, const Read& read) {
  return report("[mesh]\n" + line, [&](const TomlTable& root) { read(root.table("mesh")); });
}

TEST(TomlReader, ReadsEveryTypeOfValue) {
  TomlFile file = parse(R"(title = "flow"
gravity = [0, -9.81]
[mesh]
cells = 51
size = 0.02
periodic = true
limiter = "van_leer"
columns = ["velocity", "stress"]
[mesh.origin]
x = 1
[[walls]]
kind = "slip"
[[walls]]
kind = "no_slip"
)");
  const TomlTable root = file.root();
  const TomlTable mesh = root.table("mesh");

  EXPECT_EQ(root.string("title", "title"), "flow");
  EXPECT_EQ(root.numbers("gravity", "acceleration [m/s^2]", any_value(), 2), (std::vector<double>{0, -9.81}));
  EXPECT_EQ(mesh.integer("cells", "number of cells"), 51);
  EXPECT_EQ(mesh.number("size", "cell size [m]", above(0)), 0.02);
  EXPECT_TRUE(mesh.boolean("periodic", "whether it wraps"));
  EXPECT_EQ(mesh.choice("limiter", "slope limiter", limiters), "van_leer");
  EXPECT_EQ(mesh.strings("columns", "what to store"), (std::vector<std::string>{"velocity", "stress"}));
  EXPECT_EQ(mesh.table("origin").number("x", "origin [m]"), 1);
  const std::vector<TomlTable> walls = root.tables("walls");
  ASSERT_EQ(walls.size(), 2);
  EXPECT_EQ(walls[1].string("kind", "kind"), "no_slip");
  EXPECT_EQ(walls[0].string("kind", "kind"), "slip");
  EXPECT_NO_THROW(file.finish());
}

TEST(TomlReader, TellsATableFromAValue) {
  TomlFile file = parse("rough = {law = \"coulomb\"}\nsmooth = \"slip\"\n[inner]\n");
  const TomlTable root = file.root();

  EXPECT_TRUE(root.is_table("rough"));
  EXPECT_TRUE(root.is_table("inner"));
  EXPECT_FALSE(root.is_table("smooth"));
  EXPECT_FALSE(root.is_table("absent"));
}

TEST(TomlReader, TellsANameFromANumber) {
  TomlFile file = parse("size = \"grain_size\"\ndepth = 0.5\n");
  const TomlTable root = file.root();

  EXPECT_TRUE(root.is_string("size"));
  EXPECT_FALSE(root.is_string("depth"));
  EXPECT_FALSE(root.is_string("absent"));
}

TEST(TomlReader, FallsBackWhereAKeyOrTableIsLeftOut) {
  TomlFile file = parse("");
  const TomlTable solver = file.root().table_or_empty("solver");

  EXPECT_EQ(solver.number_or(0.5, "courant", "Courant number [-]"), 0.5);
  EXPECT_EQ(solver.integer_or(4, "threads", "number of threads"), 4);
  EXPECT_TRUE(solver.boolean_or(true, "quiet", "whether to print"));
  EXPECT_EQ(solver.string_or("a", "name", "name"), "a");
  EXPECT_EQ(solver.choice_or("minmod", "limiter", "slope limiter", limiters), "minmod");
  EXPECT_FALSE(solver.has("limiter"));
  EXPECT_TRUE(file.root().tables("walls").empty());
  EXPECT_NO_THROW(file.finish());
}

TEST(TomlReader, TakesAnIntegerForANumberButNotTheOtherWay) {
  TomlFile file = parse("size = 2");
  EXPECT_EQ(file.root().number("size", "size [m]"), 2);

  EXPECT_EQ(report_on("cells = 2.0", [](const TomlTable& mesh) { mesh.integer("cells", "number of cells"); }),
            "scene.toml:2: [mesh] cells = 2.0: expected an integer (number of cells), got a number");
}

TEST(TomlReader, NamesPlaceValueExpectationAndFindOfAWrongType) {
  EXPECT_EQ(
      report_on(R"(cells = "many")", [](const TomlTable& mesh) { mesh.integer("cells", "number of cells"); }),
      R"(scene.toml:2: [mesh] cells = "many": expected an integer (number of cells), got a string)");
  EXPECT_EQ(report_on("size = true", [](const TomlTable& mesh) { mesh.number("size", "cell size [m]"); }),
            "scene.toml:2: [mesh] size = true: expected a number (cell size [m]), got a boolean");
  EXPECT_EQ(report_on("size = {x = 1}", [](const TomlTable& mesh) { mesh.number("size", "cell size [m]"); }),
            "scene.toml:2: [mesh] size: expected a number (cell size [m]), got a table");
  EXPECT_EQ(report_on("wraps = 1", [](const TomlTable& mesh) { mesh.boolean("wraps", "whether it wraps"); }),
            "scene.toml:2: [mesh] wraps = 1: expected a boolean (whether it wraps), got an integer");
  EXPECT_EQ(report_on("name = 1979-05-27", [](const TomlTable& mesh) { mesh.string("name", "its name"); }),
            "scene.toml:2: [mesh] name = 1979-05-27: expected a string (its name), got a date");
  EXPECT_EQ(report("mesh = 3", [](const TomlTable& root) { root.table("mesh").integer("cells", "cells"); }),
            "scene.toml:1: mesh = 3: expected a table, got an integer");
  EXPECT_EQ(report("[walls]", [](const TomlTable& root) { root.tables("walls"); }),
            "scene.toml:1: walls: expected an array of tables, [[walls]], got a table");
}

TEST(TomlReader, QuotesAValueAsItIsWrittenWhateverStandsBeforeIt) {
  EXPECT_EQ(report_on("\"µ\" = 0.30  # ten µm\n",
                      [](const TomlTable& mesh) { mesh.number("µ", "friction [-]", above(0.38)); }),
            "scene.toml:2: [mesh] µ = 0.30: must exceed 0.38 (friction [-])");
}

TEST(TomlReader, DoesNotQuoteALongValue) {
  EXPECT_EQ(report_on("name = [\n1,\n2]", [](const TomlTable& mesh) { mesh.string("name", "its name"); }),
            "scene.toml:2: [mesh] name: expected a string (its name), got an array");
}

TEST(TomlReader, RefusesNumbersOutOfBoundsAndThoseThatAreNone) {
  const auto read = [](const TomlTable& mesh) { mesh.number("size", "cell size [m]", above(0)); };

  EXPECT_EQ(report_on("size = 0", read), "scene.toml:2: [mesh] size = 0: must exceed 0 (cell size [m])");
  EXPECT_EQ(report_on("size = nan", read), "scene.toml:2: [mesh] size = nan: must be finite (cell size [m])");
  EXPECT_EQ(report_on("size = -inf", read),
            "scene.toml:2: [mesh] size = -inf: must be finite (cell size [m])");
  EXPECT_EQ(
      report_on("cells = 0", [](const TomlTable& mesh) { mesh.integer("cells", "cells", at_least(1)); }),
      "scene.toml:2: [mesh] cells = 0: must be at least 1 (cells)");
}

TEST(TomlReader, NamesTheElementOfAnArrayThatIsAtFault) {
  const auto read = [](const TomlTable& mesh) { mesh.numbers("phi", "fractions [-]", between(0, 1), 2); };

  EXPECT_EQ(
      report_on(R"(phi = [0.5, "a"])", read),
      R"(scene.toml:2: [mesh] phi = [0.5, "a"]: element 2: expected a number (fractions [-]), got a string)");
  EXPECT_EQ(report_on("phi = [1.5, 0.5]", read),
            "scene.toml:2: [mesh] phi = [1.5, 0.5]: element 1: must lie in [0, 1] (fractions [-])");
  EXPECT_EQ(report_on("phi = [1]", read),
            "scene.toml:2: [mesh] phi = [1]: expected 2 values (fractions [-]), got 1");
  EXPECT_EQ(report_on("phi = 1", read),
            "scene.toml:2: [mesh] phi = 1: expected an array of numbers (fractions [-]), got an integer");
  EXPECT_EQ(report_on("names = [1]", [](const TomlTable& mesh) { mesh.strings("names", "names"); }),
            "scene.toml:2: [mesh] names = [1]: element 1: expected a string (names), got an integer");
}

TEST(TomlReader, OffersTheNearestOfTheNamesAllowed) {
  const auto read = [](const TomlTable& mesh) { mesh.choice("limiter", "slope limiter", limiters); };

  EXPECT_EQ(report_on(R"(limiter = "minmd")", read),
            R"(scene.toml:2: [mesh] limiter = "minmd": expected one of minmod, van_leer, superbee )"
            "(slope limiter), did you mean 'minmod'?");
  EXPECT_EQ(report_on(R"(limiter = "weno")", read),
            R"(scene.toml:2: [mesh] limiter = "weno": expected one of minmod, van_leer, superbee )"
            "(slope limiter)");
}

TEST(TomlReader, OffersTheNearestKnownKeyForAnUnknownOne) {
  const auto read = [](const TomlTable& mesh) {
    mesh.integer_or(1, "cells", "number of cells");
    mesh.number_or(1, "size", "cell size [m]");
  };

  EXPECT_EQ(report_on("cels = 3", read), "scene.toml:2: [mesh] cels: unknown key, did you mean 'cells'?");
  EXPECT_EQ(report_on("gravity = 3", read),
            "scene.toml:2: [mesh] gravity: unknown key, known here: cells, size");
  EXPECT_EQ(report("[mesh]\n[mehs]\ncells = 3\n", [&](const TomlTable& root) { read(root.table("mesh")); }),
            "scene.toml:2: mehs: unknown table, did you mean 'mesh'?");
}

TEST(TomlReader, FindsUnknownKeysInInnerTablesAndInEachTableOfAnArray) {
  const auto read = [](const TomlTable& root) {
    root.table("mesh").table("origin").number_or(0, "x", "origin [m]");
    for (const TomlTable& wall : root.tables("walls")) {
      if (wall.string("kind", "kind") == "coulomb") wall.number("friction", "friction [-]");
    }
  };

  EXPECT_EQ(report("mesh.origin.y = 3\n[[walls]]\nkind = \"slip\"\nfriction = 1\n"
                   "[[walls]]\nkind = \"coulomb\"\nfriction = 1\n",
                   read),
            "scene.toml:1: [mesh.origin] y: unknown key, known here: x\n"
            "scene.toml:4: [walls 1] friction: unknown key, known here: kind");
}

TEST(TomlReader, ReportsWhatIsMissing) {
  EXPECT_EQ(report("title = \"a\"\n[mesh]\n",
                   [](const TomlTable& root) {
                     root.string("title", "title");
                     root.number("time", "end of the run [s]");
                     root.table("mesh").integer("cells", "number of cells");
                     root.table("rheology").number("viscosity", "viscosity [Pa s]");
                     root.table_or_empty("output").number("interval", "time between frames [s]");
                   }),
            "scene.toml:2: [mesh] cells: missing, expected an integer (number of cells)\n"
            "scene.toml: time: missing, expected a number (end of the run [s])\n"
            "scene.toml: rheology: missing table\n"
            "scene.toml: [output] interval: missing, expected a number (time between frames [s])");
}

TEST(TomlReader, ReportsTheCallersOwnChecksAtTheKeyUnlessAKeyIsAtFaultAlready) {
  const auto read = [](const TomlTable& mesh) {
    const double mu_s = mesh.number("mu_s", "static friction [-]", above(0));
    const double mu_2 = mesh.number("mu_2", "dynamic friction [-]", above(0));
    mesh.check(mu_2 > mu_s, {"mu_2", "mu_s"}, "must exceed mu_s = " + to_text(mu_s));
    if (mesh.is_sound("mu_2")) mesh.add_fault("mu_2", "never said twice");
  };

  EXPECT_EQ(report_on("mu_s = 0.38\nmu_2 = 0.30", read),
            "scene.toml:3: [mesh] mu_2 = 0.30: must exceed mu_s = 0.38");
  EXPECT_EQ(report_on("mu_s = \"a\"\nmu_2 = -1", read),
            "scene.toml:2: [mesh] mu_s = \"a\": expected a number (static friction [-]), got a string\n"
            "scene.toml:3: [mesh] mu_2 = -1: must exceed 0 (dynamic friction [-])");
}

TEST(TomlReader, CollectsAllFaultsInTheOrderOfTheFile) {
  EXPECT_EQ(
      report("[mesh]\ncels = 3\nsize = -1\n[rheology]\nviscosity = \"low\"\n",
             [](const TomlTable& root) {
               root.table("rheology").number("viscosity", "viscosity [Pa s]");
               const TomlTable mesh = root.table("mesh");
               mesh.integer("cells", "number of cells");
               mesh.number("size", "cell size [m]", above(0));
             }),
      "scene.toml:1: [mesh] cells: missing, expected an integer (number of cells)\n"
      "scene.toml:2: [mesh] cels: unknown key, did you mean 'cells'?\n"
      "scene.toml:3: [mesh] size = -1: must exceed 0 (cell size [m])\n"
      "scene.toml:5: [rheology] viscosity = \"low\": expected a number (viscosity [Pa s]), got a string");
}

TEST(TomlReader, ReadsOnAfterAFaultWithAValueOfTheRightType) {
  TomlFile file = parse("a = []\n");
  const TomlTable root = file.root();

  EXPECT_TRUE(std::isnan(root.number("a", "a")));
  EXPECT_EQ(root.integer("b", "b"), 0);
  EXPECT_FALSE(root.boolean("c", "c"));
  EXPECT_EQ(root.string("d", "d"), "");
  EXPECT_EQ(root.choice("e", "e", limiters), "minmod");
  EXPECT_TRUE(root.numbers("f", "f").empty());
  EXPECT_EQ(root.number_or(3, "a", "a"), 3);
  EXPECT_FALSE(root.table("g").has("h") || root.table("g").is_sound("h"));
}

TEST(TomlReader, DocumentsTheKeysThatWereAskedFor) {
  TomlFile file = parse("[mesh]\ncells = 3\n[[walls]]\n[[walls]]\n");
  const TomlTable root = file.root();
  root.table("mesh").integer("cells", "number of cells", at_least(1));
  root.table_or_empty("solver").choice_or("minmod", "limiter", "slope limiter", limiters);
  for (const TomlTable& wall : root.tables("walls")) wall.number_or(0.5, "friction", "friction [-]");

  const std::span<const KnownKey> keys = file.known_keys();

  ASSERT_EQ(keys.size(), 3);
  EXPECT_EQ(keys[0].table + "|" + keys[0].key + "|" + keys[0].meaning, "mesh|cells|number of cells");
  EXPECT_EQ(keys[0].expectation + "|" + keys[0].fallback, "an integer, must be at least 1|");
  EXPECT_EQ(keys[1].expectation, "a string, one of minmod, van_leer, superbee");
  EXPECT_EQ(keys[1].fallback, "\"minmod\"");
  EXPECT_EQ(keys[2].table + "|" + keys[2].fallback, "walls|0.5");
}

TEST(TomlReader, PlacesAnErrorOfSyntaxByLineAndColumn) {
  EXPECT_EQ(message_of<InputError>([] { std::ignore = parse("[mesh]\ncells = \n"); }),
            "scene.toml:2:9: Error while parsing key-value pair: expected value, saw '\\n'");
  EXPECT_EQ(message_of<InputError>([] { std::ignore = parse("a = 1\na = 2\n"); }),
            "scene.toml:2:5: Error while parsing key-value pair: cannot redefine existing integer 'a'");
}

TEST(TomlReader, ReadsAFileAndNamesOneItCannotRead) {
  const test::Scratch folder;
  const std::filesystem::path path = folder / "scene.toml";
  const std::string absent = (folder / "absent.toml").string();
  replace_file(path, "cells = 51\n");

  EXPECT_EQ(TomlFile::read(path).root().integer("cells", "cells"), 51);
  EXPECT_EQ(message_of<InputError>([&] { std::ignore = TomlFile::read(absent); }),
            absent + ": cannot be read: No such file or directory");
  EXPECT_EQ(message_of<InputError>([&] { std::ignore = TomlFile::read(folder.path()); }),
            folder.path().string() + ": cannot be read: Is a directory");
}

}  // namespace
}  // namespace scree::io

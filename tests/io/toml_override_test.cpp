#include "scratch.hpp"

#include <scree/error.hpp>
#include <scree/io/toml_reader.hpp>

#include <utility>

namespace scree::io {
namespace {

using test::message_of;

constexpr std::string_view scene = R"(title = "flow"  # of the paper
mu = 0.30

[rheology]
name = "newtonian"

[mesh]
cells = 51
size = 0.02
points = [
  3,  # across
  3,
]
origin.x = 1

[[walls]]
kind = "slip"
range = [0, 1]

[[walls]]
kind = "no_slip"
)";

TomlFile parse() {
  return TomlFile::parse(scene, "scene.toml");
}

std::string fault_of(std::string_view assignment) {
  return message_of<InputError>([&] { parse().set(assignment); });
}

TEST(TomlOverride, ReplacesAValueOrAddsOne) {
  TomlFile file = parse();
  file.set("mesh.cells=102");
  file.set("mesh.limiter=van_leer");
  file.set("output.interval=0.5");
  file.set("mu=[1, 2]");
  const TomlTable mesh = file.root().table("mesh");

  EXPECT_EQ(mesh.integer("cells", "cells"), 102);
  EXPECT_EQ(mesh.string("limiter", "limiter"), "van_leer");
  EXPECT_EQ(file.root().table("output").number("interval", "interval [s]"), 0.5);
  EXPECT_EQ(file.root().numbers("mu", "mu"), (std::vector<double>{1, 2}));
}

TEST(TomlOverride, TakesWhatIsNotTomlForAString) {
  TomlFile file = parse();
  file.set("a=out/run-1");
  file.set("b=\"quoted = yes\"");
  file.set("c=true");
  file.set("d=1o2");

  EXPECT_EQ(file.root().string("a", "a"), "out/run-1");
  EXPECT_EQ(file.root().string("b", "b"), "quoted = yes");
  EXPECT_TRUE(file.root().boolean("c", "c"));
  EXPECT_EQ(file.root().string("d", "d"), "1o2");
}

TEST(TomlOverride, IsThePlaceOfItsFaults) {
  TomlFile file = parse();
  file.set("mesh.cells=abc");
  file.set("mesh.sise=3");
  const TomlTable root = file.root();
  root.string("title", "title");
  root.number("mu", "friction [-]");
  root.table("rheology").string("name", "law");
  root.tables("walls")[0].string("kind", "kind");
  root.tables("walls")[0].numbers("range", "range [m]");
  root.tables("walls")[1].string("kind", "kind");
  const TomlTable mesh = root.table("mesh");
  mesh.integer("cells", "number of cells");
  mesh.number("size", "cell size [m]");
  mesh.numbers("points", "points in a cell");
  mesh.table("origin").number("x", "origin [m]");

  EXPECT_EQ(message_of<InputError>([&] { file.finish(); }),
            "--set mesh.cells=abc: expected an integer (number of cells), got a string\n"
            "--set mesh.sise=3: unknown key, did you mean 'size'?");
}

TEST(TomlOverride, IsThePlaceOfAnUnknownTableThatItMade) {
  TomlFile file = TomlFile::parse("", "scene.toml");
  file.set("outptu.interval=0.5");
  file.root().table_or_empty("output").number_or(1, "interval", "interval [s]");

  EXPECT_EQ(message_of<InputError>([&] { file.finish(); }),
            "--set outptu.interval=0.5: unknown table, did you mean 'output'?");
}

TEST(TomlOverride, RefusesWhatIsNotAnAssignment) {
  for (const std::string bad : {"mesh.cells", "=3", "mesh.=3", ".cells=3", "mesh.cells=", "a b=3", ""}) {
    EXPECT_EQ(fault_of(bad), "--set " + bad + ": expected table.key=value");
  }
  EXPECT_EQ(fault_of("mesh.cells.x=3"), "--set mesh.cells.x=3: 'mesh.cells' is not a table");
  EXPECT_EQ(fault_of("walls.kind=slip"), "--set walls.kind=slip: 'walls' is not a table");
  EXPECT_EQ(fault_of("mesh.cells=[1,"), "--set mesh.cells=[1,: the value is not TOML");
  EXPECT_EQ(fault_of("a=1\nb=2"), "--set a=1\nb=2: the value is not TOML");
  EXPECT_EQ(fault_of("mesh={cells = 3}"), "--set mesh={cells = 3}: a table is set key by key");
  EXPECT_EQ(fault_of("walls=[{kind = 3}]"), "--set walls=[{kind = 3}]: a table is set key by key");
}

TEST(TomlOverride, LeavesTheTextOfAnUnchangedFileAlone) {
  EXPECT_EQ(parse().to_text(), scene);
}

TEST(TomlOverride, IsPartOfTheTextWithKeysInTheOrderOfTheFileAndValuesAsWritten) {
  TomlFile file = parse();
  file.set("mesh.cells=102");
  file.set("mesh.limiter=van_leer");
  file.set("output.interval=0.50");
  file.set("quiet=true");

  EXPECT_EQ(file.to_text(), R"(title = "flow"
mu = 0.30
quiet = true

[rheology]
name = "newtonian"

[mesh]
cells = 102
size = 0.02
points = [
  3,  # across
  3,
]
limiter = 'van_leer'

[mesh.origin]
x = 1

[[walls]]
kind = "slip"
range = [0, 1]

[[walls]]
kind = "no_slip"

[output]
interval = 0.50
)");
}

TEST(TomlOverride, KeepsKeysThatNeedQuotesAndTablesWrittenInOneLine) {
  TomlFile file =
      TomlFile::parse("\"a b\" = 1\nwalls = [{kind = \"slip\"}, {}]\norigin = {x = 1}\n", "scene.toml");
  file.set("origin.y=2");

  EXPECT_EQ(file.to_text(),
            "'a b' = 1\n\n[[walls]]\nkind = \"slip\"\n\n[[walls]]\n\n[origin]\nx = 1\ny = 2\n");
}

TEST(TomlOverride, LastsThroughWritingAndReading) {
  TomlFile file = parse();
  file.set("mesh.origin.x=0.1");
  file.set("mesh.origin=3");
  file.set("mesh.size=1e-300");

  TomlFile again = TomlFile::parse(file.to_text(), "again");
  again.set("mesh.cells=51");  // prints the parsed tables, not the text that was read

  EXPECT_EQ(again.to_text(), file.to_text());
  EXPECT_EQ(again.root().table("mesh").number("origin", "origin"), 3);
  EXPECT_EQ(again.root().table("mesh").number("size", "size"), 1e-300);
}

}  // namespace
}  // namespace scree::io

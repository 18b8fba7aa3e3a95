#include "scratch.hpp"

#include <scree/error.hpp>
#include <scree/io/esri_ascii.hpp>

#include <cmath>
#include <fstream>
#include <string>

namespace scree::io {
namespace {

using test::message_of;

const std::string corners =
    "ncols 3\nnrows 2\nxllcorner 100\nyllcorner 50\ncellsize 10\nNODATA_value -9999\n";

[[nodiscard]] std::string fault(const std::string& text) {
  return message_of<InputError>([&] { static_cast<void>(parse_esri_ascii(text, "dem.asc")); });
}

TEST(EsriAscii, HasItsNorthernmostRowFirst) {
  const Raster raster = parse_esri_ascii(corners + "1 2 3\n4 -9999 6.5e0\n", "dem.asc");

  ASSERT_EQ(raster.num_columns, 3);
  ASSERT_EQ(raster.num_rows, 2);
  EXPECT_EQ(raster.cell_size, 10);
  EXPECT_EQ(raster.values[0], 4);
  EXPECT_TRUE(std::isnan(raster.values[1]));
  EXPECT_EQ(raster.values[2], 6.5);
  EXPECT_EQ(raster.values[3], 1);
  EXPECT_EQ(raster.values[5], 3);
}

TEST(EsriAscii, HasItsValuesInTheMiddleOfCellsByBothConventions) {
  const std::string values = "1 2 3 4 5 6";
  const Raster by_corner = parse_esri_ascii(corners + values, "dem.asc");
  const Raster by_centre = parse_esri_ascii(
      "XLLCENTER 105\r\nYLLCENTER 55\r\nCELLSIZE 10\r\nNROWS 2\r\nNCOLS 3\r\n" + values, "dem.asc");

  EXPECT_EQ(by_corner.first, (Vector<2>{105, 55}));
  EXPECT_EQ(by_centre.first, by_corner.first);
  EXPECT_EQ(by_centre.values, by_corner.values);
}

TEST(EsriAscii, IsReadFromAFile) {
  const test::Scratch scratch;
  std::ofstream{scratch / "dem.asc"} << corners << "1 2 3 4 5 6\n";

  EXPECT_EQ(read_esri_ascii(scratch / "dem.asc").values.size(), 6U);
}

TEST(EsriAscii, RefusesAHeaderThatSaysTooLittle) {
  EXPECT_EQ(fault("ncols 3\nnrows 2\nxllcorner 0\nyllcorner 0\n1 2 3 4 5 6"),
            "dem.asc: the header lacks 'cellsize'");
  EXPECT_EQ(
      fault("ncols 3\nnrows 2\ncellsize 1\nxllcorner 0\n1 2 3 4 5 6"),
      "dem.asc: the header must have either xllcorner and yllcorner, of the outermost corner, or xllcenter "
      "and yllcenter, of the outermost cell's centre");
}

TEST(EsriAscii, RefusesCornersMixedWithCentres) {
  EXPECT_EQ(
      fault("ncols 1\nnrows 1\ncellsize 1\nxllcorner 0\nyllcenter 0\n1"),
      "dem.asc: the header must have either xllcorner and yllcorner, of the outermost corner, or xllcenter "
      "and yllcenter, of the outermost cell's centre");
}

TEST(EsriAscii, RefusesAHeaderThatSaysWhatItDoesNotKnow) {
  EXPECT_EQ(
      fault("ncols 3\nnrows 2\ndx 1\n"),
      "dem.asc:3: 'dx' is no key of the header, which has ncols, nrows, xllcorner, yllcorner, xllcenter, "
      "yllcenter, cellsize and nodata_value");
  EXPECT_EQ(fault("ncols 3\nNCOLS 3\n"), "dem.asc:2: 'ncols' is given twice");
  EXPECT_EQ(fault("ncols many\n"), "dem.asc:1: 'many' is not a number");
}

TEST(EsriAscii, RefusesCellsOfNoSizeAndPartsOfCells) {
  EXPECT_EQ(fault("ncols 1\nnrows 1\ncellsize -5\nxllcorner 0\nyllcorner 0\n1"),
            "dem.asc: cellsize must be positive and finite");
  EXPECT_EQ(fault("ncols 1.5\nnrows 1\ncellsize 5\nxllcorner 0\nyllcorner 0\n1"),
            "dem.asc: ncols must be a whole number from 1 on");
}

TEST(EsriAscii, RefusesTooFewAndTooManyValues) {
  EXPECT_EQ(fault(corners + "1 2 3 4 5"), "dem.asc: holds 5 values, and ncols x nrows is 6");
  EXPECT_EQ(fault(corners + "1 2 3 4 5 6 7"), "dem.asc: holds 7 values, and ncols x nrows is 6");
  EXPECT_EQ(fault(corners + "1 2 3\n4 5 six"), "dem.asc:8: 'six' is not a number");
  EXPECT_EQ(fault("ncols 1e5\nnrows 1e5\ncellsize 5\nxllcorner 0\nyllcorner 0\n1"),
            "dem.asc: is too short for ncols x nrows values");
}

TEST(EsriAscii, NamesAFileThatIsNotThere) {
  EXPECT_EQ(message_of<InputError>([] { static_cast<void>(read_esri_ascii("nowhere/dem.asc")); }),
            "nowhere/dem.asc: cannot be read: No such file or directory");
}

}  // namespace
}  // namespace scree::io

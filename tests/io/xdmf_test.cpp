#include <scree/io/xdmf.hpp>

#include <gtest/gtest.h>

namespace scree::io {
namespace {

TEST(Xdmf, DescribesOneInstantAsACloudOfPoints) {
  const StoredFrame frame{
      .name = "000012",
      .time = 0.1,
      .num_points = 5,
      .columns = {{.quantity = {"fraction", "phi", "-"}, .kind = ColumnKind::classes, .num_components = 2},
                  {.quantity = {"position", "x", "m"}, .kind = ColumnKind::vector, .num_components = 3},
                  {.quantity = {"stress", "sigma", "Pa"}, .kind = ColumnKind::tensor, .num_components = 9},
                  {.quantity = {"velocity", "v", "m/s"}, .kind = ColumnKind::vector, .num_components = 3},
                  {.quantity = {"volume", "V", "m^3"}}}};

  EXPECT_EQ(to_xdmf({&frame, 1}), R"(<?xml version="1.0" encoding="UTF-8"?>
<Xdmf Version="3.0">
<Domain>
  <Grid Name="run" GridType="Collection" CollectionType="Temporal">
    <Grid Name="000012" GridType="Uniform">
      <Time Value="0.1"/>
      <Topology TopologyType="Polyvertex" NumberOfElements="5"/>
      <Geometry GeometryType="XYZ">
        <DataItem Format="HDF" NumberType="Float" Precision="8" Dimensions="5 3">frames/000012.h5:/position</DataItem>
      </Geometry>
      <Attribute Center="Node" AttributeType="Scalar" Name="fraction_1">
        <DataItem ItemType="HyperSlab" Dimensions="5"><DataItem Format="XML" Dimensions="3 2">0 0 1 1 5 1</DataItem>
        <DataItem Format="HDF" NumberType="Float" Precision="8" Dimensions="5 2">frames/000012.h5:/fraction</DataItem>
      </DataItem>
      </Attribute>
      <Attribute Center="Node" AttributeType="Scalar" Name="fraction_2">
        <DataItem ItemType="HyperSlab" Dimensions="5"><DataItem Format="XML" Dimensions="3 2">0 1 1 1 5 1</DataItem>
        <DataItem Format="HDF" NumberType="Float" Precision="8" Dimensions="5 2">frames/000012.h5:/fraction</DataItem>
      </DataItem>
      </Attribute>
      <Attribute Center="Node" AttributeType="Tensor" Name="stress [Pa]">
        <DataItem Format="HDF" NumberType="Float" Precision="8" Dimensions="5 9">frames/000012.h5:/stress</DataItem>
      </Attribute>
      <Attribute Center="Node" AttributeType="Vector" Name="velocity [m/s]">
        <DataItem Format="HDF" NumberType="Float" Precision="8" Dimensions="5 3">frames/000012.h5:/velocity</DataItem>
      </Attribute>
      <Attribute Center="Node" AttributeType="Scalar" Name="volume [m^3]">
        <DataItem Format="HDF" NumberType="Float" Precision="8" Dimensions="5">frames/000012.h5:/volume</DataItem>
      </Attribute>
    </Grid>
  </Grid>
</Domain>
</Xdmf>
)");
}

TEST(Xdmf, EscapesWhatMeansSomethingToXml) {
  const StoredFrame frame{.name = "000000", .columns = {{.quantity = {"a<b&\"c\">", "s", "-"}}}};

  EXPECT_NE(to_xdmf({&frame, 1}).find("Name=\"a&lt;b&amp;&quot;c&quot;&gt;\""), std::string::npos);
}

}  // namespace
}  // namespace scree::io

// A value goes from a scene to a checkpoint and back.
#include <scree/io/checkpoint.hpp>
#include <scree/io/toml_reader.hpp>

#include <filesystem>

int main() {
  namespace io = scree::io;
  io::TomlFile scene = io::TomlFile::parse("[mesh]\ncell_size = 0.02\n", "scene.toml");
  const double cell_size = scene.root().table("mesh").number("cell_size", "edge of a cell [m]", io::above(0));
  scene.finish();
  const auto path = std::filesystem::temp_directory_path() / "scree_consumer.h5";

  io::CheckpointWriter writer{path, 1};
  writer.add("cell_size", cell_size);
  writer.commit();
  const double read = io::read_checkpoint(path, 1).number("cell_size");

  std::filesystem::remove(path);
  return read == cell_size && cell_size == 0.02 ? 0 : 1;
}

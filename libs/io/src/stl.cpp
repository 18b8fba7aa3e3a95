#include "read_bytes.hpp"
#include "words.hpp"

#include <scree/io/stl.hpp>

#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <map>

namespace scree::io {

namespace {

using detail::Words;

constexpr std::size_t header_size = 80;    // [bytes], of no meaning
constexpr std::size_t triangle_size = 50;  // [bytes], twelve floats and two bytes of no meaning
constexpr std::size_t corners_begin = 12;  // [bytes], after the normal

static_assert(std::endian::native == std::endian::little, "numbers of binary STL would have to be turned");

/// Triangles whose corners at the same place are one vertex.
class Welder {
 public:
  /// @returns false if a corner is not finite.
  [[nodiscard]] bool add(const std::array<Vector<3>, 3>& corners) {
    std::array<Index, 3> triangle{};
    for (std::size_t i = 0; i < 3; ++i) {
      if (!corners[i].allFinite()) return false;
      triangle[i] = vertex(corners[i]);
    }
    mesh_.triangles.push_back(triangle);
    return true;
  }
  [[nodiscard]] std::size_t count() const noexcept { return mesh_.triangles.size(); }
  [[nodiscard]] TriangleMesh take() { return std::move(mesh_); }

 private:
  [[nodiscard]] Index vertex(const Vector<3>& x) {
    const std::array<double, 3> key{x[0] + 0.0, x[1] + 0.0, x[2] + 0.0};  // -0 and 0 are one place
    const auto [found, is_new] = numbers_.try_emplace(key, static_cast<Index>(mesh_.vertices.size()));
    if (is_new) mesh_.vertices.push_back(x);
    return found->second;
  }
  std::map<std::array<double, 3>, Index> numbers_;
  TriangleMesh mesh_;
};

template <class Number>
[[nodiscard]] Number number_at(std::string_view bytes, std::size_t place) {
  Number number;
  std::memcpy(&number, bytes.data() + place, sizeof number);
  return number;
}

[[nodiscard]] TriangleMesh parse_binary(std::string_view bytes, const std::string& name) {
  Welder welder;
  for (std::size_t place = header_size + 4; place < bytes.size(); place += triangle_size) {
    std::array<Vector<3>, 3> corners;
    for (std::size_t i = 0; i < 9; ++i) {
      corners[i / 3][static_cast<int>(i % 3)] =
          static_cast<double>(number_at<float>(bytes, place + corners_begin + 4 * i));
    }
    if (!welder.add(corners)) {
      throw InputError{name + ": triangle " + std::to_string(welder.count()) +
                       " has a corner that is not finite"};
    }
  }
  return welder.take();
}

void expect(Words& words, std::initializer_list<std::string_view> expected) {
  for (const std::string_view word : expected) {
    const std::string_view found = words.next();
    if (found == word) continue;
    words.fail(found.empty() ? "ends where " + Words::quoted(word) + " is due"
                             : Words::quoted(word) + " is due, not " + Words::quoted(found));
  }
}

[[nodiscard]] Vector<3> read_place(Words& words) {
  const double x = words.number();
  const double y = words.number();
  return {x, y, words.number()};
}

[[nodiscard]] TriangleMesh parse_text(std::string_view text, const std::string& name) {
  // The name of the solid is the rest of its line, and may be any words.
  const std::size_t line_end = std::min(text.find('\n'), text.size());
  Words words{text.substr(line_end), name};
  Welder welder;
  while (words.peek() != "endsolid") {
    expect(words, {"facet", "normal"});
    static_cast<void>(read_place(words));
    expect(words, {"outer", "loop"});
    std::array<Vector<3>, 3> corners;
    for (Vector<3>& corner : corners) {
      expect(words, {"vertex"});
      corner = read_place(words);
    }
    if (!welder.add(corners)) words.fail("a corner that is not finite");
    expect(words, {"endloop", "endfacet"});
  }
  return welder.take();
}

}  // namespace

TriangleMesh parse_stl(std::string_view bytes, const std::string& name) {
  TriangleMesh mesh;
  const bool has_count = bytes.size() >= header_size + 4;
  const std::size_t count = has_count ? number_at<std::uint32_t>(bytes, header_size) : 0;
  const std::size_t expected = header_size + 4 + triangle_size * count;
  if (has_count && bytes.size() == expected) {
    mesh = parse_binary(bytes, name);
  } else if (bytes.starts_with("solid")) {
    mesh = parse_text(bytes, name);
  } else {
    throw InputError{name + ": is no STL: a text begins with 'solid', and " + std::to_string(count) +
                     " triangles of a binary one take " + std::to_string(expected) + " bytes, not " +
                     std::to_string(bytes.size())};
  }
  if (mesh.triangles.empty()) throw InputError{name + ": holds no triangle"};
  return mesh;
}

TriangleMesh read_stl(const std::filesystem::path& path) {
  return parse_stl(detail::read_bytes(path), path.string());
}

}  // namespace scree::io

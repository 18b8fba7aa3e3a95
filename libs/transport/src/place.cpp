#include <scree/transport/detail/place.hpp>

#include <array>
#include <sstream>

namespace scree::transport::detail {

std::string tuple_text(std::span<const double> numbers) {
  std::ostringstream text;
  text << '(';
  for (std::size_t i = 0; i < numbers.size(); ++i) text << (i == 0 ? "" : ", ") << numbers[i];
  text << ')';
  return text.str();
}

template <int D>
std::string place_text(const Indices<D>& site, const Vector<D>& position) {
  std::array<double, static_cast<std::size_t>(D)> numbers;
  for (std::size_t axis = 0; axis < D; ++axis) numbers[axis] = static_cast<double>(site[axis]);
  return "site " + tuple_text(numbers) + ", position " + position_text<D>(position) + " m";
}

template std::string place_text<1>(const Indices<1>&, const Vector<1>&);
template std::string place_text<2>(const Indices<2>&, const Vector<2>&);
template std::string place_text<3>(const Indices<3>&, const Vector<3>&);

}  // namespace scree::transport::detail

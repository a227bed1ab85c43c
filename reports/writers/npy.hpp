// Arrays for numpy.load: NPY format 1.0, little endian, C order.
// Source: numpy.lib.format, "Format Version 1.0".
#pragma once

#include <cstdint>
#include <initializer_list>
#include <span>
#include <string>

namespace polhode::report {

/// The product of the shape is the number of values.
std::string to_npy(std::span<const double>, std::initializer_list<std::size_t> shape);
std::string to_npy(std::span<const std::uint32_t>, std::initializer_list<std::size_t> shape);

}  // namespace polhode::report

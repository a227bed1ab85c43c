// SPDX-License-Identifier: Apache-2.0
// Arrays for numpy.load: NPY format 1.0, little endian, C order.
// Source: numpy.lib.format, "Format Version 1.0".
#pragma once

#include <cstdint>
#include <initializer_list>
#include <span>
#include <string>

namespace polhode::report {

/// From [column][row], so many columns: an array of rows.
std::string to_npy_rows(std::span<const double> columns, std::size_t count);

/// What stands before the values of an array of doubles.
std::string npy_header_of_doubles(std::initializer_list<std::size_t> shape);

/// The product of the shape is the number of values.
std::string to_npy(std::span<const std::uint32_t>, std::initializer_list<std::size_t> shape);

}  // namespace polhode::report

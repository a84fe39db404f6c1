// The median of measurements, which outliers do not move.
#pragma once

#include <algorithm>
#include <vector>

namespace tumble::tools {

inline double median(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    const std::size_t middle = values.size() / 2;
    return values.size() % 2 == 1 ? values[middle] : 0.5 * (values[middle - 1] + values[middle]);
}

}  // namespace tumble::tools

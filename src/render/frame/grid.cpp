#include "render/frame/grid.hpp"

#include <cmath>

#include "debug/check.hpp"

namespace tumble::render {
namespace {

constexpr float kDepthInside = -1.0f;       // pixels: so deep in a shape that no edge is blended
constexpr double kLeastLineSpacing = 36.0;  // pixels at 720 rows between fine lines

double power_of_ten(int exponent) {
    double power = 1.0;
    for (int i = 0; i < std::abs(exponent); ++i) power *= 10.0;
    return exponent < 0 ? 1.0 / power : power;
}

// A sharp line along one axis through pixel `at` of the other. It covers whole pixels, so that it needs no blended
// edge: as a box, which has one, the grid took a fifth of the time of a frame of a thousand bodies.
void add_grid_line(Layer& layer, const View& view, bool is_vertical, double at, Color color) {
    // The pixel grid is shifted by half a pixel from the middle of a frame of odd size.
    const double parity = (is_vertical ? view.width : view.height) % 2 == 0 ? 0.5 : 0.0;
    const float center = static_cast<float>(std::floor(at - parity + 0.5) + parity);
    const float reach = 0.5f * static_cast<float>(is_vertical ? view.height : view.width);
    for (const int corner : {0, 1, 2, 2, 1, 3}) {
        const float across = center + (corner & 1 ? 0.5f : -0.5f), along = corner & 2 ? reach : -reach;
        layer.mesh.push_back({is_vertical ? across : along, is_vertical ? along : across, kDepthInside, flat(color)});
    }
}

// Beyond it the next number of a line may be its own.
constexpr double kMostCounted = 0x1p52;

// Lines at the multiples of `step` (m) in view; those at multiples of `every` steps, or all others.
void add_lines(Layer& layer, const View& view, double step, int every, bool strong, Color color) {
    for (const bool is_vertical : {true, false}) {
        const double middle = is_vertical ? view.center.x : view.center.y;
        const double reach = 0.5 * (is_vertical ? view.width : view.height) / view.scale;
        const double first = std::ceil((middle - reach) / step), last = std::floor((middle + reach) / step);
        if (!(std::abs(first) < kMostCounted && std::abs(last) < kMostCounted)) return;
        for (double i = first; i <= last; i += 1.0) {
            if ((std::fmod(i, every) == 0.0) != strong) continue;
            add_grid_line(layer, view, is_vertical, view.scale * (i * step - middle), color);
        }
    }
}

}  // namespace

double RoundLength::metres() const {
    return exponent < 0 ? mantissa / power_of_ten(-exponent) : mantissa * power_of_ten(exponent);
}

RoundLength round_length_from(double metres) {
    TUMBLE_CHECK(metres > 0.0);
    RoundLength length{1, static_cast<int>(std::floor(std::log10(metres)))};
    // log10 may round to either side of a power of ten: start one below and let the comparison decide.
    for (--length.exponent;; ++length.exponent)
        for (const int mantissa : {1, 2, 5})
            if (length.mantissa = mantissa; length.metres() >= metres * (1.0 - 1e-12)) return length;
}

std::string to_string(RoundLength length) {
    struct Unit {
        const char* name;
        int exponent;
    };
    constexpr Unit kUnits[] = {{"km", 3}, {"m", 0}, {"cm", -2}, {"mm", -3}, {"\u00b5m", -6}, {"nm", -9}};
    for (const Unit& unit : kUnits) {
        if (length.exponent < unit.exponent) continue;
        return std::to_string(length.mantissa) +
               std::string(static_cast<std::size_t>(length.exponent - unit.exponent), '0') + " " + unit.name;
    }
    return std::to_string(length.mantissa) + "e" + std::to_string(length.exponent) + " m";
}

void add_grid(Layer& layer, const View& view, const Colors& colors) {
    const RoundLength step = round_length_from(kLeastLineSpacing * view.detail() / view.scale);
    const int every = step.mantissa == 5 ? 4 : 5;
    add_lines(layer, view, step.metres(), every, false, colors.minor_grid);
    add_lines(layer, view, step.metres(), every, true, colors.major_grid);
}

}  // namespace tumble::render

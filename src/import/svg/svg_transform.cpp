// The six functions of the transform attribute (SVG 1.1, 7.6).
#include "import/svg/svg_transform.hpp"

#include <array>
#include <cmath>
#include <string>

#include "import/svg/svg_text.hpp"
#include "scene/json/json_text.hpp"

namespace tumble::scene {

namespace {

constexpr std::size_t kMostArguments = 6;

struct Arguments {
    std::array<double, kMostArguments> values{};
    std::size_t count = 0;
};

Arguments read_arguments(SvgScanner& scanner) {
    Arguments arguments;
    scanner.expect('(');
    while (!scanner.take_if(')')) {
        if (arguments.count == kMostArguments) scanner.refuse("')'");
        arguments.values[arguments.count++] = scanner.number();
    }
    return arguments;
}

Affine rotation(double degrees) {
    const SinCos q = sin_cos_degrees(degrees);
    return {{q.cos, q.sin}, {-q.sin, q.cos}, {}};
}

Affine translation(DVec2 by) { return {{1.0, 0.0}, {0.0, 1.0}, by}; }

// Infinite for an odd multiple of 90 degrees; Flattener then refuses the coordinates as not finite.
double tangent(double degrees) {
    const SinCos q = sin_cos_degrees(degrees);
    return q.sin / q.cos;
}

Affine make_function(std::string_view name, const Arguments& arguments) {
    const auto& [v, count] = arguments;
    if (name == "matrix" && count == 6) return {{v[0], v[1]}, {v[2], v[3]}, {v[4], v[5]}};
    if (name == "translate" && (count == 1 || count == 2)) return translation({v[0], v[1]});
    if (name == "scale" && count == 1) return {{v[0], 0.0}, {0.0, v[0]}, {}};
    if (name == "scale" && count == 2) return {{v[0], 0.0}, {0.0, v[1]}, {}};
    if (name == "rotate" && count == 1) return rotation(v[0]);
    if (name == "rotate" && count == 3)
        return compose(translation({v[1], v[2]}), compose(rotation(v[0]), translation({-v[1], -v[2]})));
    if (name == "skewX" && count == 1) return {{1.0, 0.0}, {tangent(v[0]), 1.0}, {}};
    if (name == "skewY" && count == 1) return {{1.0, tangent(v[0])}, {0.0, 1.0}, {}};
    throw SvgError("transform: " + quoted(std::string(name)) + " with " + std::to_string(count) +
                   " arguments is not a transform");
}

}  // namespace

bool is_similarity(const Affine& map) {
    const double xx = length_sq(map.x_axis), yy = length_sq(map.y_axis), xy = dot(map.x_axis, map.y_axis);
    constexpr double kAgreement = 1e-12;  // of a dozen products
    return std::abs(xx - yy) <= kAgreement * xx && std::abs(xy) <= kAgreement * xx;
}

Affine parse_transform(std::string_view text) {
    Affine result;
    SvgScanner scanner(text);
    while (!scanner.at_end()) {
        const std::string_view name = scanner.word();
        result = compose(result, make_function(name, read_arguments(scanner)));
    }
    return result;
}

}  // namespace tumble::scene

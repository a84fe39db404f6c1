#include "scene/format/draw.hpp"

#include <cmath>
#include <string_view>
#include <vector>

#include "scene/format/random.hpp"
#include "scene/json/pointer.hpp"

namespace tumble::scene {

namespace {

constexpr int kMostTries = 1000;
constexpr std::size_t kMostChoices = 1000;

// FNV-1a (Fowler, Noll, Vo): the stream of a key. Random mixes its bits.
std::uint64_t stream_of(std::string_view key) {
    std::uint64_t hash = 0xcbf29ce484222325u;
    for (const char c : key) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3u;
    return hash;
}

// True with the probability exp(-p), p in [0, 1], by comparisons only (von Neumann 1951): the length of the longest
// falling sequence of uniform numbers below p is even.
bool is_exponential(Random& random, double p) {
    bool is_even = true;
    for (double last = p, next = random.unit(); next < last; next = random.unit()) {
        last = next;
        is_even = !is_even;
    }
    return is_even;
}

// The same for p = `times` * `part`.
bool is_exponential(Random& random, double part, int times) {
    for (int i = 0; i < times; ++i)
        if (!is_exponential(random, part)) return false;
    return true;
}

// A normal number of mean 0 and deviation 1, without functions of libm, whose bits depend on the machine (Karney 2016,
// "Sampling exactly from the normal distribution", algorithm N).
double unit_normal(Random& random) {
    while (true) {
        int whole = 0;
        while (is_exponential(random, 0.5)) ++whole;
        if (!is_exponential(random, 0.5, whole * (whole - 1))) continue;
        const double rest = random.unit();
        if (!is_exponential(random, 0.5 * rest * rest) || !is_exponential(random, rest, whole)) continue;
        return random.unit() < 0.5 ? -(whole + rest) : whole + rest;
    }
}

std::vector<double> numbers_of(const Json& declaration, const std::string& kind) {
    const Json& list = declaration[kind];
    const bool is_choice = kind == "choice";
    const bool has_size =
        list.is_array() && (is_choice ? !list.empty() && list.size() <= kMostChoices : list.size() == 2);
    if (!has_size)
        throw WrongDraw{kind, is_choice ? "must be an array of 1 to 1000 numbers" : "must be an array of 2 numbers"};
    std::vector<double> numbers;
    for (const Json& element : list) {
        if (!element.is_number()) throw WrongDraw{kind, "must contain numbers only"};
        numbers.push_back(element.get<double>() + 0.0);
    }
    return numbers;
}

double draw_uniform(const std::vector<double>& ends, bool whole, Random& random) {
    if (ends[0] > ends[1]) throw WrongDraw{"uniform", "must be [lower, upper] with lower <= upper"};
    if (!whole) return ends[0] + random.unit() * (ends[1] - ends[0]);
    return ends[0] + std::floor(random.unit() * (ends[1] - ends[0] + 1.0));
}

double draw_normal(const std::vector<double>& shape, Random& random, const std::function<bool(double)>& is_in_range) {
    if (shape[1] < 0.0) throw WrongDraw{"normal", "must be [mean, deviation] with a deviation of at least 0"};
    for (int i = 0; i < kMostTries; ++i) {
        const double number = shape[0] + shape[1] * unit_normal(random);
        if (is_in_range(number)) return number;
    }
    throw WrongDraw{"normal", "hardly ever gives a number in the range of this key"};
}

}  // namespace

std::string draw_key(const Json& root, const std::string& pointer, const DrawContext& context) {
    std::string key = context.part;
    const Json* value = &root;
    for (const std::string& step : split_pointer(pointer)) {
        value = value->is_array() ? &(*value)[static_cast<std::size_t>(std::stoull(step))] : &(*value)[step];
        const bool has_name = value->is_object() && value->contains("name") && (*value)["name"].is_string();
        key = append_key(key, has_name ? (*value)["name"].get<std::string>() : step);
    }
    return key;
}

double draw_number(const Json& declaration, const std::string& key, std::uint64_t seed, bool whole,
                   const std::function<bool(double)>& is_in_range) {
    std::string kind;
    for (const char* known : {"uniform", "normal", "choice"})
        if (declaration.contains(known)) kind = known;
    if (declaration.size() != 1 || kind.empty())
        throw WrongDraw{"",
                        "must be a number, or one of {\"uniform\": [lower, upper]}, {\"normal\": [mean, deviation]}, "
                        "{\"choice\": [...]}"};
    const std::vector<double> numbers = numbers_of(declaration, kind);
    if (whole && kind == "normal") throw WrongDraw{kind, "gives no whole numbers; use \"uniform\" or \"choice\""};
    for (const double number : numbers) {
        if (kind == "normal") break;
        if (!is_in_range(number)) throw WrongDraw{kind, "leaves the range of this key"};
        if (whole && number != std::floor(number)) throw WrongDraw{kind, "must contain whole numbers only"};
    }
    Random random(seed, stream_of(key));
    if (kind == "uniform") return draw_uniform(numbers, whole, random);
    if (kind == "normal") return draw_normal(numbers, random, is_in_range) + 0.0;
    return numbers[static_cast<std::size_t>(random.unit() * static_cast<double>(numbers.size()))];
}

}  // namespace tumble::scene

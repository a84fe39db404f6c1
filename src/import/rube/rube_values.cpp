// A missing value is its default; a present value of the wrong type is an error.
#include "import/rube/rube_values.hpp"

#include <algorithm>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <optional>

#include "scene/json/json_text.hpp"
#include "scene/json/pointer.hpp"

namespace tumble::scene {

namespace {

constexpr std::size_t kHexDigits = 8;
const Json kNothing = Json::object();

// The binary32 number whose bit pattern the 8 hexadecimal digits state.
std::optional<double> hex_float(const std::string& text) {
    std::uint32_t bits = 0;
    const char* end = text.data() + text.size();
    const std::from_chars_result parsed = std::from_chars(text.data(), end, bits, 16);
    if (text.size() != kHexDigits || parsed.ec != std::errc{} || parsed.ptr != end) return std::nullopt;
    return std::bit_cast<float>(bits);
}

}  // namespace

ImportNote& RubeNotes::note_of(const std::string& feature) {
    const auto found = std::ranges::find(notes_, feature, &ImportNote::feature);
    return found != notes_.end() ? *found : notes_.emplace_back(ImportNote{feature});
}

void RubeNotes::add(const std::string& feature, int count) { note_of(feature).count += count; }

void RubeNotes::add_of(const std::string& owner, const std::string& feature, int count) {
    ImportNote& note = note_of(feature);
    note.count += count;
    if (note.owners.size() < ImportNote::kMostOwners && std::ranges::find(note.owners, owner) == note.owners.end())
        note.owners.push_back(owner);
}

RubeObject::RubeObject(const Json& value, std::string pointer, Diagnostics& diagnostics)
    : value_(value.is_object() ? value : kNothing), pointer_(std::move(pointer)), diagnostics_(diagnostics) {
    if (!value.is_object()) error(pointer_, "an object", value);
}

std::string RubeObject::pointer_to(std::string_view key) const { return append_key(pointer_, key); }

double RubeObject::number(std::string_view key, double missing, const Range& range) {
    const Json* value = find(key);
    return value ? to_number(*value, pointer_to(key), range) : missing;
}

bool RubeObject::flag(std::string_view key, bool missing) {
    const Json* value = find(key);
    if (value == nullptr) return missing;
    if (value->is_boolean()) return value->get<bool>();
    error(pointer_to(key), "true or false", *value);
    return missing;
}

std::string RubeObject::text(std::string_view key) {
    const Json* value = find(key);
    if (value == nullptr) return {};
    if (value->is_string()) return value->get<std::string>();
    error(pointer_to(key), "a string", *value);
    return {};
}

DVec2 RubeObject::vector(std::string_view key, const Range& range) {
    const Json* value = find(key);
    if (value == nullptr || (value->is_number() && *value == 0)) return {};
    if (!value->is_object()) {
        error(pointer_to(key), "a vector {\"x\": , \"y\": } or 0", *value);
        return {};
    }
    RubeObject components(*value, pointer_to(key), diagnostics_);
    return {components.number("x", 0.0, range), components.number("y", 0.0, range)};
}

std::vector<DVec2> RubeObject::points(std::string_view key) {
    const Json* value = find(key);
    if (value == nullptr) return {};
    const std::string here = pointer_to(key);
    const bool has_lists = value->is_object() && value->contains("x") && value->contains("y") &&
                           value->at("x").is_array() && value->at("y").is_array();
    if (!has_lists || value->at("x").size() != value->at("y").size()) {
        error(here, "points {\"x\": [...], \"y\": [...]}, as many of each", *value);
        return {};
    }
    std::vector<DVec2> points;
    for (std::size_t i = 0; i < value->at("x").size(); ++i) {
        const std::string index = std::to_string(i);
        points.emplace_back(to_number(value->at("x")[i], here + "/x/" + index, kCoordinate),
                            to_number(value->at("y")[i], here + "/y/" + index, kCoordinate));
    }
    return points;
}

std::string RubeObject::custom(std::initializer_list<std::string_view> keys) {
    Json kept = Json::object();
    for (const std::string_view key : keys)
        if (const Json* value = find(key); value && *value != "") kept[std::string(key)] = *value;
    return kept.empty() ? std::string() : compact_text(kept);
}

RubeObject RubeObject::object(std::string_view key) {
    const Json* value = find(key);
    return {value ? *value : kNothing, pointer_to(key), diagnostics_};
}

std::vector<RubeObject> RubeObject::list(std::string_view key) {
    const Json* value = find(key);
    std::vector<RubeObject> elements;
    if (value == nullptr) return elements;
    if (!value->is_array()) {
        error(pointer_to(key), "an array", *value);
        return elements;
    }
    for (std::size_t i = 0; i < value->size(); ++i)
        elements.emplace_back((*value)[i], pointer_to(key) + '/' + std::to_string(i), diagnostics_);
    return elements;
}

int RubeObject::index(std::string_view key, std::size_t end, const std::string& of) {
    const Json* value = find(key);
    const double number = value ? to_number(*value, pointer_to(key), kForce) : 0.0;
    if (number >= 0.0 && number < static_cast<double>(end) && number == std::floor(number))
        return static_cast<int>(number);
    error(pointer_to(key), "the index of one of " + std::to_string(end) + " " + of, value ? *value : Json(0));
    return -1;
}

void RubeObject::skip(std::initializer_list<std::string_view> keys) { read_.insert(keys.begin(), keys.end()); }

// Warnings of exports are not among those that `tumble explain` knows: they have no code.
constexpr std::string_view kNoCode;

void RubeObject::warn(std::string_view key, std::string message, std::string hint) {
    diagnostics_.warning(kNoCode, pointer_to(key), std::move(message), std::move(hint));
}

void RubeObject::note_unread(const std::string& kind, RubeNotes& notes) const {
    for (const auto& [key, value] : value_.items())
        if (!read_.contains(key)) notes.add(kind + " key '" + key + "'");
}

const Json* RubeObject::find(std::string_view key) {
    read_.emplace(key);
    const auto found = value_.find(key);
    return found == value_.end() ? nullptr : &*found;
}

double RubeObject::to_number(const Json& value, const std::string& pointer, const Range& range) {
    std::optional<double> number;
    if (value.is_number()) number = value.get<double>();
    if (value.is_string()) number = hex_float(value.get_ref<const std::string&>());
    const bool is_finite = number && std::isfinite(*number);
    if (is_finite && *number >= range.min && *number <= range.max) return *number + 0.0;  // + 0.0 turns -0 into 0
    error(pointer,
          !is_finite            ? "a finite number, or one as 8 hexadecimal digits"
          : *number < range.min ? "at least " + number_text(range.min)
                                : "at most " + number_text(range.max),
          value);
    return 0.0;
}

void RubeObject::error(const std::string& pointer, const std::string& wanted, const Json& got) {
    diagnostics_.error(pointer, "must be " + wanted + ", got " + describe(got));
}

}  // namespace tumble::scene

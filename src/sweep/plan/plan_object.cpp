#include "sweep/plan/plan_object.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "scene/json/json_text.hpp"
#include "scene/json/pointer.hpp"
#include "tumble/suggest.hpp"

namespace tumble::sweep {

namespace {

constexpr std::size_t kMostValues = 100000;  // of a list

}  // namespace

PlanObject::PlanObject(const scene::Json& value, std::string pointer, scene::Diagnostics& diagnostics)
    : value_(value), pointer_(std::move(pointer)), diagnostics_(diagnostics) {
    if (!value.is_object())
        diagnostics_.error(
            pointer_, "must be an object, got " + scene::describe(value),
            value.is_boolean() ? "{} asks for it with all defaults; without the key it is left out" : "");
}

void PlanObject::finish() {
    if (!value_.is_object()) return;
    for (const auto& [key, unused] : value_.items())
        if (std::ranges::find(known_, key) == known_.end())
            diagnostics_.error(pointer_to(key), "unknown key \"" + key + "\"", suggestion(key, known_),
                               scene::Diagnostics::At::key);
}

const scene::Json* PlanObject::find(std::string_view key) {
    if (std::ranges::find(known_, key) == known_.end()) known_.push_back(key);
    if (!value_.is_object()) return nullptr;
    const auto found = value_.find(std::string(key));
    return found == value_.end() ? nullptr : &*found;
}

bool PlanObject::has(std::string_view key) { return find(key) != nullptr; }

std::string PlanObject::pointer_to(std::string_view key) const { return scene::append_key(pointer_, key); }

void PlanObject::error(std::string_view key, const std::string& message, const std::string& hint) const {
    diagnostics_.error(key.empty() ? pointer_ : pointer_to(key), message, hint);
}

bool PlanObject::flag(std::string_view key, bool otherwise) {
    const scene::Json* const value = find(key);
    if (value == nullptr) return otherwise;
    if (value->is_boolean()) return value->get<bool>();
    error(key, "must be true or false, got " + scene::describe(*value));
    return otherwise;
}

std::string PlanObject::text(std::string_view key, std::string otherwise) {
    const scene::Json* const value = find(key);
    if (value == nullptr) return otherwise;
    if (value->is_string()) return value->get<std::string>();
    error(key, "must be a string, got " + scene::describe(*value));
    return otherwise;
}

double PlanObject::number(std::string_view key, double lowest, double highest, double otherwise) {
    const scene::Json* const value = find(key);
    if (value == nullptr) return otherwise;
    if (value->is_number() && value->get<double>() >= lowest && value->get<double>() <= highest)
        return value->get<double>();
    error(key, "must be a number from " + scene::number_text(lowest) + " to " + scene::number_text(highest) + ", got " +
                   scene::describe(*value));
    return otherwise;
}

std::uint64_t PlanObject::whole(std::string_view key, std::uint64_t lowest, std::uint64_t highest,
                                std::uint64_t otherwise) {
    const scene::Json* const value = find(key);
    if (value == nullptr) return otherwise;
    if (value->is_number_unsigned()) {
        const auto number = value->get<std::uint64_t>();
        if (number >= lowest && number <= highest) return number;
    }
    error(key, "must be a whole number from " + std::to_string(lowest) + " to " + std::to_string(highest) + ", got " +
                   scene::describe(*value));
    return otherwise;
}

std::optional<std::pair<double, double>> PlanObject::pair(std::string_view key) {
    const scene::Json* const value = find(key);
    if (value == nullptr) return std::nullopt;
    if (value->is_array() && value->size() == 2 && (*value)[0].is_number() && (*value)[1].is_number())
        return std::pair((*value)[0].get<double>(), (*value)[1].get<double>());
    error(key, "must be an array of 2 numbers, got " + scene::describe(*value));
    return std::nullopt;
}

std::vector<std::string> PlanObject::values(std::string_view key) {
    std::vector<std::string> values;
    const scene::Json* const value = find(key);
    if (value == nullptr) return values;
    if (!value->is_array() || value->empty() || value->size() > kMostValues) {
        error(key,
              "must be an array of 1 to " + std::to_string(kMostValues) + " values, got " + scene::describe(*value));
        return values;
    }
    for (const scene::Json& element : *value) values.push_back(scene::compact_text(element));
    return values;
}

std::vector<std::string> PlanObject::texts(std::string_view key) {
    const scene::Json* const value = find(key);
    if (value == nullptr) return {};
    if (value->is_string()) return {value->get<std::string>()};
    std::vector<std::string> texts;
    if (value->is_array())
        for (const scene::Json& element : *value)
            if (element.is_string()) texts.push_back(element.get<std::string>());
    if (texts.empty() || texts.size() != value->size())
        error(key, "must be a string or an array of strings, got " + scene::describe(*value));
    return texts;
}

std::string PlanObject::word(std::string_view key, const std::vector<std::string_view>& words) {
    std::string found = text(key, std::string(words.front()));
    if (std::ranges::find(words, found) != words.end()) return found;
    error(key, "must be one of " + join_words(words) + ", got " + scene::quoted(found), suggestion(found, words));
    return std::string(words.front());
}

}  // namespace tumble::sweep

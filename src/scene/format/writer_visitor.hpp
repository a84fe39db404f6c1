// The visitor of the table in fields.hpp that writes. The schema uses it too, for the defaults that it shows.
#pragma once

#include <concepts>
#include <map>
#include <span>
#include <stdexcept>
#include <string>
#include <type_traits>

#include "scene/format/fields.hpp"
#include "scene/json/json.hpp"
#include "scene/json/pointer.hpp"

namespace tumble::scene {

class Writer {
public:
    // Numbers that were drawn are written as they were declared, unless they have been changed since.
    explicit Writer(bool with_defaults, std::span<const SceneDraw> draws = {}) : with_defaults_(with_defaults) {
        for (const SceneDraw& draw : draws)
            if (!draw.pointer.empty()) draws_.emplace(draw.pointer, &draw);
    }

    Json write(double value, const Location& at = {}) const { return declared(value, value, at); }
    Json write(bool value, const Location& = {}) const { return value; }
    Json write(std::integral auto value, const Location& at = {}) const {
        return declared(value, static_cast<double>(value), at);
    }
    Json write(const std::string& value, const Location& = {}) const { return value; }
    Json write(DVec2 value, const Location& at = {}) const { return pair(value.x, value.y, at); }
    Json write(const SceneInterval& value, const Location& at = {}) const { return pair(value.lower, value.upper, at); }

    template <class Enum>
    requires std::is_enum_v<Enum> Json write(Enum value, const Location& = {})
    const { return enum_name(value); }

    template <class First, class Second>
    Json write(const std::pair<First, Second>& value, const Location& at = {}) const {
        return pair(value.first, value.second, at);
    }

    template <class T>
    Json write(const std::optional<T>& value, const Location& at = {}) const {
        return value ? write(*value, at) : Json();
    }

    template <class T>
    Json write(const std::vector<T>& value, const Location& at = {}) const {
        Json array = Json::array();
        for (const T& element : value) array.push_back(write(element, child(at, array.size())));
        return array;
    }

    template <class... T>
    Json write(const std::variant<T...>& value, const Location& at = {}) const;

    template <class T>
    requires std::is_class_v<T> Json write(const T& value, const Location& at = {})
    const;

    bool with_defaults() const { return with_defaults_; }

private:
    template <class First, class Second>
    Json pair(const First& first, const Second& second, const Location& at) const {
        return Json::array({write(first, child(at, 0)), write(second, child(at, 1))});
    }

    Json declared(const Json& written, double value, const Location& at) const {
        if (draws_.empty() || at.parent == nullptr) return written;
        const auto found = draws_.find(pointer_to(at));
        if (found == draws_.end() || found->second->value != value) return written;
        return Json::parse(found->second->declaration);
    }

    bool with_defaults_ = false;
    std::map<std::string, const SceneDraw*> draws_;  // by pointer
};

template <class T>
class ObjectWriter {
public:
    ObjectWriter(const Writer& writer, const T& value, const Location& at) : writer_(writer), value_(value), at_(at) {}

    void field(const Field& field, auto T::*member) {
        put(field, writer_.write(value_.*member, child(at_, field.name)), writer_.write(defaults_.*member));
    }

    void pair(const Field& field, std::string T::*first, std::string T::*second) {
        if ((value_.*first).empty() && (value_.*second).empty()) return;
        object[std::string(field.name)] = Json::array({value_.*first, value_.*second});
    }

    template <class Element>
    void named(const Field& field, std::vector<Element> T::*member) {
        Json elements = Json::object();
        const Location at = child(at_, field.name);
        for (const Element& element : value_.*member)
            elements[element.name] = writer_.write(element, child(at, element.name));
        put(field, std::move(elements), Json::object());
    }

    void json(const Field& field, std::string T::*member) {
        const std::string& text = value_.*member;
        if (text.empty()) return;
        Json value = Json::parse(text, nullptr, false);
        if (value.is_discarded()) throw std::invalid_argument(std::string(field.name) + " is not JSON: " + text);
        object[std::string(field.name)] = std::move(value);
    }

    void constant(const Field& field, int number) { object[std::string(field.name)] = number; }

    template <class Variant>
    void one_of(const Field&, Variant T::*member) {
        object.update(writer_.write(value_.*member, at_));
    }

    void exactly_one(std::initializer_list<std::string_view>) {}
    void at_most_one(std::string_view, std::string_view) {}

    Json object = Json::object();

private:
    void put(const Field& field, Json value, const Json& default_value) {
        if (value.is_null()) return;
        const bool shown = writer_.with_defaults() && value != "";  // an empty text means that there is none
        if (field.required || shown || value != default_value) object[std::string(field.name)] = std::move(value);
    }

    const Writer& writer_;
    const T& value_;
    const Location& at_;
    const T defaults_{};
};

template <class... T>
Json Writer::write(const std::variant<T...>& value, const Location& at) const {
    const std::string key(alternative_name(value));
    return {{key, std::visit([&](const auto& held) { return write(held, child(at, key)); }, value)}};
}

template <class T>
requires std::is_class_v<T> Json Writer::write(const T& value, const Location& at)
const {
    ObjectWriter<T> object(*this, value, at);
    visit_fields(object, Type<T>{});
    return std::move(object.object);
}

}  // namespace tumble::scene

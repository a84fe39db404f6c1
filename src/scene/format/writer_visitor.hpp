// The visitor of the table in fields.hpp that writes. The schema uses it too, for the defaults that it shows.
#pragma once

#include <concepts>
#include <stdexcept>
#include <type_traits>

#include "scene/format/fields.hpp"
#include "scene/json/json.hpp"

namespace tumble::scene {

class Writer {
public:
    explicit Writer(bool with_defaults) : with_defaults_(with_defaults) {}

    Json write(double value) const { return value; }
    Json write(bool value) const { return value; }
    Json write(std::integral auto value) const { return value; }
    Json write(const std::string& value) const { return value; }
    Json write(DVec2 value) const { return Json::array({value.x, value.y}); }
    Json write(const SceneInterval& value) const { return Json::array({value.lower, value.upper}); }

    template <class Enum>
    requires std::is_enum_v<Enum> Json write(Enum value)
    const { return enum_name(value); }

    template <class First, class Second>
    Json write(const std::pair<First, Second>& value) const {
        return Json::array({write(value.first), write(value.second)});
    }

    template <class T>
    Json write(const std::optional<T>& value) const {
        return value ? write(*value) : Json();
    }

    template <class T>
    Json write(const std::vector<T>& value) const {
        Json array = Json::array();
        for (const T& element : value) array.push_back(write(element));
        return array;
    }

    template <class... T>
    Json write(const std::variant<T...>& value) const;

    template <class T>
    requires std::is_class_v<T> Json write(const T& value)
    const;

    bool with_defaults() const { return with_defaults_; }

private:
    bool with_defaults_ = false;
};

template <class T>
class ObjectWriter {
public:
    ObjectWriter(const Writer& writer, const T& value) : writer_(writer), value_(value) {}

    void field(const Field& field, auto T::*member) {
        put(field, writer_.write(value_.*member), writer_.write(defaults_.*member));
    }

    void pair(const Field& field, std::string T::*first, std::string T::*second) {
        if ((value_.*first).empty() && (value_.*second).empty()) return;
        object[std::string(field.name)] = Json::array({value_.*first, value_.*second});
    }

    template <class Element>
    void named(const Field& field, std::vector<Element> T::*member) {
        Json elements = Json::object();
        for (const Element& element : value_.*member) elements[element.name] = writer_.write(element);
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
        object.update(writer_.write(value_.*member));
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
    const T defaults_{};
};

template <class... T>
Json Writer::write(const std::variant<T...>& value) const {
    const std::string key(alternative_name(value));
    return {{key, std::visit([&](const auto& held) { return write(held); }, value)}};
}

template <class T>
requires std::is_class_v<T> Json Writer::write(const T& value)
const {
    ObjectWriter<T> object(*this, value);
    visit_fields(object, Type<T>{});
    return std::move(object.object);
}

}  // namespace tumble::scene

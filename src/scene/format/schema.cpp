// The JSON schema (Draft-07), the third visitor of the table. It expresses what the reader checks field by field, but
// not that names must exist or that shapes must not be degenerate.
#include <concepts>
#include <type_traits>

#include "scene/format/fields.hpp"
#include "scene/format/writer_visitor.hpp"
#include "scene/json/json.hpp"
#include "scene/json/json_text.hpp"

namespace tumble {

namespace scene {

namespace {

// "linear_damping" as a title: "Linear damping".
std::string title_of(std::string_view name) {
    std::string title(name.substr(name.starts_with('$') ? 1 : 0));
    std::replace(title.begin(), title.end(), '_', ' ');
    if (!title.empty() && title[0] >= 'a' && title[0] <= 'z') title[0] = static_cast<char>(title[0] - 'a' + 'A');
    return title;
}

Json number_schema(std::string_view type, const Range& range) {
    Json schema{{"type", type}};
    schema[range.above_min ? "exclusiveMinimum" : "minimum"] = range.min;
    schema["maximum"] = range.max;
    return schema;
}

// A number, or a declaration of a random one.
Json drawable(const Json& number) { return {{"oneOf", Json::array({number, Json{{"$ref", "#/definitions/random"}}})}}; }

Json random_schema() {
    const auto list = [](const char* title, const char* description, int least, int most) -> Json {
        return {{"title", title},    {"description", description},
                {"type", "array"},   {"items", {{"type", "number"}}},
                {"minItems", least}, {"maxItems", most}};
    };
    Json schema{{"type", "object"}, {"additionalProperties", false}};
    schema["properties"]["uniform"] = list("Uniform", "Lower and upper end of equally likely numbers.", 2, 2);
    schema["properties"]["normal"] = list("Normal", "Mean and standard deviation.", 2, 2);
    schema["properties"]["choice"] = list("Choice", "Equally likely numbers.", 1, 1000);
    for (const char* key : {"uniform", "normal", "choice"})
        schema["allOf"][0]["oneOf"].push_back({{"required", Json::array({key})}});
    return schema;
}

Json pair_schema(const Json& element) {
    return {{"type", "array"}, {"items", element}, {"minItems", 2}, {"maxItems", 2}};
}

// The schema of a value of a type, by overloads on a pointer to it.
class Schema {
public:
    Json of(const double*, const Field& field) { return drawable(number_schema("number", field.range)); }
    Json of(const bool*, const Field&) { return {{"type", "boolean"}}; }
    Json of(const std::integral auto*, const Field& field) {
        const Json number = number_schema("integer", field.range);
        return field.range.max == kSeed.max ? number : drawable(number);
    }
    Json of(const DVec2*, const Field& field) { return pair_schema(drawable(number_schema("number", field.range))); }
    Json of(const SceneInterval*, const Field& field) {
        return pair_schema(drawable(number_schema("number", field.range)));
    }

    Json of(const std::string*, const Field& field) {
        Json schema{{"type", "string"}};
        if (field.text == Text::name || field.text == Text::expression || field.text == Text::caption)
            schema["minLength"] = 1;
        if (field.text == Text::hash) schema["pattern"] = "^[0-9a-f]{16}$";
        if (field.text == Text::png_file) schema["pattern"] = "\\.png$";
        if (field.text == Text::color) schema["pattern"] = "^#([0-9a-fA-F]{3}|[0-9a-fA-F]{6})$";
        return schema;
    }

    template <class Enum>
    requires std::is_enum_v<Enum> Json of(const Enum*, const Field&) {
        Json names = Json::array();
        for (const auto& [enumerator, name] : kEnumNames<Enum>) names.push_back(name);
        return {{"enum", names}};
    }

    template <class T>
    Json of(const std::pair<T, T>*, const Field& field) {
        return pair_schema(of(static_cast<const T*>(nullptr), field));
    }

    template <class T>
    Json of(const std::optional<T>*, const Field& field) {
        return of(static_cast<const T*>(nullptr), field);
    }

    template <class T>
    Json of(const std::vector<T>*, const Field& field) {
        Json schema{{"type", "array"}, {"items", of(static_cast<const T*>(nullptr), field)}};
        if (field.min_items > 0) schema["minItems"] = field.min_items;
        schema["maxItems"] = field.max_items;
        return schema;
    }

    template <class... T>
    Json of(const std::variant<T...>*, const Field&);

    // By reference, because bodies occur twice: in the list of bodies and as spawned bodies in the timeline.
    Json of(const SceneBody*, const Field&) { return {{"$ref", "#/definitions/body"}}; }

    template <class T>
    requires std::is_class_v<T> Json of(const T*, const Field&) { return object<T>(); }

    template <class T>
    Json object();
};

template <class T>
class ObjectSchema {
public:
    explicit ObjectSchema(Schema& schema) : schema_(schema) {}

    template <class Member>
    void field(const Field& field, Member T::*member) {
        const Json value = Writer(false).write(defaults_.*member);
        const bool has_default = !field.required && value != "";
        add(field, schema_.of(static_cast<const Member*>(nullptr), field), has_default ? value : Json());
    }

    void pair(const Field& field, std::string T::*, std::string T::*) {
        add(field, pair_schema(schema_.of(static_cast<const std::string*>(nullptr), field)), Json());
    }

    template <class Element>
    void named(const Field& field, std::vector<Element> T::*) {
        const Json element = schema_.of(static_cast<const Element*>(nullptr), field);
        add(field, {{"type", "object"}, {"additionalProperties", element}}, Json::object());
    }

    void json(const Field& field, std::string T::*) { add(field, Json::object(), Json()); }

    void constant(const Field& field, int number) { add(field, {{"const", number}}, Json()); }

    template <class Variant>
    void one_of(const Field&, Variant T::*) {
        Alternatives alternatives{*this, Json::array()};
        visit_alternatives(alternatives, Type<Variant>{});
        exclusive_.push_back(alternatives.keys);
    }

    void exactly_one(std::initializer_list<std::string_view> names) {
        Json keys = Json::array();
        for (const std::string_view name : names) keys.push_back(name);
        exclusive_.push_back(keys);
    }

    void at_most_one(std::string_view first, std::string_view second) {
        const Json keys{first, second};
        not_together_.push_back(keys);
    }

    Json finish() const {
        Json schema{{"type", "object"}, {"properties", properties_}, {"additionalProperties", false}};
        if (!required_.empty()) schema["required"] = required_;
        for (const Json& keys : exclusive_) {
            Json choices = Json::array();
            for (const Json& key : keys) choices.push_back({{"required", Json::array({key})}});
            schema["allOf"].push_back({{"oneOf", choices}});
        }
        for (const Json& keys : not_together_) schema["allOf"].push_back({{"not", {{"required", keys}}}});
        return schema;
    }

private:
    struct Alternatives {
        ObjectSchema& object;
        Json keys;

        template <class Alternative>
        void alternative(std::string_view name, std::string_view description) {
            keys.push_back(name);
            object.add({.name = name, .description = description},
                       object.schema_.of(static_cast<const Alternative*>(nullptr), Field{}), Json());
        }
    };

    void add(const Field& field, const Json& schema, const Json& default_value) {
        Json property{{"title", title_of(field.name)}, {"description", field.description}};
        if (!field.unit.empty()) {
            property["description"] = std::string(field.description) + " Unit: " + std::string(field.unit) + ".";
            property["unit"] = field.unit;
        }
        if (!default_value.is_null()) property["default"] = default_value;
        if (schema.contains("$ref"))
            property["allOf"].push_back(schema);  // $ref hides its siblings
        else
            property.update(schema);
        properties_[std::string(field.name)] = property;
        if (field.required) required_.push_back(field.name);
    }

    Schema& schema_;
    const T defaults_{};
    Json properties_ = Json::object();
    Json required_ = Json::array();
    Json exclusive_ = Json::array();
    Json not_together_ = Json::array();  // pairs of keys
};

template <class T>
Json Schema::object() {
    ObjectSchema<T> object(*this);
    visit_fields(object, Type<T>{});
    return object.finish();
}

template <class... T>
Json Schema::of(const std::variant<T...>*, const Field&) {
    using Variant = std::variant<T...>;
    struct Holder {
        Variant variant;
    };
    ObjectSchema<Holder> object(*this);
    object.one_of({}, &Holder::variant);
    return object.finish();
}

}  // namespace

}  // namespace scene

std::string scene_schema() {
    scene::Schema types;
    scene::Json schema{
        {"$schema", "http://json-schema.org/draft-07/schema#"},
        {"title", "Scene of tumble, format 1"},
        {"description", "A 2D rigid-body world, its camera and its run. SI units, y up, angles in degrees."}};
    schema.update(types.object<Scene>());
    schema["definitions"]["body"] = types.object<SceneBody>();
    schema["definitions"]["random"] = scene::random_schema();
    return scene::pretty_text(schema);
}

}  // namespace tumble

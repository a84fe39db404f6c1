// The reader and the published schema agree: every wrong value that can be derived from the schema's description of a
// field is refused by both, and both ends of its range are accepted by both.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <set>

#include "scene/every_field.hpp"
#include "scene/schema_validator.hpp"
#include "tumble/scene_file.hpp"

using namespace tumble;
using nlohmann::json;

namespace {

// A document with one changed value, and the pointer at which the reader must report an error.
struct Mutation {
    json document;
    std::string pointer;
};

// A value of a document and the part of the schema that describes it.
struct Described {
    std::string pointer;
    const json* schema = nullptr;
    std::string schema_name;  // unique, "$ref" followed
};

class Walk {
public:
    Walk(const json& schema, const json& document) : root_(schema), document_(document) { descend("", root_, "#"); }

    const std::vector<Described>& values() const { return values_; }

private:
    void descend(const std::string& pointer, const json& schema, const std::string& name) {
        const json* reference = schema.contains("$ref") ? &schema["$ref"] : nullptr;
        if (schema.contains("allOf") && schema["allOf"][0].contains("$ref")) reference = &schema["allOf"][0]["$ref"];
        if (reference != nullptr) {
            const std::string target = reference->get<std::string>();
            return descend(pointer, root_.at(json::json_pointer(target.substr(1))), target);
        }
        // A number or a declaration of a random one.
        if (schema.contains("oneOf") && schema["oneOf"][0].contains("type"))
            return descend(pointer, schema["oneOf"][0], name);
        values_.push_back({pointer, &schema, name});
        const json& value = document_.at(json::json_pointer(pointer));
        if (value.is_object() && schema.contains("additionalProperties")) {
            for (const auto& [key, member] : value.items()) {
                const bool known = schema.contains("properties") && schema["properties"].contains(key);
                descend(pointer + "/" + key, known ? schema["properties"][key] : schema["additionalProperties"],
                        name + (known ? "/properties/" + key : "/additionalProperties"));
            }
        } else if (value.is_array() && schema.contains("items")) {
            for (std::size_t i = 0; i < value.size(); ++i)
                descend(pointer + "/" + std::to_string(i), schema["items"], name + "/items");
        }
    }

    const json& root_;
    const json& document_;
    std::vector<Described> values_;
};

class Mutator {
public:
    Mutator(const json& document, const Described& described)
        : document_(document), described_(described), schema_(*described.schema) {
        const std::string type = schema_.value("type", "");
        if (type == "number" || type == "integer") add_numbers(type == "integer");
        if (type == "boolean") add_values({1, "true", nullptr});
        if (type == "string") add_values({5, nullptr, json::array()});
        if (type == "object") add_objects();
        if (type == "array") add_arrays();
        if (schema_.contains("minLength")) add_value("");
        if (schema_.contains("pattern")) add_values({"red", "#12", "#12345g"});
        if (schema_.contains("enum")) add_values({"no_such_word", 0, nullptr});
        if (schema_.contains("const")) add_values({2, "1", nullptr});
    }

    std::vector<Mutation> wrong;
    std::vector<Mutation> right;  // no range error may be reported

private:
    void add(std::vector<Mutation>& list, const std::string& pointer, const std::string& reported_at,
             const json& value) {
        list.push_back({document_, reported_at});
        list.back().document[json::json_pointer(pointer)] = value;
    }
    void add_value(const json& value) { add(wrong, described_.pointer, described_.pointer, value); }
    void add_values(const std::vector<json>& values) {
        for (const json& value : values) add_value(value);
    }

    void add_numbers(bool whole) {
        add_values({"1", nullptr, true, json::array({1}), json::object()});
        const bool is_open = schema_.contains("exclusiveMinimum");
        const double min = schema_[is_open ? "exclusiveMinimum" : "minimum"], max = schema_["maximum"];
        add_value(is_open ? min : min - std::max(1.0, std::abs(min)));
        add_value(2.0 * max);
        if (whole) add_value(1.5);
        if (max >= 0x1p64) return;  // a double cannot represent the largest seed
        add(right, described_.pointer, described_.pointer, whole ? json(static_cast<std::int64_t>(max)) : json(max));
        if (!is_open)
            add(right, described_.pointer, described_.pointer,
                whole ? json(static_cast<std::int64_t>(min)) : json(min));
    }

    void add_objects() {
        add_values({json::array(), "x", 1, nullptr});
        if (schema_["additionalProperties"].is_boolean())
            add(wrong, described_.pointer + "/no_such_key", described_.pointer + "/no_such_key", 1);
        const json required = schema_.value("required", json::array());
        for (const json& key : required) {
            wrong.push_back({document_, described_.pointer});
            wrong.back().document.at(json::json_pointer(described_.pointer)).erase(key.get<std::string>());
        }
    }

    void add_arrays() {
        add_values({json::object(), "x", 1, nullptr});
        const json& value = document_.at(json::json_pointer(described_.pointer));
        const std::size_t least = schema_.value("minItems", std::size_t{0}),
                          most = schema_.value("maxItems", std::size_t{65535});
        json changed = value;
        if (least > 0) {
            while (changed.size() >= least) changed.erase(changed.size() - 1);
            add_value(changed);
        }
        if (most > 2) return;
        for (changed = value; changed.size() <= most;) changed.push_back(value[0]);
        add_value(changed);
    }

    const json& document_;
    const Described& described_;
    const json& schema_;
};

LoadOptions with_part() {
    LoadOptions options;
    options.read_included = [](const std::filesystem::path&) { return R"({"format": 1})"; };
    return options;
}

std::vector<Diagnostic> errors_of_mutated(const std::string& text) {
    try {
        parse_scene(text, "mutated.json", with_part());
    } catch (const SceneError& error) {
        return error.diagnostics;
    }
    return {};
}

bool is_reported_at(const std::vector<Diagnostic>& errors, const std::string& pointer) {
    return std::ranges::any_of(errors,
                               [&](const Diagnostic& error) { return error.pointer == pointer && error.line > 0; });
}

// Collects the names of all properties of the schema.
void collect_names(const json& schema, const std::string& name, std::set<std::string>& names) {
    const json properties = schema.value("properties", json::object());
    for (const auto& [key, property] : properties.items()) {
        const bool refers = property.contains("allOf") && property["allOf"][0].contains("$ref");
        if (!refers) names.insert(name + "/properties/" + key);
        collect_names(property, name + "/properties/" + key, names);
    }
    for (const char* inner : {"items", "additionalProperties"})
        if (schema.contains(inner) && schema[inner].is_object())
            collect_names(schema[inner], name + "/" + inner, names);
}

}  // namespace

TEST_CASE("wrong values of every field are refused by the reader, at their location, and by the schema") {
    test::SchemaValidator schema;
    std::set<std::string> done;
    int wrong = 0, right = 0;
    for (const std::string& text : test::scenes_with_every_field()) {
        const json document = json::parse(text);
        CAPTURE(text);
        REQUIRE(errors_of_mutated(text).empty());
        REQUIRE(schema.accepts(document));
        const Walk walk(schema.document(), document);
        for (const Described& described : walk.values()) {
            if (!done.insert(described.schema_name).second) continue;
            const Mutator mutator(document, described);
            for (const Mutation& mutation : mutator.wrong) {
                const std::string bad = mutation.document.dump();
                CHECK_MESSAGE(!schema.accepts(mutation.document), "the schema accepts ", bad);
                CHECK_MESSAGE(is_reported_at(errors_of_mutated(bad), mutation.pointer), mutation.pointer,
                              " is not refused in ", bad);
                ++wrong;
            }
            for (const Mutation& mutation : mutator.right) {
                const std::string good = mutation.document.dump();
                CHECK_MESSAGE(schema.accepts(mutation.document), "the schema refuses ", good);
                for (const Diagnostic& error : errors_of_mutated(good))
                    CHECK_MESSAGE(error.message.find("must be at") == std::string::npos, to_string(error));
                ++right;
            }
        }
    }
    std::set<std::string> all;
    collect_names(schema.document(), "#", all);
    collect_names(schema.document()["definitions"]["body"], "#/definitions/body", all);
    for (const std::string& name : all) CHECK_MESSAGE(done.contains(name), name, " is in none of the scenes");
    CHECK(wrong > 1300);
    CHECK(right > 190);
}

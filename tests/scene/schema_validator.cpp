// RapidJSON validates Draft-04, the scene schema is Draft-07: the few keywords that differ are translated first.
#include "scene/schema_validator.hpp"

#include <rapidjson/document.h>
#include <rapidjson/error/en.h>
#include <rapidjson/reader.h>
#include <rapidjson/schema.h>

#include <set>
#include <stdexcept>

#include "tumble/scene_file.hpp"

namespace tumble::test {

using nlohmann::json;

namespace {

json in_draft_04(const json& schema);

json each_in_draft_04(const json& schemas) {
    json result = schemas;
    for (json& schema : result) schema = in_draft_04(schema);
    return result;
}

// A `const` becomes an `enum` of one value, an exclusive minimum becomes a minimum with a flag.
json in_draft_04(const json& schema) {
    static const std::set<std::string> same{"type",    "enum",     "minimum",  "maximum",  "minLength",
                                            "pattern", "minItems", "maxItems", "required", "$ref"};
    static const std::set<std::string> of_one_schema{"items", "additionalProperties", "not"};
    static const std::set<std::string> of_schemas{"properties", "definitions", "allOf", "oneOf"};
    static const std::set<std::string> annotations{"$schema", "title", "description", "unit", "default"};
    if (schema.is_boolean()) return schema;
    json result = json::object();
    for (const auto& [keyword, value] : schema.items()) {
        if (keyword == "const") {
            result["enum"] = json::array({value});
        } else if (keyword == "exclusiveMinimum") {
            result["minimum"] = value;
            result["exclusiveMinimum"] = true;
        } else if (same.contains(keyword)) {
            result[keyword] = value;
        } else if (of_one_schema.contains(keyword)) {
            result[keyword] = in_draft_04(value);
        } else if (of_schemas.contains(keyword)) {
            result[keyword] = each_in_draft_04(value);
        } else if (!annotations.contains(keyword)) {
            throw std::invalid_argument("RapidJSON does not validate the keyword \"" + keyword + "\"");
        }
    }
    return result;
}

rapidjson::Document parse(const std::string& text) {
    rapidjson::Document document;
    document.Parse(text.c_str());
    return document;
}

}  // namespace

struct SchemaValidator::Compiled {
    explicit Compiled(const json& draft_07) : schema(parse(in_draft_04(draft_07).dump())), validator(schema) {}

    rapidjson::SchemaDocument schema;
    rapidjson::SchemaValidator validator;
};

SchemaValidator::SchemaValidator() : SchemaValidator(json::parse(scene_schema())) {}
SchemaValidator::SchemaValidator(const json& schema)
    : document_(schema), compiled_(std::make_unique<Compiled>(schema)) {}
SchemaValidator::~SchemaValidator() = default;

bool SchemaValidator::accepts(const json& value) {
    rapidjson::SchemaValidator& validator = compiled_->validator;
    validator.Reset();
    const std::string text = value.dump();
    rapidjson::StringStream stream(text.c_str());
    rapidjson::Reader reader;
    const rapidjson::ParseResult parsed = reader.Parse(stream, validator);
    // The validator ends the parse at the first value that it refuses.
    if (parsed.IsError() && parsed.Code() != rapidjson::kParseErrorTermination)
        throw std::invalid_argument(rapidjson::GetParseError_En(parsed.Code()));
    return validator.IsValid();
}

}  // namespace tumble::test
